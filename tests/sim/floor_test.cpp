// Cells: which can be reached, and which are near.
// SPDX-License-Identifier: MIT
#include "sim/floor.h"

#include <doctest/doctest.h>

#include <cmath>

namespace trellis {
namespace {

TEST_CASE("floor: the lab's room is reachable but for its corners") {
    const Floor floor = floor_of(LabWorld{});
    CHECK(floor.grid() ==
          CellGrid{.left = 0.0, .top = 0.0, .cell = 0.05, .columns = 128, .rows = 96});
    CHECK(floor.reachable_count() == 128 * 96 - 4 * 3);
    CHECK_FALSE(floor.reachable().contains(0, 0));
    CHECK_FALSE(floor.reachable().contains(1, 0));
    CHECK_FALSE(floor.reachable().contains(127, 94));
    CHECK(floor.reachable().contains(1, 1));
    CHECK(floor.area() == doctest::Approx(30.69));
}

TEST_CASE("floor: finer cells come closer to the exact area") {
    // the room without what a disc leaves in four corners
    const double exact = 6.4 * 4.8 - (4.0 - 3.14159265358979) * 0.17 * 0.17;
    CHECK(floor_of(LabWorld{}, 0.01).area() == doctest::Approx(exact).epsilon(1e-4));
    CHECK(floor_of(LabWorld{}, 0.1).area() == doctest::Approx(exact).epsilon(2e-3));
}

TEST_CASE("floor: cells that do not divide the room reach beyond it") {
    const CellGrid grid = grid_over({{-1.0, 2.0}, {0.0, 2.5}}, 0.3);
    CHECK(grid.columns == 4);
    CHECK(grid.rows == 2);
    CHECK(grid.centre_x(0) == doctest::Approx(-0.85));
    CHECK(grid.centre_y(1) == doctest::Approx(2.45));
}

TEST_CASE("floor: a room narrower than the robot has a line of places") {
    const Floor floor = floor_of({.width = 0.2, .height = 1.0});
    CHECK(floor.allowed_x(5.0) == 0.17);
    CHECK(floor.allowed_x(-5.0) == 0.17);
    CHECK(floor.reachable_count() > 0);
}

TEST_CASE("floor: near finds every cell within the radius and the margin") {
    const Floor floor = floor_of(LabWorld{});
    const double cell = floor.grid().cell;
    for (double part_x = 0.0; part_x < 1.0; part_x += 0.0625) {
        for (double part_y = 0.0; part_y < 1.0; part_y += 0.0625) {
            const std::span<const CellSpan> spans = floor.near(part_x, part_y);
            for (int row = -10; row <= 10; ++row) {
                const int i = row - floor.first_offset();
                for (int column = -10; column <= 10; ++column) {
                    const double distance =
                        std::hypot(column + 0.5 - part_x, row + 0.5 - part_y) * cell;
                    const bool found = i >= 0 && i < static_cast<int>(spans.size()) &&
                                       column >= spans[static_cast<std::size_t>(i)].first &&
                                       column <= spans[static_cast<std::size_t>(i)].last;
                    if (distance <= floor.radius() + floor.margin()) CHECK(found);
                    if (distance > floor.radius() + 1.5 * floor.margin()) CHECK_FALSE(found);
                }
            }
        }
    }
}

}  // namespace
}  // namespace trellis
