// The robot as leaves see it: the limits of a command, and that it is a plain value.
// SPDX-License-Identifier: MIT
#include "sim/roomba.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <type_traits>

using namespace trellis;

static_assert(std::is_trivially_copyable_v<Roomba>);

TEST_CASE("roomba: a command within the limits is taken as it is, the limits included") {
    Roomba robot;
    robot.set_velocity(1.0, -2.0);
    CHECK(robot.linear == 1.0);
    CHECK(robot.angular == -2.0);
    robot.set_velocity(-0.1, 0.41637751561415687);
    CHECK(robot.linear == -0.1);
    CHECK(robot.angular == 0.41637751561415687);
}

TEST_CASE("roomba: a command beyond the limits is cut to them, each velocity by itself") {
    Roomba robot;
    robot.set_velocity(std::nextafter(1.0, 2.0), 2.5);
    CHECK(robot.linear == 1.0);
    CHECK(robot.angular == 2.0);
    robot.set_velocity(0.5, -std::numeric_limits<double>::infinity());
    CHECK(robot.linear == 0.5);
    CHECK(robot.angular == -2.0);
}

TEST_CASE("roomba: the limits are the robot's own") {
    Roomba robot{.max_linear = 0.3, .max_angular = 0.0};
    robot.set_velocity(-0.5, 0.1);
    CHECK(robot.linear == -0.3);
    CHECK(robot.angular == 0.0);
}

TEST_CASE("roomba: a command changes no sensor") {
    Roomba robot{.x = 1.0, .y = 2.0, .rotation = 3.0, .v = 0.1, .w = 0.2, .bumper = true};
    Roomba expected = robot;
    expected.linear = 0.5;
    expected.angular = 1.0;
    robot.set_velocity(0.5, 1.0);
    CHECK(robot == expected);
}
