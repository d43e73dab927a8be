// Files of random numbers.
// SPDX-License-Identifier: MIT
#include "runner/draws.h"

#include <doctest/doctest.h>

using namespace trellis;

TEST_CASE("draws: decimal and hexadecimal numbers, comments and empty lines") {
    Diagnostics diagnostics;
    const auto draws = read_draws("a.txt",
                                  "# angles\n"
                                  "0x1.8p+0  # 1.5\n"
                                  "\n"
                                  "  -2.5\r\n"
                                  "1e-3",
                                  diagnostics);
    CHECK(draws == std::vector{1.5, -2.5, 0.001});
    CHECK(diagnostics.all().empty());
}

TEST_CASE("draws: each faulty line is said, with its place") {
    Diagnostics diagnostics;
    CHECK(read_draws("a.txt", "1\n  two # 2\ninf\n3,5\n", diagnostics) == std::vector{1.0});
    CHECK(diagnostics.render() ==
          "a.txt:2:3: error: expected a number, found \"two\" [bad-number]\n"
          "  two # 2\n"
          "  ^\n"
          "a.txt:3:1: error: expected a number, found \"inf\" [bad-number]\n"
          "inf\n"
          "^\n"
          "a.txt:4:1: error: expected a number, found \"3,5\" [bad-number]\n"
          "3,5\n"
          "^\n"
          "3 errors\n");
}
