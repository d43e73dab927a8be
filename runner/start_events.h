// What a machine does before its first tick, told to a trace. Covered by
// tests/runner/start_events_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/trace.h"
#include "sim/bridge/episode.h"

namespace trellis {

/// Tells `sink` what happened when `episode` was made, which traces nothing: the states that were
/// entered, and what their content did. The start is made once more for that; it is the same, since
/// a run is determined by how it begins. Call it before the first tick.
void trace_start(const Episode& episode, TraceSink& sink);

}  // namespace trellis
