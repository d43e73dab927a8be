// What a behaviour did as JSON Lines: one object per event. Text only; the caller writes it to a
// file. Covered by tests/runner/event_lines_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/trace.h"

#include <string>

namespace trellis {

/// Appends the event as a line with the members tick, event, row and name, and by kind
///   tick        status: what the leaf returned
///   transition  index: which of the program's; to: the targets' names
///   log, error  text
/// or nothing for a stored status and for an event taken from a queue, which follow from the
/// others.
void append_event_line(std::string& out, const Program& program, const TraceEvent& event);

}  // namespace trellis
