// Means, intervals and percentiles, held against values from tables.
// SPDX-License-Identifier: MIT
#include "runner/sweep/summary.h"

#include <doctest/doctest.h>

namespace trellis {

TEST_CASE("sweep summary: Student's t") {
    // two-sided 95 %, from any table
    CHECK(student_95(1) == doctest::Approx(12.7062).epsilon(1e-5));
    CHECK(student_95(2) == doctest::Approx(4.30265).epsilon(1e-5));
    CHECK(student_95(3) == doctest::Approx(3.18245).epsilon(0.005));
    CHECK(student_95(10) == doctest::Approx(2.22814).epsilon(1e-4));
    CHECK(student_95(399) == doctest::Approx(1.96593).epsilon(1e-5));
}

TEST_CASE("sweep summary: percentiles lie between values") {
    const std::vector<double> sorted{1.0, 2.0, 4.0, 8.0};
    CHECK(percentile(sorted, 0.0) == 1.0);
    CHECK(percentile(sorted, 50.0) == 3.0);
    CHECK(percentile(sorted, 100.0) == 8.0);
    CHECK(percentile(sorted, 5.0) == doctest::Approx(1.15));
    CHECK(percentile({7.0}, 95.0) == 7.0);
}

TEST_CASE("sweep summary: a distribution") {
    const Distribution d = distribution({3.0, 1.0, 2.0});
    CHECK(d.count == 3);
    CHECK(d.mean == 2.0);
    CHECK(d.deviation == 1.0);
    CHECK(d.half_width == doctest::Approx(4.30265 / 1.7320508).epsilon(1e-5));
    CHECK(d.percentile[2] == 2.0);
    CHECK(distribution({5.0}).half_width == 0.0);
    CHECK(distribution({}).count == 0);
}

TEST_CASE("sweep summary: the sign of a difference needs an interval without 0") {
    PairSummary pair;
    pair.difference = distribution({1.0, 2.0, 1.5, 1.2});
    CHECK(pair.sign() == 1);
    pair.difference = distribution({-1.0, -2.0, -1.5, -1.2});
    CHECK(pair.sign() == -1);
    pair.difference = distribution({-1.0, 2.0, -1.5, 1.2});
    CHECK(pair.sign() == 0);
    pair.difference = distribution({1.0});
    CHECK(pair.sign() == 0);
}

}  // namespace trellis
