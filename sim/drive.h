// Driving among walls: the lab's kinematics, stopped by what the disc meets on its way and sliding
// along it. No speed takes a robot through a wall. The lab's own room has its own rules
// (sim/lab_world.h). Covered by tests/sim/drive_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/roomba.h"
#include "sim/walls.h"

namespace trellis {

/// What a move met, and what the next one can do without looking. A value that goes with a robot.
struct Drive {
    bool touched = false;  ///< the last move ended against a wall or slid along one
    double angle = 0.0;    ///< rad, of the first wall met, from the heading: -pi to pi, 0 is ahead

    // no wall is nearer to the disc than `clear` where the robot was at `checked`
    Point checked;
    double clear = 0.0;  // m

    friend bool operator==(const Drive&, const Drive&) = default;
};

/// First half of a tick: sets the robot's bumpers to what the last move met. A wall presses the
/// bumper wherever it is; the left or the right half if it is on that side of the front, both if it
/// is within 10 degrees of straight ahead.
void sense(const Drive& drive, Roomba& robot);

/// Second half of a tick: drives for `dt` seconds with the commanded velocity, straight from where
/// the lab's kinematics begin to where they end, as far as the walls let it; what is left of the
/// way goes along the wall. Afterwards the disc is clear of all walls, to 1e-9 m, if it was before.
/// A velocity that is no number does not move the robot.
void move(const Walls& walls, Drive& drive, Roomba& robot, double dt);

}  // namespace trellis
