// The parts of a picture that show a world of walls: rooms, walls, furniture, doors, dirt, the
// dock, where it was touched, and how often each cell of its floor was covered. One unit is 1 cm,
// the world's own origin. Covered by tests/sim/world_svg_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/floor.h"
#include "sim/trail.h"
#include "sim/walled_world.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace trellis {

/// Rooms and furniture, filled; dirt and dock. Drawn below everything else.
std::string ground_svg(const WalledWorld& world);

/// The walls. Drawn above the floor and below the trail.
std::string walls_svg(const WalledWorld& world);

/// Colours of cells that the disc came over once, twice, …; the last is of so often or more.
std::span<const char* const> heat_colours();

/// How often the disc came over each cell, row by row: it has to leave a cell to come again.
std::vector<int> passes(const Floor& floor, std::span<const TrailPoint> trail);

/// The passes as filled cells.
std::string heat_svg(const Floor& floor, std::span<const TrailPoint> trail);

/// Path data of a short line inwards at each place where a wall was touched, each once, and how
/// many points touched one.
struct TouchMarks {
    std::string path;
    std::size_t points = 0;
};
TouchMarks touch_marks(const WalledWorld& world, std::span<const TrailPoint> trail);

}  // namespace trellis
