// Numbers and texts of SVG documents: rounding, signs, escaping, shortening.
// SPDX-License-Identifier: MIT
#include "sim/svg.h"

#include <doctest/doctest.h>

#include <limits>

using namespace trellis;

TEST_CASE("svg: a number has one decimal, or none where it would be 0") {
    CHECK(svg::number(12.34) == "12.3");
    CHECK(svg::number(7.0) == "7");
    CHECK(svg::number(-0.42) == "-0.4");
    CHECK(svg::number(-0.04) == "0");
    CHECK(svg::number(99.96) == "100");
}

TEST_CASE("svg: a number that no picture can show is cut or 0") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK(svg::number(infinity) == "1000000");
    CHECK(svg::number(-infinity) == "-1000000");
    CHECK(svg::number(std::numeric_limits<double>::quiet_NaN()) == "0");
}

TEST_CASE("svg: text is escaped, control characters become spaces") {
    CHECK(svg::escaped("a < b && \"c\" > d") == "a &lt; b &amp;&amp; &quot;c&quot; &gt; d");
    CHECK(svg::escaped("tab\tbell\a") == "tab bell ");
    CHECK(svg::escaped("número") == "número");
}

TEST_CASE("svg: text is shortened by letters, not by bytes") {
    CHECK(svg::letters("número…") == 7);
    CHECK(svg::shortened("número", 6) == "número");
    CHECK(svg::shortened("número", 5) == "núme…");
    CHECK(svg::shortened("número", 3) == "nú…");
    CHECK(svg::shortened("número", 1) == "…");
    CHECK(svg::shortened("número", 0) == "…");
    CHECK(svg::shortened("", 0).empty());
}
