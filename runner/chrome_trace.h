// A recorded run in the Trace Event Format of Chrome, which chrome://tracing and Perfetto open.
// Covered by tests/runner/trace_convert_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "runner/recording.h"

#include <string>

namespace trellis {

/// One JSON object. Each time a node or state runs is a pair of B and E events, with what came of
/// it as argument `result`; transitions, logs, errors and skipped nodes are instants. What runs
/// inside something stands on its track, a second thing inside it at the same time on one of its
/// own.
///
/// Times are microseconds: tick × dt after `start` (s), and one more for each earlier event of the
/// same tick, so that their order and what takes no time can be seen.
std::string chrome_trace(const Recording& recording, const Program& program, double start);

}  // namespace trellis
