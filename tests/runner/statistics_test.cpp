// Means and spreads.
// SPDX-License-Identifier: MIT
#include "runner/statistics.h"

#include <doctest/doctest.h>

using namespace trellis;

TEST_CASE("statistics: mean and deviation of a sample") {
    CHECK(spread({}).mean == 0.0);
    CHECK(spread({3.0}).mean == 3.0);
    CHECK(spread({3.0}).deviation == 0.0);
    CHECK(spread({1.0, 2.0, 3.0}).mean == 2.0);
    CHECK(spread({1.0, 2.0, 3.0}).deviation == 1.0);
    CHECK(statistics({}).empty());
}
