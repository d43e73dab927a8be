// The Roomba's leaves and sensors: what behaviour files can name. The four leaves of the lab's
// report keep their names and rules (LAB 1.4); the others are the primitives they can be written
// with. Covered by tests/sim/leaves_test.cpp and household_leaves_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/status.h"
#include "sim/roomba.h"

#include <array>
#include <cstdint>

namespace trellis {

/// Drives straight until `duration` has passed: success. Fails on a bump. The time is tested before
/// the bumper.
struct MoveForward {
    double speed = 0.5;     // m/s  input
    double duration = 3.0;  // s    input
    int ticks = 0;          //      state: ticks since entry, the current one included
    Status tick(Roomba& robot, const Tick& t);
};

/// Drives a spiral whose radius grows with time, r = radius + growth · t, until `duration` has
/// passed: success. Fails on a bump. The time is tested before the bumper.
struct MoveInSpiral {
    double speed = 0.5;      // m/s  input
    double radius = 0.2;     // m    input
    double growth = 0.05;    // m/s  input
    double duration = 20.0;  // s    input
    int ticks = 0;           //      state
    Status tick(Roomba& robot, const Tick& t);
};

/// Drives backwards until `duration` has passed: success.
struct GoBack {
    double speed = 0.1;     // m/s  input
    double duration = 0.5;  // s    input
    int ticks = 0;          //      state
    Status tick(Roomba& robot, const Tick& t);
};

/// Turns on the spot by an angle drawn when it is entered, uniform between `least` and `most`:
/// success. A positive angle turns to positive rotation, zero and negative ones the other way.
struct Rotate {
    double rate = 0.5;                  // rad/s  input, above 0
    double least = -3.141592653589793;  // rad    input
    double most = 3.141592653589793;    // rad    input
    double angle = 0.0;                 // rad    state: what was drawn
    int ticks = 0;                      //        state
    Status tick(Roomba& robot, const Tick& t);
};

/// Commands a velocity in every tick. Runs until it is halted; without `hold` it succeeds at once
/// and the robot keeps the velocity.
struct SetVelocity {
    double linear = 0.0;   // m/s    input
    double angular = 0.0;  // rad/s  input
    bool hold = true;      //        input
    Status tick(Roomba& robot, const Tick& t) const;
};

/// Runs until `duration` has passed: success. The robot keeps its velocity.
struct Wait {
    double duration = 1.0;  // s  input
    int ticks = 0;          //    state
    Status tick(const Tick& t);
};

/// Succeeds in the tick after the robot has met a wall, else fails.
struct Bumped {
    bool tick(Roomba& robot, const Tick& t) const;
};

/// Follows the wall on the right at `distance` until `duration` has passed: success. Turns away to
/// the left while it bumps, and to the right where the wall ends.
struct FollowWall {
    double speed = 0.3;      // m/s    input
    double distance = 0.05;  // m      input: from the robot's side
    double gain = 10.0;      // rad/s per m  input
    double duration = 20.0;  // s      input
    int ticks = 0;           //        state
    int away = 0;            //        state: ticks for which it still turns away
    Status tick(Roomba& robot, const Tick& t);
};

/// Turns on the spot to an absolute heading, the shorter way round: success.
struct TurnTo {
    double heading = 0.0;  // rad    input
    double rate = 1.0;     // rad/s  input, above 0
    Status tick(Roomba& robot, const Tick& t) const;
};

/// Drives to a place: turns towards it on the spot, then straight. Succeeds within `tolerance` of
/// it, fails on a bump.
struct DriveTo {
    double x = 0.0;           // m    input
    double y = 0.0;           // m    input
    double speed = 0.3;       // m/s  input
    double tolerance = 0.05;  // m    input, above 0
    Status tick(Roomba& robot, const Tick& t) const;
};

/// Drives to the dock while it can be seen: succeeds when docked, at rest; fails when it is not
/// seen.
struct DriveToDock {
    double speed = 0.3;  // m/s  input
    Status tick(Roomba& robot, const Tick& t) const;
};

/// Cleans a spot in a small spiral until no dirt has been found for `clear` s: success. Fails on a
/// bump.
struct Spot {
    double speed = 0.2;    // m/s  input
    double radius = 0.1;   // m    input: of the spiral at the start
    double growth = 0.01;  // m/s  input: of the radius
    double clear = 2.0;    // s    input
    int ticks = 0;         //      state
    int clean_ticks = 0;   //      state: since dirt was last found
    Status tick(Roomba& robot, const Tick& t);
};

/// Succeeds while the battery holds less than `level` of a full one, else fails.
struct BatteryLow {
    double level = 0.3;  // input, 0 to 1
    bool tick(Roomba& robot, const Tick& t) const;
};

/// Succeeds while there is dirt under the robot, else fails.
struct DirtFound {
    bool tick(Roomba& robot, const Tick& t) const;
};

/// Succeeds while the robot is at the dock, else fails.
struct Docked {
    bool tick(Roomba& robot, const Tick& t) const;
};

/// Whether a leaf of register_roomba() perceives nothing but the bumper and the time: where the
/// robot stands and what is around it does not matter to it.
bool feels_only_bumper(const LeafType& leaf);

/// The sensors of the bumper, as bytes of a Roomba: see Sensor::offset.
std::array<std::uint32_t, 3> bumper_sensors();

/// Adds all of the above, and the sensors `_x.x`, `_x.y`, `_x.rotation`, `_x.v`, `_x.w`,
/// `_x.bumper`, `_x.bumper_left`, `_x.bumper_right`, `_x.wall_distance`, `_x.dirt`, `_x.battery`,
/// `_x.docked`, `_x.dock_visible` and `_x.dock_bearing`.
void register_roomba(Registry& registry);

}  // namespace trellis
