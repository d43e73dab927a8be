// How much of the floor a run has cleaned, and how well, said to people and to programs. What is
// measured is in sim/coverage.h. Covered by tests/runner/coverage_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/json_writer.h"
#include "runner/tally.h"
#include "sim/coverage.h"

#include <cstdint>
#include <string>

namespace trellis {

/// What a coverage report says; the objects must outlive it.
struct CoverageReport {
    const Coverage& coverage;
    const Tally& tally;
    std::uint64_t ticks = 0;  ///< of the run
    double dt = lab_dt;       ///< s
};

/// Lines of facts, then two tables: when a part of the floor was covered, and how much was covered
/// after each tenth of the run.
std::string coverage_text(const CoverageReport& report);

/// The same as the member "coverage" of the open object; numbers in full, null for a part that was
/// never covered.
void add_coverage(JsonWriter& json, const CoverageReport& report);

}  // namespace trellis
