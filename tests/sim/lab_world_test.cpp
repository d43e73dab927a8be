// Collision and motion of the lab's world: its constants, every wall and corner, the boundary
// between straight and curved motion, and that nobody stands outside after `sense`. Whole recorded
// runs are in lab_streams_test.cpp.
// SPDX-License-Identifier: MIT
#include "sim/lab_world.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace trellis;

namespace {

const LabWorld lab;

/// A robot at (x, y) after `sense`.
Roomba sensed(double x, double y, const LabWorld& world = lab) {
    Roomba robot{.x = x, .y = y};
    sense(world, robot);
    return robot;
}

Roomba moved(Roomba robot, double linear, double angular) {
    robot.set_velocity(linear, angular);
    move(robot, lab_dt);
    return robot;
}

}  // namespace

TEST_CASE("lab world: the constants are the lab's, to the last bit") {
    CHECK(lab_dt == 0x1.1111111111111p-6);
    CHECK(lab.width == 0x1.999999999999ap+2);
    CHECK(lab.height == 0x1.3333333333333p+2);
    CHECK(lab.radius == 0.17);
    CHECK(lab.start == Pose{3.2, 2.4, 0.0});
    CHECK(at_start(lab) == Roomba{.x = 3.2, .y = 2.4});
}

TEST_CASE("lab world: a robot away from the walls is left alone and its bumper released") {
    Roomba robot{.x = 3.2, .y = 2.4, .rotation = 1.0, .bumper = true};
    sense(lab, robot);
    CHECK(robot == Roomba{.x = 3.2, .y = 2.4, .rotation = 1.0});
}

TEST_CASE("lab world: touching a wall exactly presses the bumper and moves nobody") {
    CHECK(sensed(0.17, 2.4) == Roomba{.x = 0.17, .y = 2.4, .bumper = true});
    CHECK(sensed(3.2, 0.17) == Roomba{.x = 3.2, .y = 0.17, .bumper = true, .bumper_left = true});
    CHECK(sensed(6.23, 2.4) ==
          Roomba{.x = 6.23, .y = 2.4, .bumper = true, .bumper_left = true, .bumper_right = true});
    CHECK(sensed(3.2, 4.63) == Roomba{.x = 3.2, .y = 4.63, .bumper = true, .bumper_right = true});
}

TEST_CASE("lab world: the nearest pose that does not touch is free") {
    CHECK_FALSE(sensed(std::nextafter(0.17, 1.0), 2.4).bumper);
    CHECK_FALSE(sensed(3.2, std::nextafter(0.17, 1.0)).bumper);
    CHECK_FALSE(sensed(6.2299, 2.4).bumper);
    CHECK_FALSE(sensed(3.2, 4.6299).bumper);
}

TEST_CASE("lab world: a robot beyond a wall is put back against it, heading kept") {
    Roomba robot{.x = 6.3, .y = 1.0, .rotation = 30.0};
    sense(lab, robot);
    CHECK(
        robot ==
        Roomba{.x = 6.4 - 0.17, .y = 1.0, .rotation = 30.0, .bumper = true, .bumper_right = true});
    CHECK(sensed(-1.0, 1.0).x == 0.17);
    CHECK(sensed(1.0, -1.0).y == 0.17);
    CHECK(sensed(1.0, 9.0).y == lab.height - 0.17);
}

TEST_CASE("lab world: a robot put back against a wall touches it again") {
    for (const Roomba& first :
         {sensed(-1.0, 2.0), sensed(9.0, 2.0), sensed(2.0, -1.0), sensed(2.0, 9.0)}) {
        Roomba again = first;
        sense(lab, again);
        CHECK(again == first);
    }
}

TEST_CASE("lab world: in a corner both walls push and both are told") {
    CHECK(sensed(0.1, 4.8) == Roomba{.x = 0.17, .y = lab.height - 0.17, .bumper = true});
    CHECK(contacts(lab, 0.1, 4.8) == Contacts{.left = true, .bottom = true});
    CHECK(contacts(lab, 6.4, 0.0) == Contacts{.right = true, .top = true});
    CHECK(contacts(lab, 3.2, 2.4) == Contacts{});
}

TEST_CASE("lab world: in a room narrower than the robot the right and the bottom wall win") {
    const LabWorld narrow{.width = 0.2, .height = 0.1};
    const Roomba robot = sensed(0.1, 0.05, narrow);
    CHECK(robot == Roomba{.x = 0.2 - 0.17,
                          .y = 0.1 - 0.17,
                          .bumper = true,
                          .bumper_left = true,
                          .bumper_right = true});
    CHECK(contacts(narrow, 0.1, 0.05) == Contacts{true, true, true, true});
}

