// Reading a world file: JSON text to a World, with everything that is wrong in it. What its members
// are called is in world_grammar.def. It opens no file. Covered by tests/sim/world_file_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"
#include "sim/world.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace trellis {

/// The world that `text` describes; none after errors. `file` is the text's index in `diagnostics`.
/// Warnings, such as a room that the robot cannot reach, do not keep it from being returned.
///
/// Errors, besides those of parse_json() and check_file(): "world-outline" (an outline crosses
/// itself or a room's corner repeats), "world-door" (a door lies on no wall), "world-start" (the
/// robot does not fit there). Warnings: "world-unreachable" (a room, dirt or the dock).
std::optional<World> read_world(std::string_view text, std::uint32_t file,
                                Diagnostics& diagnostics);

}  // namespace trellis
