// A run as rows of comma-separated values: one for the start, one for each tick. Text only; the
// caller writes it to a file. Covered by tests/runner/trace_csv_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/bridge/episode.h"

#include <string>
#include <string_view>

namespace trellis {

/// The first line of a trace, with its line feed. t is in s, x and y in m, rotation in rad, v in
/// m/s, w in rad/s; bumper is 0 or 1; leaf is what leaf_label() says.
inline constexpr std::string_view trace_csv_header = "tick,t,x,y,rotation,v,w,bumper,leaf\n";

/// Appends the row as a line. Numbers in their shortest form that reads back as the same double; a
/// leaf's name in quotes if it has a comma, a quote or a line end (RFC 4180).
void append_trace_csv(std::string& out, const EpisodeRow& row);

}  // namespace trellis
