// The parts of a picture of a world: passes over cells and marks at walls. How the picture looks is
// for people to see.
// SPDX-License-Identifier: MIT
#include "sim/world_svg.h"

#include "sim/trail_svg.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace trellis {
namespace {

std::vector<TrailPoint> line(double from, double to, int points) {
    std::vector<TrailPoint> trail;
    for (int i = 0; i < points; ++i)
        trail.push_back({.x = from + (to - from) * i / (points - 1), .y = 2.4});
    return trail;
}

TEST_CASE("world svg: a cell is passed again only after the disc has left it") {
    const Floor floor = floor_of(LabWorld{}, 0.1);
    std::vector<TrailPoint> trail = line(1.0, 3.0, 100);
    const std::vector<int> once = passes(floor, trail);
    CHECK(*std::max_element(once.begin(), once.end()) == 1);
    const std::vector<TrailPoint> back = line(3.0, 1.0, 100);
    trail.insert(trail.end(), back.begin(), back.end());
    const std::vector<int> count = passes(floor, trail);
    const auto at = [&](int column) { return count[static_cast<std::size_t>(24 * 64 + column)]; };
    CHECK(at(11) == 2);  // left and come to again
    CHECK(at(29) == 1);  // under the disc while it turned round
    CHECK(at(50) == 0);
}

TEST_CASE("world svg: each touched place has one mark, each touching point counts") {
    const WalledWorld world(lab_room());
    const std::vector<TrailPoint> trail{
        {.x = 6.23, .y = 2.4}, {.x = 6.23, .y = 2.4}, {.x = 3, .y = 2}};
    const TouchMarks marks = touch_marks(world, trail);
    CHECK(marks.points == 2);
    CHECK(marks.path == "M640 240l-8 0");
}

TEST_CASE("world svg: the picture of a run has its world in it") {
    World plan = lab_room();
    plan.dirt = {{.centre = {1.0, 1.0}, .radius = 0.1}};
    plan.docks = {{.place = {6.0, 0.5}}};
    plan.furniture = {{.name = "", .corners = {{4, 3}, {5, 3}, {5, 4}}}};
    const WalledWorld world(plan);
    const Floor floor = floor_of(world.walls, {3.2, 2.4});
    const std::string svg =
        trail_svg({}, line(1.0, 3.0, 100), {.x = 3.0, .y = 2.4},
                  {.title = "x", .walled = &world, .floor = &floor, .start = {1.0, 2.4, 0.0}});
    CHECK(svg.find("<path fill=\"#d9d4c7\" d=\"M400 300L500 300L500 400z\"/>") !=
          std::string::npos);
    CHECK(svg.find(">dock</text>") != std::string::npos);
    CHECK(svg.find(">dirt</text>") != std::string::npos);
    CHECK(svg.find(">5+×</text>") != std::string::npos);
}

}  // namespace
}  // namespace trellis
