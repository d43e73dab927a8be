// The Roomba's leaves as the plain structs they are, without the runtime: what they command and
// when they end. In trees and machines they run in tests/sim/lab_behaviours_test.cpp.
// SPDX-License-Identifier: MIT
#include "sim/bridge/leaves.h"

#include "core/random.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using namespace trellis;

namespace {

constexpr double dt = 1.0 / 60.0;  // s

/// A leaf on a robot of its own, its random numbers a list.
template <class Leaf>
struct Bench {
    Leaf leaf{};
    Roomba robot{};
    Random random = Random::replaying({});

    Status tick() { return leaf.tick(robot, {.count = 0, .dt = dt, .random = &random}); }

    /// How often it runs before it ends, the last tick included; 0 if it is still running after
    /// `most` ticks.
    int duration(int most = 2'000) {
        for (int n = 1; n <= most; ++n)
            if (tick() != Status::running) return n;
        return 0;
    }
};

}  // namespace

TEST_CASE("leaves: MoveForward drives straight and succeeds in the tick after its time") {
    Bench<MoveForward> bench;
    CHECK(bench.tick() == Status::running);
    CHECK(bench.robot.linear == 0.5);
    CHECK(bench.robot.angular == 0.0);
    // 180 · dt is exactly 3 s, which is not more than 3 s
    CHECK(bench.duration() == 180);
    CHECK(bench.tick() == Status::success);
}

TEST_CASE("leaves: MoveForward fails on a bump, unless its time is over") {
    Bench<MoveForward> bench;
    bench.robot.bumper = true;
    CHECK(bench.tick() == Status::failure);
    bench.leaf.duration = 0.0;
    CHECK(bench.tick() == Status::success);
}

TEST_CASE("leaves: MoveInSpiral turns less and less") {
    Bench<MoveInSpiral> bench;
    CHECK(bench.tick() == Status::running);
    CHECK(bench.robot.linear == 0.5);
    CHECK(bench.robot.angular == bench.robot.max_angular);  // asks for 2.49 rad/s
    while (bench.leaf.ticks < 61)
        bench.tick();
    CHECK(bench.robot.angular == 0.5 / (0.2 + 0.05 * (61 * dt)));
    CHECK(bench.duration() == 1201 - 61);
    CHECK(bench.robot.angular == 0.41637751561415687);
}

TEST_CASE("leaves: MoveInSpiral fails on a bump, but still commands its velocity") {
    Bench<MoveInSpiral> bench;
    bench.robot.bumper = true;
    CHECK(bench.tick() == Status::failure);
    CHECK(bench.robot.linear == 0.5);
    bench.leaf.duration = 0.0;
    CHECK(bench.tick() == Status::success);
}

TEST_CASE("leaves: GoBack drives backwards, whatever the bumper says") {
    Bench<GoBack> bench;
    bench.robot.bumper = true;
    CHECK(bench.tick() == Status::running);
    CHECK(bench.robot.linear == -0.1);
    CHECK(bench.robot.angular == 0.0);
    CHECK(bench.duration() == 30);
}

TEST_CASE("leaves: Rotate draws its angle once and turns for as long as that takes") {
    struct Turn {
        double angle;  // rad
        double command;
        int ticks;
    };
    // 0.25 rad take 0.5 s, 30 ticks exactly: not more yet
    for (const Turn& turn : {Turn{0.25, 0.5, 31}, {-0.25, -0.5, 31}, {1.0, 0.5, 121}}) {
        Bench<Rotate> bench;
        bench.random = Random::replaying({turn.angle, 99.0});
        CHECK(bench.duration() == turn.ticks);
        CHECK(bench.leaf.angle == turn.angle);
        CHECK(bench.robot.linear == 0.0);
        CHECK(bench.robot.angular == turn.command);
    }
}

TEST_CASE("leaves: Rotate by nothing takes one tick, to the left") {
    for (const double nothing : {0.0, -0.0}) {
        Bench<Rotate> bench;
        bench.random = Random::replaying({nothing});
        CHECK(bench.duration() == 1);
        CHECK(bench.robot.angular == -0.5);
    }
}

TEST_CASE("leaves: Rotate draws as random.Random(42).uniform(-pi, pi) of Python") {
    Bench<Rotate> bench;
    bench.random = Random(42);
    bench.tick();
    CHECK(bench.leaf.angle == 0.8760444114976647);
}

TEST_CASE("leaves: SetVelocity runs on, or succeeds at once without hold") {
    Bench<SetVelocity> bench{.leaf = {.linear = 0.3, .angular = -5.0}};
    CHECK(bench.tick() == Status::running);
    CHECK(bench.robot.linear == 0.3);
    CHECK(bench.robot.angular == -2.0);
    bench.leaf.hold = false;
    CHECK(bench.tick() == Status::success);
}

TEST_CASE("leaves: Wait lets time pass and leaves the robot alone") {
    Wait wait;
    Random random;
    const Tick tick{.count = 0, .dt = dt, .random = &random};
    for (int n = 1; n <= 60; ++n)
        CHECK(wait.tick(tick) == Status::running);
    CHECK(wait.tick(tick) == Status::success);
}

TEST_CASE("leaves: Bumped is the bumper") {
    Roomba robot;
    Random random;
    const Tick tick{.count = 0, .dt = dt, .random = &random};
    CHECK_FALSE(Bumped{}.tick(robot, tick));
    robot.bumper = true;
    CHECK(Bumped{}.tick(robot, tick));
}

TEST_CASE("leaves: all are registered with their ports, and the sensors of the robot") {
    Registry registry;
    register_roomba(registry);
    std::vector<std::string> leaves, ports, sensors;
    for (const LeafType& leaf : registry.leaves()) {
        leaves.push_back(leaf.name);
        for (const Port& port : leaf.ports)
            ports.push_back(leaf.name + '.' + port.name);
    }
    for (const Sensor& sensor : registry.host().sensors)
        sensors.push_back(sensor.name);
    CHECK(leaves == std::vector<std::string>{"MoveForward", "MoveInSpiral", "GoBack", "Rotate",
                                             "SetVelocity", "Wait", "Bumped", "FollowWall",
                                             "TurnTo", "DriveTo", "Dock", "Spot", "BatteryLow",
                                             "DirtFound", "Docked"});
    CHECK(ports == std::vector<std::string>{"MoveForward.speed",   "MoveForward.duration",
                                            "MoveInSpiral.speed",  "MoveInSpiral.radius",
                                            "MoveInSpiral.growth", "MoveInSpiral.duration",
                                            "GoBack.speed",        "GoBack.duration",
                                            "Rotate.rate",         "Rotate.least",
                                            "Rotate.most",         "SetVelocity.linear",
                                            "SetVelocity.angular", "SetVelocity.hold",
                                            "Wait.duration",       "FollowWall.speed",
                                            "FollowWall.distance", "FollowWall.gain",
                                            "FollowWall.duration", "TurnTo.heading",
                                            "TurnTo.rate",         "DriveTo.x",
                                            "DriveTo.y",           "DriveTo.speed",
                                            "DriveTo.tolerance",   "Dock.speed",
                                            "Spot.speed",          "Spot.radius",
                                            "Spot.growth",         "Spot.clear",
                                            "BatteryLow.level"});
    CHECK(sensors == std::vector<std::string>{"bumper", "x", "y", "rotation", "v", "w",
                                              "bumper_left", "bumper_right", "wall_distance",
                                              "dirt", "battery", "docked", "dock_visible",
                                              "dock_bearing"});
    CHECK(registry.find("Bumped")->condition);
    CHECK_FALSE(registry.find("Wait")->condition);
}
