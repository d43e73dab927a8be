// The runs of a sweep as numbers: means with their intervals and percentiles over the seeds, and
// what differs between two cases on equal seeds. Prints nothing (summary_report.h). Covered by
// tests/runner/sweep_summary_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/sweep/rows.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace trellis {

/// Which percentiles are told.
inline constexpr std::array<int, 5> percentiles{5, 25, 50, 75, 95};

/// The distribution of a measure over the seeds.
struct Distribution {
    std::size_t count = 0;
    double mean = 0.0;
    double deviation = 0.0;   ///< standard deviation of a sample; 0 for one value
    double half_width = 0.0;  ///< the mean's 95 % interval is mean ± this; 0 for one value
    std::array<double, percentiles.size()> percentile{};
};
/// All 0 for no values. The interval is Student's.
Distribution distribution(std::vector<double> values);

/// The percentile of sorted values, interpolated linearly between them (Hyndman and Fan's type 7,
/// as NumPy's default); `percent` is 0 to 100, `sorted` not empty.
double percentile(const std::vector<double>& sorted, double percent);

/// Student's t for a two-sided interval of 95 %, by degrees of freedom, at least 1; exact to 0.5 %.
double student_95(std::size_t freedom);

/// What there is to tell about a measure.
struct MeasureSummary {
    std::string name;  ///< that of its column
    std::string unit;  ///< "%", "m"; empty: a number
    Distribution over_seeds;
};

/// All seeds of a case, at one of the times.
struct CaseSummary {
    std::size_t number = 0;                                      ///< SweepPlan::cases
    std::size_t time = 0;                                        ///< SweepSpec::times
    std::vector<MeasureSummary> measures;                        ///< coverage is the first
    std::array<std::vector<double>, milestones.size()> reached;  ///< s, sorted; of those that did
    std::vector<std::pair<Ending, std::size_t>> endings;         ///< those that there are
};

/// A case against the first of its world, seed by seed, at one of the times.
struct PairSummary {
    std::size_t number = 0, baseline = 0;  ///< SweepPlan::cases
    std::size_t time = 0;
    Distribution difference;                    ///< of the coverage, in %: case minus baseline
    std::size_t more = 0, less = 0, equal = 0;  ///< seeds on which it covers that
    /// 1: it covers more, -1: less, 0: the interval of the mean difference holds 0.
    int sign() const;
};

struct SweepSummary {
    std::vector<CaseSummary> cases;
    std::vector<PairSummary> pairs;
};

/// Of a sweep whose runs are all done.
SweepSummary summarised(const SweepPlan& plan, const Results& results);

/// A case in words: "roomba forward_time=10, lab".
std::string case_words(const SweepPlan& plan, const SweepCase& one);

}  // namespace trellis
