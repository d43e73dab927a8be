// How far a robot drives, how often it turns on the spot and how often it bumps: what wheels and
// bumper say about a run. Covered by tests/runner/tally_test.cpp and
// tests/sim/measured_run_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/roomba.h"

#include <cmath>
#include <cstdint>

namespace trellis {

/// Sums over the ticks of one run; a value that goes with it.
struct Odometer {
    double distance = 0.0;    ///< m, driven by the wheels
    std::uint64_t turns = 0;  ///< how often it began to turn on the spot
    std::uint64_t bumps = 0;  ///< ticks in which the bumper was pressed
    bool turning = false;     ///< on the spot, in the last tick

    /// The robot at the end of a tick of `dt` s.
    void add(const Roomba& robot, double dt) {
        const bool turns_now = robot.v == 0.0 && robot.w != 0.0;
        turns += turns_now && !turning ? 1 : 0;
        turning = turns_now;
        bumps += robot.bumper ? 1 : 0;
        distance += std::fabs(robot.v) * dt;
    }

    /// The same for so many ticks in which the robot's velocity, but for its turning, and its
    /// bumper did not change; at least one.
    void add(const Roomba& robot, double dt, std::uint64_t ticks) {
        add(robot, dt);
        const auto more = static_cast<double>(ticks - 1);
        bumps += robot.bumper ? ticks - 1 : 0;
        distance += more * std::fabs(robot.v) * dt;
    }

    /// How many times over a robot of that radius (m) has swept the area it has covered (m²); 0 if
    /// it has covered none.
    double overlap(double radius, double covered) const {
        return covered == 0.0 ? 0.0 : distance * 2.0 * radius / covered;
    }

    friend bool operator==(const Odometer&, const Odometer&) = default;
};

}  // namespace trellis
