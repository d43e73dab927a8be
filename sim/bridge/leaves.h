// The Roomba's leaves and sensors: what behaviour files can name. The four leaves of the lab's
// report keep their names and rules (LAB 1.4); the others are the primitives they can be written
// with. Covered by tests/sim/leaves_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/status.h"
#include "sim/roomba.h"

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

/// Adds all of the above, and the sensors `_x.x`, `_x.y`, `_x.rotation`, `_x.v`, `_x.w`,
/// `_x.bumper`.
void register_roomba(Registry& registry);

}  // namespace trellis
