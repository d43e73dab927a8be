// Columns and rounded numbers.
// SPDX-License-Identifier: MIT
#include "runner/table.h"

#include <doctest/doctest.h>

using namespace trellis;

TEST_CASE("table: numbers with a fixed number of digits, zero without a sign") {
    CHECK(fixed(2.5, 3) == "2.500");
    CHECK(fixed(-2.5, 0) == "-2");
    CHECK(fixed(-0.0004, 3) == "0.000");
    CHECK(fixed(1e300, 0).size() == 301);
}

TEST_CASE("table: the first column to the left, the others to the right") {
    CHECK(aligned({{"name", "n", "x"}, {"é", "10"}, {"", "1", "long"}}) == "name   n     x\n"
                                                                           "é     10\n"
                                                                           "       1  long\n");
}

TEST_CASE("table: numbers without a point that says nothing") {
    CHECK(brief(60.0) == "60");
    CHECK(brief(0.1) == "0.1");
    CHECK(brief(-2.0) == "-2");
}
