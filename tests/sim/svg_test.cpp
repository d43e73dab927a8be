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

TEST_CASE("svg: the width of a text counts letters by their kind, not bytes") {
    CHECK(svg::text_width("", 12.0) == 0.0);
    CHECK(svg::text_width("e", 10.0) == doctest::Approx(6.3));
    CHECK(svg::text_width("é", 10.0) == doctest::Approx(6.3));
    CHECK(svg::text_width("il", 10.0) < svg::text_width("ab", 10.0));
    CHECK(svg::text_width("AB", 10.0) > svg::text_width("ab", 10.0));
    CHECK(svg::text_width("abc", 20.0) == doctest::Approx(2.0 * svg::text_width("abc", 10.0)));
}

TEST_CASE("svg: a text is cut between letters to the given width, the ellipsis included") {
    // n, ú, e, r and o are 6.3 wide, m is 9.8, the ellipsis 10
    CHECK(svg::fitted("número", 41.4, 10.0) == "número");
    CHECK(svg::fitted("número", 41.2, 10.0) == "núme…");
    CHECK(svg::fitted("número", 38.6, 10.0) == "núm…");
    CHECK(svg::fitted("número", 23.0, 10.0) == "nú…");
    CHECK(svg::fitted("número", 10.0, 10.0) == "…");
    CHECK(svg::fitted("", 0.0, 10.0).empty());
}
