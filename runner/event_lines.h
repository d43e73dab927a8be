// What a behaviour did as JSON Lines: one object per event. Text only; the caller writes it to a
// file. Covered by tests/runner/event_lines_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/trace.h"

#include <string>
#include <string_view>

namespace trellis {

/// How event lines call a kind of event: "tick", "halt", "enter", "leave", "transition", "log",
/// "error"; empty for kinds that have no line (stored statuses, and events taken from a queue).
std::string_view event_word(TraceEvent::Kind kind);

/// Appends the event as a line with the members tick, event, row and name, and by kind
///   tick        status: what the leaf returned
///   transition  index: which of the program's; to: the targets' names
///   log, error  text
/// or nothing if its kind has no line.
void append_event_line(std::string& out, const Program& program, const TraceEvent& event);

}  // namespace trellis
