// Starting a robot in a world of walls.
// SPDX-License-Identifier: MIT
#include "sim/walled_world.h"

#include <algorithm>

namespace trellis {

WalledWorld::WalledWorld(World of)
    : plan(std::move(of)), walls(walls_of(plan), plan.robot.radius, bounds_of(plan)) {}

Roomba at_start(const WalledWorld& world, const Pose& start) {
    return {.x = start.x,
            .y = start.y,
            .rotation = start.rotation,
            .max_linear = world.plan.robot.max_linear,
            .max_angular = world.plan.robot.max_angular};
}

bool fits(const WalledWorld& world, Point place) {
    const auto holds = [&](const Polygon& polygon) { return is_inside(polygon, place); };
    const std::vector<Polygon>& rooms = world.plan.rooms;
    const std::vector<Polygon>& furniture = world.plan.furniture;
    return std::any_of(rooms.begin(), rooms.end(), holds) &&
           std::none_of(furniture.begin(), furniture.end(), holds) &&
           world.walls.nearest(place).distance >= world.walls.radius() - 1e-9;
}

}  // namespace trellis
