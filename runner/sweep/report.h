// A sweep as one self-contained page: curves of coverage with bands of percentiles, a table, a heat
// map over two parameters, and the trails of the best and the worst run with the commands that
// repeat them; light or dark as the reader's system is. A function of its arguments: equal sweeps
// give equal bytes. Covered by tests/runner/sweep_report_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/sweep/journal.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace trellis {

/// The page, as HTML. All runs must be done.
std::string sweep_report(const SweepPlan& plan, const Results& results);

/// Curves of the cases of one world, as SVG whose colours are the page's: the median, and bands
/// from the 25th to the 75th percentile. More than eight cases: those that cover most.
std::string coverage_chart(const SweepPlan& plan, const Results& results, std::size_t world);

/// What is covered on average, for each pair of values of the first two parameters that a behaviour
/// has, in one world, at the longest time; empty if it has no two with several values. Further
/// parameters have their first value.
std::string parameter_map(const SweepPlan& plan, const Results& results, std::size_t behaviour,
                          std::size_t world);

/// The command that repeats a run, up to a time (s).
std::string command_of(const SweepPlan& plan, std::uint64_t run, double time);

}  // namespace trellis
