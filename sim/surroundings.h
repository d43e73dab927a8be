// A run's own part of a world of walls: what the robot has cleaned, how full its battery is, what
// it touches; and what it senses of all that. Exact: noise is the bridge's business
// (sim/bridge/episode.h). Covered by tests/sim/surroundings_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/drive.h"
#include "sim/roomba.h"
#include "sim/walled_world.h"

#include <vector>

namespace trellis {

/// How long the robot has to be over a spot of dirt to clean it, s.
inline constexpr double cleaning_time = 4.0;

/// What changes in a world while a robot drives in it. A value that goes with the robot.
struct Surroundings {
    Drive drive;
    double battery = 1.0;      ///< of a full one
    std::vector<double> dirt;  ///< what is left, 1 to 0, in the order of the world's

    friend bool operator==(const Surroundings&, const Surroundings&) = default;
};

/// The surroundings before the first tick.
Surroundings surroundings_of(const World& world);

/// First half of a tick: writes the robot's bumpers and its other sensors.
void sense(const WalledWorld& world, const Surroundings& around, Roomba& robot);

/// Second half of a tick: drives among the walls, cleans what is under the robot, and charges or
/// empties the battery. An empty battery does not stop the robot: behaviours read it.
void move(const WalledWorld& world, Surroundings& around, Roomba& robot, double dt);

}  // namespace trellis
