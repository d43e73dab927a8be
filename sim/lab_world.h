// The lab's world, to the last bit: one rectangular room, a disc that cannot leave it, and the
// motion of a differential drive. A tick is `sense`, then the behaviour, then `move`: the behaviour
// itself, clocks and drawings are not here. Needs -ffp-contract=off and no fast-math. Covered by
// tests/sim/lab_world_test.cpp and, against recorded runs, tests/sim/lab_streams_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/roomba.h"

namespace trellis {

/// Where a robot stands: m, m (downwards), rad (clockwise as drawn).
struct Pose {
    double x = 0.0;
    double y = 0.0;
    double rotation = 0.0;

    friend bool operator==(const Pose&, const Pose&) = default;
};

/// The length of the lab's tick, s.
inline constexpr double lab_dt = 1.0 / 60.0;

/// A rectangular room from (0, 0) to (width, height) and the robot in it. The defaults are the
/// lab's: a window of 640 × 480 pixels of 1 cm, written as the products whose rounding the lab has.
struct LabWorld {
    double width = 640 * 0.01;                            ///< m
    double height = 480 * 0.01;                           ///< m
    double radius = 0.34 / 2.0;                           ///< m, of the robot; above 0
    Pose start{0.01 * 640 / 2.0, 0.01 * 480 / 2.0, 0.0};  ///< where a run begins

    friend bool operator==(const LabWorld&, const LabWorld&) = default;
};

/// The walls that a disc touches or has passed; touching exactly counts.
struct Contacts {
    bool left = false;
    bool right = false;
    bool top = false;
    bool bottom = false;

    constexpr bool any() const { return left || right || top || bottom; }
    friend bool operator==(const Contacts&, const Contacts&) = default;
};

/// The walls touched by the robot's disc centred at (x, y), in m.
constexpr Contacts contacts(const LabWorld& world, double x, double y) {
    return {.left = x - world.radius <= 0.0,
            .right = x + world.radius >= world.width,
            .top = y - world.radius <= 0.0,
            .bottom = y + world.radius >= world.height};
}

/// A robot at the world's start, at rest, its bumper released.
Roomba at_start(const LabWorld& world);

/// First half of a tick: moves a robot that touches a wall to where it just touches it, and sets
/// the bumper to whether there was one. Walls are found from the pose before any correction; in a
/// room narrower than the robot the right and the bottom wall win.
void sense(const LabWorld& world, Roomba& robot);

/// Second half of a tick: drives for `dt` seconds with the commanded velocity, which becomes the
/// measured one. Follows the exact arc, or the chord through its middle heading below 0.001 rad/s.
/// Walls do not stop it: the next `sense` does.
void move(Roomba& robot, double dt);

}  // namespace trellis
