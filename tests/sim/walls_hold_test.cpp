// No robot gets through a wall: random velocities at the limits in every world that comes with
// Trellis, each move looked at, and a robot that is pushed into a corner for an hour.
// TRELLIS_TICKS=10000000 looks at so many ticks over all worlds.
// SPDX-License-Identifier: MIT
#include "core/random.h"
#include "sim/bridge/world_file.h"
#include "sim/surroundings.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace trellis {
namespace {

std::uint64_t tick_count() {
    const char* const text = std::getenv("TRELLIS_TICKS");
    return text == nullptr ? 120'000 : std::strtoull(text, nullptr, 10);
}

WalledWorld world_of(const std::filesystem::path& file) {
    const std::string text = test::read_file(TRELLIS_SOURCE_DIR / file);
    Diagnostics diagnostics;
    std::optional<World> world =
        read_world(text, diagnostics.add_file(file.string(), text), diagnostics);
    REQUIRE_MESSAGE(world, diagnostics.render());
    return WalledWorld(std::move(*world));
}

double cross(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether the way of the centre crosses a wall.
bool crosses(const Segment& wall, Point from, Point to) {
    return cross(wall.from, wall.to, from) * cross(wall.from, wall.to, to) < 0.0 &&
           cross(from, to, wall.from) * cross(from, to, wall.to) < 0.0;
}

/// How near the nearest wall is, looking at all of them.
double clearance(const WalledWorld& world, Point place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& wall : world.walls.segments()) {
        const double x = wall.to.x - wall.from.x;
        const double y = wall.to.y - wall.from.y;
        const double squared = x * x + y * y;
        const double part =
            squared == 0.0
                ? 0.0
                : std::clamp(((place.x - wall.from.x) * x + (place.y - wall.from.y) * y) / squared,
                             0.0, 1.0);
        nearest = std::min(nearest, std::hypot(place.x - wall.from.x - part * x,
                                               place.y - wall.from.y - part * y));
    }
    return nearest;
}

bool is_in_a_room(const WalledWorld& world, Point place) {
    return std::any_of(world.plan.rooms.begin(), world.plan.rooms.end(),
                       [&](const Polygon& room) { return is_inside(room, place); });
}

/// Drives at random for so many ticks of `dt`, changing its mind now and then; the number of ticks
/// after which something was wrong.
std::uint64_t faults_in(const WalledWorld& world, std::uint64_t ticks, double dt, Random& random) {
    Roomba robot = at_start(world, world.plan.starts.front());
    Surroundings around = surroundings_of(world.plan);
    std::uint64_t faults = 0;
    for (std::uint64_t i = 0; i < ticks; ++i) {
        if (random.uniform() < 0.02) {
            // the limits themselves more often than anything between
            const double forward = std::clamp(random.uniform(-2.0, 2.0), -1.0, 1.0);
            const double turn = random.uniform() < 0.5 ? 0.0 : random.uniform(-1.0, 1.0);
            robot.set_velocity(forward * robot.max_linear, turn * robot.max_angular);
        }
        const Point before{robot.x, robot.y};
        sense(world, around, robot);
        move(world, around, robot, dt);
        const Point after{robot.x, robot.y};
        // in a long tick it may slide around a corner: the line between both ends is not its way
        const bool through =
            dt < 0.1 &&
            std::any_of(world.walls.segments().begin(), world.walls.segments().end(),
                        [&](const Segment& wall) { return crosses(wall, before, after); });
        const bool sound = std::isfinite(robot.rotation) && !through &&
                           is_in_a_room(world, after) &&
                           clearance(world, after) >= world.plan.robot.radius - 1e-9;
        faults += sound ? 0 : 1;
    }
    return faults;
}

TEST_CASE("walls hold: random velocities at the limits, in all worlds") {
    Random random(3);
    const auto files = test::files_below("sim/worlds", {".json"});
    const std::uint64_t each = tick_count() / files.size() / 3;
    for (const auto& file : files) {
        CAPTURE(file.string());
        const WalledWorld world = world_of(file);
        // a tick of a robot, one that is too long for any robot, and one in which it drives 10 m
        for (const double dt : {1.0 / 60.0, 0.5, 10.0}) {
            CAPTURE(dt);
            CHECK(faults_in(world, each, dt, random) == 0);
        }
    }
}

TEST_CASE("walls hold: a robot that is pushed into a corner for an hour stays where it is") {
    for (const std::string file : {"sim/worlds/lab.json", "sim/worlds/l_room.json"}) {
        CAPTURE(file);
        const WalledWorld world = world_of(file);
        Roomba robot = at_start(world, world.plan.starts.front());
        robot.rotation = 0.6;
        Surroundings around = surroundings_of(world.plan);
        robot.set_velocity(robot.max_linear, 0.0);
        Roomba halfway;
        for (int tick = 0; tick < 216'000; ++tick) {
            sense(world, around, robot);
            move(world, around, robot, lab_dt);
            if (tick == 108'000) halfway = robot;
        }
        CHECK(std::isfinite(robot.x));
        CHECK(std::isfinite(robot.y));
        CHECK(clearance(world, {robot.x, robot.y}) >= world.plan.robot.radius - 1e-9);
        CHECK(std::hypot(robot.x - halfway.x, robot.y - halfway.y) < 1e-6);
        CHECK(is_in_a_room(world, {robot.x, robot.y}));
    }
}

}  // namespace
}  // namespace trellis
