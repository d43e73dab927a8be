// Paths and the frame of an SVG.
// SPDX-License-Identifier: MIT
#include "runner/drawing/canvas.h"

#include <doctest/doctest.h>

using namespace trellis::drawing;

TEST_CASE("canvas: a curve is straight between points above each other") {
    CHECK(vertical_curve({{1, 2}, {1, 9}}) == "M1 2V9");
    CHECK(vertical_curve({{1, 2}, {5, 10}, {5, 20}}) == "M1 2C1 6 5 6 5 10V20");
}

TEST_CASE("canvas: arrow heads point where they are told") {
    CHECK(arrow_head({10, 20}, 0, 1) == "M10 20L6 11L14 11z");
    CHECK(arrow_head({10, 20}, -1, 0) == "M10 20L19 24L19 16z");
}

TEST_CASE("canvas: a picture has a title, both colour schemes and a ground of its own") {
    Canvas canvas;
    canvas.open("", "more <here>");
    canvas.box({0, 0, 2000000.25, 4}, 3, "shape state");
    canvas.close();
    const std::string svg = canvas.finish({100, 50}, "a & b", "c");
    CHECK(svg.find("viewBox=\"-28 -28 156 106\"") != std::string::npos);
    CHECK(svg.find("<title>a &amp; b</title>") != std::string::npos);
    CHECK(svg.find("<title>more &lt;here&gt;</title>") != std::string::npos);
    CHECK(svg.find("width=\"2000000.3\" height=\"4\" rx=\"3\"") != std::string::npos);
    CHECK(svg.find("@media (prefers-color-scheme: dark)") != std::string::npos);
    CHECK(svg.find("class=\"ground\"") != std::string::npos);
}
