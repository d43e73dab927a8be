// The results of a sweep as rows, one for each run and each of its times, in the order of the runs'
// numbers: comma-separated values or JSON Lines. A function of plan and results, so that however
// they came about, equal ones give equal bytes. Covered by tests/runner/sweep_rows_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/sweep/journal.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace trellis {

enum class RowFormat : std::uint8_t { csv, json_lines };

/// What a run came to at one of its times, in the units of a row.
struct RowValues {
    double covered = 0.0;  ///< % of the reachable area
    double path = 0.0;     ///< m
    double overlap = 0.0;  ///< times that the covered area was swept
    double turns = 0.0;
    double bumps = 0.0;
    double largest_gap = 0.0;  ///< m²
    double dirt = 0.0;         ///< spots collected
    double ended = 0.0;        ///< s
    Ending ending = Ending::time;
};
RowValues values_of(const SweepPlan& plan, std::uint64_t run, const Measures& stop);

/// When a milestone was reached, s; none if it was not by the time of `stop`.
std::optional<double> reached_by(const SweepPlan& plan, const MeasuredRun& run,
                                 const Measures& stop, std::size_t milestone);

/// The columns, as a line; empty for JSON Lines.
std::string rows_header(const SweepPlan& plan, RowFormat format);

/// The rows of one run.
std::string rows_of(const SweepPlan& plan, std::uint64_t number, const MeasuredRun& run,
                    RowFormat format);

}  // namespace trellis
