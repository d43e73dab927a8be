// Sensing and changing what is on the floor.
// SPDX-License-Identifier: MIT
#include "sim/surroundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trellis {
namespace {

double distance(const Roomba& robot, Point place) {
    return std::hypot(place.x - robot.x, place.y - robot.y);
}

bool is_over(const World& world, const Roomba& robot, const Dirt& spot) {
    return distance(robot, spot.centre) <= spot.radius + world.robot.radius;
}

bool is_docked(const World& world, const Roomba& robot) {
    return !world.docks.empty() &&
           distance(robot, world.docks.front().place) <= world.docks.front().reach;
}

void sense_dock(const WalledWorld& world, Roomba& robot) {
    robot.docked = is_docked(world.plan, robot);
    robot.dock_visible = false;
    robot.dock_bearing = 0.0;
    if (world.plan.docks.empty()) return;
    const Dock& dock = world.plan.docks.front();
    const double far = distance(robot, dock.place);
    if (far > dock.range) return;
    const double direction = std::atan2(dock.place.y - robot.y, dock.place.x - robot.x);
    if (world.walls.ray({robot.x, robot.y}, direction, far) < far) return;
    robot.dock_visible = true;
    robot.dock_bearing = std::remainder(direction - robot.rotation, 2.0 * std::numbers::pi);
}

}  // namespace

Surroundings surroundings_of(const World& world) {
    return {.drive = {},
            .battery = world.battery.start,
            .dirt = std::vector<double>(world.dirt.size(), 1.0)};
}

void sense(const WalledWorld& world, const Surroundings& around, Roomba& robot) {
    sense(around.drive, robot);
    const double radius = world.plan.robot.radius;
    // from the disc's rim: there is no wall inside the disc
    const double side = robot.rotation + std::numbers::pi / 2.0;
    const Point rim{robot.x + radius * std::cos(side), robot.y + radius * std::sin(side)};
    robot.wall_distance = world.walls.ray(rim, side, Roomba::farthest_wall);
    robot.battery = around.battery;
    robot.dirt = 0.0;
    for (std::size_t i = 0; i < around.dirt.size(); ++i) {
        if (around.dirt[i] > robot.dirt && is_over(world.plan, robot, world.plan.dirt[i]))
            robot.dirt = around.dirt[i];
    }
    sense_dock(world, robot);
}

void move(const WalledWorld& world, Surroundings& around, Roomba& robot, double dt) {
    move(world.walls, around.drive, robot, dt);
    for (std::size_t i = 0; i < around.dirt.size(); ++i) {
        if (around.dirt[i] > 0.0 && is_over(world.plan, robot, world.plan.dirt[i]))
            around.dirt[i] = std::max(0.0, around.dirt[i] - dt / cleaning_time);
    }
    const Battery& battery = world.plan.battery;
    const double change = is_docked(world.plan, robot) ? dt / battery.charging : -dt / battery.life;
    around.battery = std::clamp(around.battery + change, 0.0, 1.0);
}

}  // namespace trellis
