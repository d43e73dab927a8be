// A world that is ready to be driven in: its description and its walls in a grid. Never changes, so
// that any number of runs share one. Covered by tests/sim/drive_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/floor.h"
#include "sim/roomba.h"
#include "sim/walls.h"
#include "sim/world.h"

namespace trellis {

struct WalledWorld {
    explicit WalledWorld(World of);

    World plan;
    Walls walls;
};

/// A robot with the world's body at `start`, at rest, its bumpers released, its battery as full as
/// the world says.
Roomba at_start(const WalledWorld& world, const Pose& start);

/// Whether the robot's disc can stand there: inside a room, outside furniture, clear of walls.
bool fits(const WalledWorld& world, Point place);

}  // namespace trellis
