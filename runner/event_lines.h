// What a behaviour did as JSON Lines: one object per event, between a line that says which run it
// was and one that says how it ended. Text only; the caller writes it to a file, and recording.h
// reads it back. Covered by tests/runner/event_lines_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/trace.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace trellis {

/// What the first line of a file of events says of the run.
struct RunLine {
    std::string_view file;    ///< the behaviour, as the command line named it
    std::string_view tree;    ///< --tree; empty: not given
    double dt = 0.0;          ///< s
    std::string_view random;  ///< "seed 7", "draws angles.txt"
};

/// Appends the first line, with the members tick (0), event ("run"), row (0), name, file, tree (if
/// given), rows (how many the program has), dt and random.
void append_run_line(std::string& out, const Program& program, const RunLine& run);

/// Appends the event as a line with the members tick, event, row and name, and by kind
///   status      from, to: what is stored for a node of a tree, before and after
///   tick        status: what the leaf returned
///   transition  index: which of the program's; to: the targets' names
///   log, error  text
/// or nothing for a stored status of a state and for an event taken from a queue, which follow from
/// the others.
void append_event_line(std::string& out, const Program& program, const TraceEvent& event);

/// Appends the last line: `tick`, the last one that was run, event ("end") and text: `ended`.
void append_end_line(std::string& out, std::uint64_t tick, std::string_view ended);

}  // namespace trellis
