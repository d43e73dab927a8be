// A profile said to people and to programs. Covered by tests/runner/profile_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"
#include "runner/json_writer.h"
#include "runner/profile.h"

#include <cstdint>
#include <string>

namespace trellis {

/// What the numbers are of; the objects must outlive it.
struct ProfileReport {
    const Program& program;
    const Document& document;  ///< of the program's first file, for the words of transitions
    const Profile& profile;
    std::uint64_t ticks = 0;  ///< of the whole run
    double dt = 0.0;          ///< s
};

/// Trees: a line per node, and the nodes that were never reached, with their places. Machines: a
/// line per state and per transition, and what was never entered or taken.
std::string profile_text(const ProfileReport& report);

/// Adds the member "stats" to the object being written: {"rows": […], "transitions": […]}, numbers
/// in full. Rows are in the order of `trellis show --program`.
void add_profile(JsonWriter& json, const ProfileReport& report);

/// What a row is in the words of documents: "Sequence", "MoveForward", "SubTree", "state".
std::string_view kind_of(const Program& program, RowId n);

}  // namespace trellis
