// The picture of a run: lines by leaf, colours, marks, legend, texts, size. What it looks like was
// judged by eye; this holds what the eye saw.
// SPDX-License-Identifier: MIT
#include "sim/trail_svg.h"

#include "sim/trail_lines.h"
#include "support/lab_reference.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

const LabWorld lab;
const std::vector<std::string> names = {"MoveForward", "MoveInSpiral", "GoBack", "Rotate"};

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

bool contains(std::string_view text, std::string_view part) {
    return count(text, part) != 0;
}

/// Forward for two ticks, a turn on the spot, back for one.
const std::vector<TrailPoint> there_and_back = {{3.2, 2.4, 0}, {3.3, 2.4, 0}, {3.4, 2.4, 3},
                                                {3.4, 2.4, 3}, {3.4, 2.4, 2}, {3.35, 2.4, 2}};

/// Ten minutes of the lab's machine, as they are drawn.
struct LabPicture {
    Trail trail;
    Roomba end;
};

LabPicture ten_minutes() {
    const std::vector<double> angles = {-1.67, 1.98, 1.72, -1.19, -1.28, 2.9, -2.2};
    const std::vector<LabRow> rows = run_lab_machine(lab, angles, 36'000);
    LabPicture picture;
    for (std::size_t tick = 1; tick < rows.size(); ++tick) {
        const auto leaf = std::find(names.begin(), names.end(), rows[tick].leaf) - names.begin();
        picture.trail.add({rows[tick - 1].x, rows[tick - 1].y, static_cast<std::uint16_t>(leaf)});
    }
    picture.end = {.x = rows.back().x, .y = rows.back().y, .rotation = rows.back().rotation};
    return picture;
}

}  // namespace

TEST_CASE("trail lines: each leaf has its ways, a dot where it stood, its ticks and its length") {
    const std::vector<LeafLines> leaves = leaf_lines(there_and_back, names);
    REQUIRE(leaves.size() == 5);
    CHECK(leaves[0].name == "MoveForward");
    CHECK(leaves[0].lines == "M320 240l20 0");
    CHECK(leaves[0].dots.empty());
    CHECK(leaves[0].ticks == 2);
    CHECK(leaves[0].length == doctest::Approx(0.2));
    CHECK(leaves[1].ticks == 0);
    CHECK(leaves[1].lines.empty());
    CHECK(leaves[2].lines == "M340 240l-5 0");
    CHECK(leaves[3].lines.empty());
    CHECK(leaves[3].dots == "M340 240h0");
    CHECK(leaves[3].ticks == 2);
    CHECK(leaves[4].name == "no leaf");
    CHECK(leaves[4].ticks == 0);
}

TEST_CASE("trail lines: ticks without a leaf, or of one that has no name, are no leaf's") {
    const std::vector<TrailPoint> trail = {{1, 1}, {2, 1, 7}, {3, 1, 0}, {4, 1}};
    const std::vector<LeafLines> leaves = leaf_lines(trail, {names.data(), 1});
    REQUIRE(leaves.size() == 2);
    CHECK(leaves[0].lines == "M300 100l100 0");
    CHECK(leaves[1].lines == "M100 100l200 0");
    CHECK(leaves[1].ticks == 2);
}

TEST_CASE("trail lines: no point and one point are no tick") {
    CHECK(red_line({}).lines.empty());
    CHECK(red_line({there_and_back.data(), 1}).ticks == 0);
    CHECK(red_line({there_and_back.data(), 1}).dots.empty());
}

TEST_CASE("trail lines: colours go by the order of the names, a second round is dashed") {
    const std::vector<std::string> many(15, "leaf");
    const std::vector<LeafLines> leaves = leaf_lines({}, many);
    CHECK(leaves[0].colour == "#0072b2");
    CHECK(leaves[0].dash.empty());
    CHECK(leaves[7].colour == "#0072b2");
    CHECK(leaves[7].dash == "7 4");
    CHECK(leaves[14].dash == "1 4");
    for (std::size_t i = 0; i < 7; ++i)
        for (std::size_t k = 0; k < i; ++k)
            CHECK(leaves[i].colour != leaves[k].colour);
}

