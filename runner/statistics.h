// The runs of a comparison as numbers: mean and spread of what the tallies hold. Covered by
// tests/runner/statistics_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/comparison.h"

#include <string>
#include <vector>

namespace trellis {

/// Mean and standard deviation (of a sample; 0 for one value). Both 0 for no values.
struct Spread {
    double mean = 0.0;
    double deviation = 0.0;
};
Spread spread(const std::vector<double>& values);

/// One line of the statistics, for both behaviours.
struct Statistic {
    std::string name;   ///< "share of MoveForward"
    std::string unit;   ///< "%", "m"; empty: a number of times
    bool has_a = true;  ///< false: the behaviour has no such label
    bool has_b = true;
    Spread a = {};
    Spread b = {};
};

/// Share of the time and number of entries of each label, bumps, distance driven: over all matches.
std::vector<Statistic> statistics(const std::vector<Match>& matches);

}  // namespace trellis
