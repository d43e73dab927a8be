// The leaves for worlds of walls, without any tree: in the world itself where they drive.
// SPDX-License-Identifier: MIT
#include "sim/bridge/leaves.h"
#include "sim/surroundings.h"

#include <doctest/doctest.h>

#include <cmath>

namespace trellis {
namespace {

constexpr Tick tick_of_lab{.dt = lab_dt};

World plan() {
    World world = lab_room();
    world.dirt = {{.centre = {3.0, 2.4}, .radius = 0.1}};
    world.docks = {{.place = {6.0, 2.4}}};
    return world;
}

/// A robot in its world, driven by one leaf until the leaf ends or the time is up.
struct Scene {
    WalledWorld world;
    Surroundings around;
    Roomba robot;

    explicit Scene(Pose start)
        : world(plan()), around(surroundings_of(world.plan)), robot(at_start(world, start)) {}

    template <class Leaf>
    Status run(Leaf& leaf, double seconds) {
        Status status = Status::running;
        for (int tick = 0; tick < seconds * 60.0 && status == Status::running; ++tick) {
            sense(world, around, robot);
            status = leaf.tick(robot, tick_of_lab);
            move(world, around, robot, lab_dt);
        }
        return status;
    }
};

TEST_CASE("household leaves: FollowWall goes round the room at its distance") {
    Scene scene({3.2, 4.5, 0.0});
    FollowWall leaf{.duration = 1000.0};
    CHECK(scene.run(leaf, 5.0) == Status::running);
    CHECK(scene.robot.y == doctest::Approx(4.63 - leaf.distance).epsilon(0.01));
    CHECK(scene.run(leaf, 60.0) == Status::running);
    CHECK(scene.world.walls.nearest({scene.robot.x, scene.robot.y}).distance < 0.3);
    FollowWall brief{.duration = 0.5};
    CHECK(scene.run(brief, 2.0) == Status::success);
}

TEST_CASE("household leaves: TurnTo ends at the heading, the shorter way round") {
    Scene scene({3.2, 2.0, 3.0});
    TurnTo leaf{.heading = -3.0};
    CHECK(scene.run(leaf, 1.0) == Status::success);
    CHECK(std::remainder(scene.robot.rotation + 3.0, 2.0 * 3.141592653589793) ==
          doctest::Approx(0.0));
    CHECK(scene.robot.rotation > 3.0);
    CHECK(scene.robot.angular == 0.0);
}

TEST_CASE("household leaves: DriveTo ends at the place, or fails at a wall") {
    Scene scene({1.0, 1.0, 2.0});
    DriveTo leaf{.x = 4.0, .y = 4.0};
    CHECK(scene.run(leaf, 60.0) == Status::success);
    CHECK(std::hypot(scene.robot.x - 4.0, scene.robot.y - 4.0) <= leaf.tolerance);
    DriveTo outside{.x = 10.0, .y = 4.0};
    CHECK(scene.run(outside, 60.0) == Status::failure);
}

TEST_CASE("household leaves: Dock drives to the dock it sees, and fails without one") {
    Scene scene({4.0, 1.0, 3.0});
    DriveToDock leaf;
    CHECK(scene.run(leaf, 60.0) == Status::success);
    CHECK(scene.robot.docked);
    CHECK(Docked{}.tick(scene.robot, tick_of_lab));
    CHECK(scene.robot.linear == 0.0);
    Roomba blind;
    CHECK(leaf.tick(blind, tick_of_lab) == Status::failure);
}

TEST_CASE("household leaves: Spot stays until the dirt is gone") {
    Scene scene({3.0, 2.2, 0.0});
    sense(scene.world, scene.around, scene.robot);
    CHECK(DirtFound{}.tick(scene.robot, tick_of_lab));
    Spot leaf;
    CHECK(scene.run(leaf, 60.0) == Status::success);
    CHECK(scene.around.dirt.front() == 0.0);
    CHECK_FALSE(DirtFound{}.tick(scene.robot, tick_of_lab));
}

TEST_CASE("household leaves: BatteryLow compares with its level") {
    Roomba robot;
    robot.battery = 0.29;
    CHECK(BatteryLow{}.tick(robot, tick_of_lab));
    CHECK_FALSE(BatteryLow{.level = 0.29}.tick(robot, tick_of_lab));
}

}  // namespace
}  // namespace trellis