TEST_CASE("trail svg: the lab's room is 640 by 480 pixels, with title, run and legend around it") {
    const Roomba end{.x = 3.35, .y = 2.4};
    const std::string svg = trail_svg(
        lab, there_and_back, end,
        {.title = "machines/roomba.scxml", .run = "seed 7", .seconds = 0.1, .leaves = names});
    CHECK(contains(svg, "<rect width=\"640\" height=\"480\""));
    CHECK(contains(svg, ">machines/roomba.scxml</text>"));
    CHECK(contains(svg, ">seed 7 · 0.1 s · 0 bumps</text>"));
    CHECK(contains(svg, ">1 m</text>"));
    CHECK(contains(svg, ">MoveForward 33.3 %</text>"));
    CHECK(contains(svg, ">Rotate 33.3 %</text>"));
    CHECK(contains(svg, ">start</text>"));
    CHECK_FALSE(contains(svg, "MoveInSpiral"));
    CHECK_FALSE(contains(svg, ">bump</text>"));
    CHECK_FALSE(contains(svg, "no leaf"));
}

TEST_CASE("trail svg: a bump is a short line at its wall, equal ones drawn once, all counted") {
    const std::vector<TrailPoint> trail = {
        {3.2, 2.4, 0}, {0.17, 2.0, 0}, {0.171, 2.0, 0}, {0.16, 2.001, 0}, {6.3, 4.7, 0}};
    const std::string svg = trail_svg(lab, trail, at_start(lab), {.leaves = names});
    CHECK(contains(svg, "d=\"M0 200h8M630 480v-8M640 470h-8\""));
    CHECK(contains(svg, ">0 s · 3 bumps</text>"));
    CHECK(contains(svg, ">bump</text>"));
}

TEST_CASE("trail svg: without names the trail is one red line that the legend calls trail") {
    const std::string svg = trail_svg(lab, there_and_back, at_start(lab), {.title = "x"});
    CHECK(contains(svg, "stroke=\"#e00000\""));
    CHECK(contains(svg, ">trail</text>"));
    CHECK_FALSE(contains(svg, "%</text>"));
}

TEST_CASE("trail svg: the lab's look is a red line of 4 pixels without marks and legend") {
    const std::string svg = trail_svg(lab, there_and_back, at_start(lab),
                                      {.title = "x", .leaves = names, .look = TrailLook::lab});
    CHECK(contains(svg, "stroke-width=\"4\""));
    CHECK(contains(svg, "stroke=\"#e00000\""));
    CHECK_FALSE(contains(svg, "start"));
    CHECK_FALSE(contains(svg, "MoveForward"));
}

TEST_CASE("trail svg: a trail that lost its beginning says how much it shows") {
    Trail trail(2);
    for (const TrailPoint& point : there_and_back)
        trail.add(point);
    const std::string svg = trail_svg(lab, trail.points(), at_start(lab), {.seconds = 0.1});
    CHECK(contains(svg, ">0.1 s · last 2 ticks · 0 bumps</text>"));
}

TEST_CASE("trail svg: any text and any pose make a well-formed picture") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<TrailPoint> wild = {{nan, 1.0, 0}, {infinity, -infinity, 1}, {1e300, 0, 0}};
    const std::vector<std::string> odd = {"<a & b>", std::string(500, 'x')};
    const std::string svg =
        trail_svg({.width = 1.0, .height = 0.5}, wild, {.x = nan, .rotation = nan},
                  {.title = "</text>\n<script>", .run = "\"\x01", .leaves = odd});
    CHECK_FALSE(contains(svg, "nan"));
    CHECK_FALSE(contains(svg, "inf"));
    CHECK_FALSE(contains(svg, "<script>"));
    CHECK_FALSE(contains(svg, std::string(33, 'x')));
    CHECK(contains(svg, "&lt;a &amp; b&gt;"));
    for (const std::string_view tag : {"g", "text", "svg", "title"})
        CHECK(count(svg, "<" + std::string(tag) + ">") + count(svg, "<" + std::string(tag) + " ") ==
              count(svg, "</" + std::string(tag) + ">"));
}

TEST_CASE("trail svg: ten minutes stay below 100 kB, equal runs give equal bytes") {
    const LabPicture run = ten_minutes();
    const TrailPicture words{.title = "x", .seconds = 600.0, .leaves = names};
    const std::string svg = trail_svg(lab, run.trail.points(), run.end, words);
    CHECK(svg.size() > 10'000);
    CHECK(svg.size() < 100'000);
    CHECK(svg == trail_svg(lab, run.trail.points(), run.end, words));
}
