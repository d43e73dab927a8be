// Driving among walls. The properties hold for random commands in every world of sim/worlds:
// 200,000 ticks in all, or as many as TRELLIS_DRIVE_TICKS says.
// SPDX-License-Identifier: MIT
#include "sim/drive.h"

#include "sim/bridge/world_file.h"
#include "sim/walled_world.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace trellis {
namespace {

constexpr double pi = std::numbers::pi;

struct Driven {
    Roomba robot;
    Drive drive;
};

/// One tick: commands, moves, senses.
void drive(const WalledWorld& world, Driven& driven, double forward, double turn,
           double dt = lab_dt) {
    driven.robot.set_velocity(forward, turn);
    move(world.walls, driven.drive, driven.robot, dt);
    sense(driven.drive, driven.robot);
}

Driven at(const WalledWorld& world, Pose pose) {
    return {.robot = at_start(world, pose), .drive = {}};
}

WalledWorld world_named(const std::string& file) {
    const std::string text = test::read_file(TRELLIS_SOURCE_DIR "/" + file);
    Diagnostics diagnostics;
    const std::uint32_t number = diagnostics.add_file(file, text);
    const std::optional<World> world = read_world(text, number, diagnostics);
    CHECK(diagnostics.render() == "");
    REQUIRE(world);
    return WalledWorld(*world);
}

TEST_CASE("drive: far from walls the robot moves as in the lab") {
    const WalledWorld world(lab_room());
    Driven driven = at(world, {3.2, 2.4, 0.0});
    Roomba lab = driven.robot;
    for (int tick = 0; tick < 100; ++tick) {
        drive(world, driven, 0.5, 0.7);
        lab.set_velocity(0.5, 0.7);
        move(lab, lab_dt);
        REQUIRE(driven.robot == lab);
    }
}

TEST_CASE("drive: a robot that meets a wall head on stops, both halves of the bumper pressed") {
    const WalledWorld world(lab_room());
    Driven driven = at(world, {6.0, 2.4, 0.0});
    for (int tick = 0; tick < 60; ++tick)
        drive(world, driven, 0.5, 0.0);
    CHECK(driven.robot.x == doctest::Approx(6.23));
    CHECK(driven.robot.y == 2.4);
    CHECK(driven.robot.bumper);
    CHECK(driven.robot.bumper_left);
    CHECK(driven.robot.bumper_right);
    drive(world, driven, -0.1, 0.0);
    CHECK_FALSE(driven.robot.bumper);
    CHECK_FALSE(driven.robot.bumper_left);
}

TEST_CASE("drive: beside the front only one half is pressed, behind none, but the wall is felt") {
    const WalledWorld world(lab_room());
    // the wall at the bottom is to the right of a robot that looks to the right
    Driven right = at(world, {3.2, 4.6, 0.5});
    drive(world, right, 0.5, 0.0);
    drive(world, right, 1.0, 0.0, 0.1);
    CHECK(right.drive.angle == doctest::Approx(pi / 2.0 - 0.5));
    CHECK(right.robot.bumper_right);
    CHECK_FALSE(right.robot.bumper_left);

    Driven left = at(world, {3.2, 0.2, -0.5});
    drive(world, left, 1.0, 0.0, 0.2);
    CHECK(left.robot.bumper_left);
    CHECK_FALSE(left.robot.bumper_right);

    Driven behind = at(world, {0.2, 2.4, 0.0});
    drive(world, behind, -1.0, 0.0, 0.2);
    CHECK(behind.robot.bumper);
    CHECK_FALSE(behind.robot.bumper_left);
    CHECK_FALSE(behind.robot.bumper_right);
}

TEST_CASE("drive: what is left of a move goes along the wall") {
    const WalledWorld world(lab_room());
    Driven driven = at(world, {3.0, 4.6, pi / 4.0});
    drive(world, driven, 1.0, 0.0, 1.0);
    CHECK(driven.robot.x == doctest::Approx(3.0 + std::sqrt(0.5)));
    CHECK(driven.robot.y == doctest::Approx(4.63));
}

TEST_CASE("drive: no speed takes the robot through a thin wall") {
    World plan = lab_room();
    plan.robot.max_linear = 1000.0;
    plan.furniture = {{.name = "", .corners = {{3.0, 0.5}, {3.001, 0.5}, {3.0, 4.0}}}};
    const WalledWorld world(plan);
    Driven driven = at(world, {1.0, 2.0, 0.0});
    drive(world, driven, 1000.0, 0.0, 1.0);
    CHECK(driven.robot.x == doctest::Approx(3.0 - 0.17).epsilon(0.001));
}

TEST_CASE("drive: a velocity that is no number does not move the robot") {
    const WalledWorld world(lab_room());
    Driven driven = at(world, {1.0, 2.0, 0.0});
    drive(world, driven, std::numeric_limits<double>::quiet_NaN(), 0.0);
    CHECK(driven.robot.x == 1.0);
    drive(world, driven, 0.5, std::numeric_limits<double>::quiet_NaN());
    CHECK(driven.robot.x == 1.0);
    CHECK(driven.robot.rotation == 0.0);
}

TEST_CASE("drive: a robot pushed into a corner for an hour stays where it is") {
    World plan = lab_room();
    plan.furniture = {{.name = "wedge", .corners = {{4.0, 4.8}, {6.0, 4.0}, {5.8, 4.8}}}};
    const WalledWorld world(plan);
    for (const Pose start : {Pose{6.0, 0.4, -0.7}, Pose{3.6, 4.5, 0.3}, Pose{1.0, 4.0, 2.2}}) {
        Driven driven = at(world, start);
        for (int tick = 0; tick < 600; ++tick)
            drive(world, driven, 1.0, 0.0);
        const Point settled{driven.robot.x, driven.robot.y};
        for (int tick = 0; tick < 36'000; ++tick)
            drive(world, driven, 1.0, 0.0, 0.1);
        CHECK(std::hypot(driven.robot.x - settled.x, driven.robot.y - settled.y) < 1e-6);
        CHECK(fits(world, {driven.robot.x, driven.robot.y}));
    }
}

/// Random commands up to the limits; the disc never is in a wall and never leaves its rooms.
void check_random_ticks(const WalledWorld& world, long ticks) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-1.2, 1.2);
    const RobotBody& body = world.plan.robot;
    Driven driven = at(world, world.plan.starts.front());
    double forward = 0.0;
    double turn = 0.0;
    for (long tick = 0; tick < ticks; ++tick) {
        if (tick % 32 == 0) {
            forward = part(random) * body.max_linear;
            turn = part(random) * body.max_angular;
        }
        drive(world, driven, forward, turn, tick % 1024 == 0 ? 1.0 : lab_dt);
        const Point place{driven.robot.x, driven.robot.y};
        if (world.walls.nearest(place).distance >= body.radius - 1e-9 &&
            (tick % 16 != 0 || fits(world, place)))
            continue;
        FAIL("tick " << tick << ": the robot is at " << place.x << ", " << place.y);
    }
}

TEST_CASE("drive: no wall is crossed in random ticks over all worlds") {
    const char* wanted = std::getenv("TRELLIS_DRIVE_TICKS");
    const auto files = test::files_below("sim/worlds", {".json"});
    REQUIRE(files.size() >= 6);
    const long ticks =
        (wanted != nullptr ? std::atol(wanted) : 200'000L) / static_cast<long>(files.size());
    for (const auto& file : files) {
        CAPTURE(file.string());
        check_random_ticks(world_named(file.string()), ticks);
    }
}

}  // namespace
}  // namespace trellis