TEST_CASE("lab world: nobody stands outside after sense, wherever he was, in rooms of any size") {
    std::mt19937_64 random(42);
    std::uniform_real_distribution<double> anywhere(-20.0, 40.0);
    std::uniform_real_distribution<double> size(0.5, 20.0);
    for (int i = 0; i < 100'000; ++i) {
        const LabWorld world{.width = size(random), .height = size(random)};
        const double x = anywhere(random);
        const double y = anywhere(random);
        const Roomba robot = sensed(x, y, world);
        const bool inside = robot.x >= world.radius && robot.x <= world.width - world.radius &&
                            robot.y >= world.radius && robot.y <= world.height - world.radius;
        const bool was_free = robot.x == x && robot.y == y;
        CAPTURE(x);
        CAPTURE(y);
        REQUIRE(inside);
        REQUIRE((was_free || robot.bumper));
        REQUIRE(robot.bumper == contacts(world, x, y).any());
    }
}

TEST_CASE("lab world: straight motion goes along the heading and measures the command") {
    const Roomba start{.x = 3.2, .y = 2.4};
    const Roomba ahead = moved(start, 0.5, 0.0);
    CHECK(ahead == Roomba{.x = 3.2083333333333335, .y = 2.4, .v = 0.5, .linear = 0.5});
    const Roomba down = moved({.x = 3.2, .y = 2.4, .rotation = std::numbers::pi / 2.0}, 0.6, 0.0);
    CHECK(down.y == doctest::Approx(2.41).epsilon(1e-14));
    CHECK(down.x == doctest::Approx(3.2).epsilon(1e-14));
}

TEST_CASE("lab world: a velocity holds until the next command") {
    Roomba robot = at_start(lab);
    robot.set_velocity(0.5, 0.0);
    for (int i = 0; i < 181; ++i)
        move(robot, lab_dt);
    CHECK(robot.x == 4.708333333333366);
}

TEST_CASE("lab world: below 0.001 rad/s the chord is taken, from there on the arc") {
    const Roomba start{.x = 1.0, .y = 1.0, .rotation = 0.3};
    for (const double sign : {1.0, -1.0}) {
        const double below = sign * std::nextafter(1e-3, 0.0);
        const Roomba chord = moved(start, 1.0, below);
        CHECK(chord.x == 1.0 + (1.0 * lab_dt) * std::cos(0.3 + (below * lab_dt) / 2.0));
        CHECK(chord.y == 1.0 + (1.0 * lab_dt) * std::sin(0.3 + (below * lab_dt) / 2.0));

        const double at = sign * 1e-3;
        const double half_turn = std::sin((at * lab_dt) / 2.0);
        const Roomba arc = moved(start, 1.0, at);
        CHECK(arc.x == 1.0 + ((2.0 / at) * std::cos(0.3 + (at * lab_dt) / 2.0)) * half_turn);
        CHECK(arc.y == 1.0 + ((2.0 / at) * std::sin(0.3 + (at * lab_dt) / 2.0)) * half_turn);
        CHECK(arc.rotation == 0.3 + at * lab_dt);
        CHECK(chord.x == doctest::Approx(arc.x).epsilon(1e-12));
        CHECK(chord.y == doctest::Approx(arc.y).epsilon(1e-12));
    }
}

TEST_CASE("lab world: turning on the spot changes the heading only, and never wraps it") {
    Roomba robot = at_start(lab);
    robot.set_velocity(0.0, -2.0);
    for (int i = 0; i < 6000; ++i)
        move(robot, lab_dt);
    CHECK(robot.x == lab.start.x);
    CHECK(robot.y == lab.start.y);
    CHECK(robot.rotation == doctest::Approx(-200.0));
    CHECK(robot.v == 0.0);
    CHECK(robot.w == -2.0);
}

TEST_CASE("lab world: a full circle ends where it began, whatever the length of the tick") {
    for (const int ticks : {7, 60, 1000}) {
        Roomba robot = at_start(lab);
        robot.set_velocity(0.5, 2.0);
        for (int i = 0; i < ticks; ++i)
            move(robot, std::numbers::pi / ticks);
        CHECK(robot.x == doctest::Approx(3.2).epsilon(1e-12));
        CHECK(robot.y == doctest::Approx(2.4).epsilon(1e-12));
    }
}
