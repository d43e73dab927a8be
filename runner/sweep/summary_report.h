// A summary said to people and to programs. Covered by tests/runner/sweep_summary_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/sweep/summary.h"

#include <string>

namespace trellis {

/// Tables of what was covered, and of the differences on equal seeds; a table for each time.
std::string summary_text(const SweepPlan& plan, const SweepSummary& summary);

/// Every number of the summary, as one JSON object.
std::string summary_json(const SweepPlan& plan, const SweepSummary& summary);

}  // namespace trellis
