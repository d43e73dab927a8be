// A comparison, said to people and to programs. Covered by tests/runner/compare_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/comparison.h"

#include <string>
#include <vector>

namespace trellis {

/// Where the runs part, in words, for each group of matches that part in the same way; then the
/// statistics over all of them. There must be at least one match.
std::string comparison_text(const std::vector<Match>& matches);

/// The same as one JSON object, match by match, numbers in full.
std::string comparison_json(const std::vector<Match>& matches);

}  // namespace trellis
