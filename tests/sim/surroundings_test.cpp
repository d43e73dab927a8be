// Dirt, battery, dock and the distance to walls: sensed and changed.
// SPDX-License-Identifier: MIT
#include "sim/surroundings.h"

#include <doctest/doctest.h>

#include <numbers>

namespace trellis {
namespace {

/// The lab's room with a spot of dirt to the left, a dock to the right, and a post between.
World plan() {
    World world = lab_room();
    world.dirt = {{.centre = {1.0, 2.4}, .radius = 0.1}};
    world.docks = {{.place = {6.0, 2.4}, .reach = 0.1, .range = 4.0}};
    world.battery = {.life = 100.0, .charging = 10.0, .start = 0.5};
    world.furniture = {
        {.name = "post", .corners = {{4.5, 2.0}, {4.6, 2.0}, {4.6, 2.8}, {4.5, 2.8}}}};
    return world;
}

Roomba sensed(const WalledWorld& world, const Surroundings& around, Pose pose) {
    Roomba robot = at_start(world, pose);
    sense(world, around, robot);
    return robot;
}

TEST_CASE(
    "surroundings: the distance from the right side to a wall, at most a quarter of a metre") {
    const WalledWorld world(plan());
    const Surroundings around = surroundings_of(world.plan);
    CHECK(sensed(world, around, {3.0, 4.5, 0.0}).wall_distance == doctest::Approx(0.13));
    CHECK(sensed(world, around, {3.0, 4.5, std::numbers::pi}).wall_distance == 0.25);
    CHECK(sensed(world, around, {0.3, 2.0, std::numbers::pi / 2.0}).wall_distance ==
          doctest::Approx(0.13));
}

TEST_CASE("surroundings: dirt is sensed where the disc is over it, and goes in four seconds") {
    const WalledWorld world(plan());
    Surroundings around = surroundings_of(world.plan);
    CHECK(sensed(world, around, {1.3, 2.4, 0.0}).dirt == 0.0);
    Roomba robot = sensed(world, around, {1.2, 2.4, 0.0});
    CHECK(robot.dirt == 1.0);
    for (int second = 0; second < 3; ++second)
        move(world, around, robot, 1.0);
    sense(world, around, robot);
    CHECK(robot.dirt == doctest::Approx(0.25));
    move(world, around, robot, 2.0);
    sense(world, around, robot);
    CHECK(robot.dirt == 0.0);
}

TEST_CASE("surroundings: the battery empties while it drives and fills at the dock") {
    const WalledWorld world(plan());
    Surroundings around = surroundings_of(world.plan);
    Roomba robot = at_start(world, {2.0, 2.0, 0.0});
    move(world, around, robot, 10.0);
    sense(world, around, robot);
    CHECK(robot.battery == doctest::Approx(0.4));
    CHECK_FALSE(robot.docked);
    move(world, around, robot, 1000.0);
    CHECK(around.battery == 0.0);

    robot = at_start(world, {6.05, 2.4, 0.0});
    move(world, around, robot, 5.0);
    sense(world, around, robot);
    CHECK(robot.docked);
    CHECK(robot.battery == doctest::Approx(0.5));
    move(world, around, robot, 1000.0);
    CHECK(around.battery == 1.0);
}

TEST_CASE("surroundings: the dock is seen from near, with its bearing, when nothing is between") {
    const WalledWorld world(plan());
    const Surroundings around = surroundings_of(world.plan);
    const Roomba near = sensed(world, around, {6.0, 1.4, 0.0});
    CHECK(near.dock_visible);
    CHECK(near.dock_bearing == doctest::Approx(std::numbers::pi / 2.0));
    CHECK(sensed(world, around, {5.0, 2.4, 6.0 * std::numbers::pi}).dock_bearing ==
          doctest::Approx(0.0));
    CHECK_FALSE(sensed(world, around, {3.5, 2.4, 0.0}).dock_visible);  // behind the post
    CHECK_FALSE(sensed(world, around, {1.0, 1.0, 0.0}).dock_visible);  // too far
    CHECK(sensed(world, around, {3.5, 2.4, 0.0}).dock_bearing == 0.0);
}

}  // namespace
}  // namespace trellis
