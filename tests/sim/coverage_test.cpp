// Covered area, held against a slow and obvious reference: the distance of every cell from every
// position of the way.
// SPDX-License-Identifier: MIT
#include "sim/coverage.h"

#include "core/random.h"
#include "support/hand_written.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace trellis {
namespace {

/// Whether the disc, `wider` m larger, covers that centre of a cell from a position on the way.
struct Reference {
    std::vector<double> nearest_squared;  // by cell, m²

    explicit Reference(const CellGrid& grid) : nearest_squared(grid.count(), 1e9) {}

    void add(const CellGrid& grid, double x, double y) {
        for (int row = 0; row < grid.rows; ++row) {
            for (int column = 0; column < grid.columns; ++column) {
                const double dx = grid.centre_x(column) - x;
                const double dy = grid.centre_y(row) - y;
                double& nearest =
                    nearest_squared[static_cast<std::size_t>(row * grid.columns + column)];
                nearest = std::min(nearest, dx * dx + dy * dy);
            }
        }
    }
};

TEST_CASE("coverage: a robot at rest covers its disc") {
    const Floor floor = floor_of(LabWorld{}, 0.01);
    Coverage coverage(floor);
    CHECK(coverage.share() == 0.0);
    coverage.add(3.2, 2.4, 0);
    CHECK(coverage.area() == doctest::Approx(std::numbers::pi * 0.17 * 0.17).epsilon(0.005));
    coverage.add(3.2, 2.4, 1);
    CHECK(coverage.covered_count() + coverage.open().size() == floor.reachable_count());
}

TEST_CASE("coverage: one long move sweeps everything between its ends") {
    const Floor floor = floor_of(LabWorld{}, 0.02);
    Coverage coverage(floor);
    coverage.add(1.0, 1.0, 0);
    coverage.add(4.0, 3.0, 1);
    const double swath = 2.0 * 0.17 * std::hypot(3.0, 2.0) + std::numbers::pi * 0.17 * 0.17;
    CHECK(coverage.area() == doctest::Approx(swath).epsilon(0.005));
}

TEST_CASE("coverage: a whole run is exact to a part of a cell") {
    for (const double cell : {0.03, 0.05, 0.2}) {
        const Floor floor = floor_of(LabWorld{}, cell);
        const CellGrid& grid = floor.grid();
        Coverage coverage(floor);
        Reference reference(grid);
        const std::vector<double> angles{1.0, -2.0, 0.7, 3.0, -0.4};
        const LabWorld world;
        Roomba robot = at_start(world);
        test::HandWrittenFsm behaviour{test::Angles(angles)};
        for (std::uint64_t tick = 0; tick < 4000; ++tick) {
            sense(world, robot);
            reference.add(grid, robot.x, robot.y);
            coverage.add(robot.x, robot.y, tick);
            behaviour.tick(robot);
            move(robot, lab_dt);
        }
        const double radius = floor.radius();
        int wrong = 0;
        for (int row = 0; row < grid.rows; ++row) {
            for (int column = 0; column < grid.columns; ++column) {
                const double nearest = std::sqrt(
                    reference
                        .nearest_squared[static_cast<std::size_t>(row * grid.columns + column)]);
                const bool covered = floor.reachable().contains(column, row) &&
                                     !coverage.open().contains(column, row);
                if (covered && nearest > radius + 0.001) ++wrong;
                if (!covered && floor.reachable().contains(column, row) &&
                    nearest < radius - 0.4 * cell)
                    ++wrong;
            }
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("coverage: ticks and shares are told for any time and any part") {
    const Floor floor = floor_of({.width = 2.0, .height = 0.34});
    Coverage coverage(floor);
    for (std::uint64_t tick = 0; tick <= 83; ++tick)
        coverage.add(0.17 + 0.02 * static_cast<double>(tick), 0.17, tick);
    CHECK(coverage.share() == doctest::Approx(1.0).epsilon(0.02));
    CHECK(coverage.share_at(0) > 0.1);
    CHECK(coverage.share_at(0) < 0.2);
    CHECK(coverage.share_at(83) == coverage.share());
    REQUIRE(coverage.tick_of(0.5));
    const std::uint64_t half = *coverage.tick_of(0.5);
    CHECK(coverage.share_at(half) >= 0.5);
    CHECK(coverage.share_at(half - 1) < 0.5);
    CHECK_FALSE(coverage.tick_of(1.01));
}

TEST_CASE("coverage: the largest gap is the larger side of a crossing") {
    const Floor floor = floor_of({.width = 4.0, .height = 2.0});
    Coverage coverage(floor);
    CHECK(coverage.largest_gap() == doctest::Approx(floor.area()));
    coverage.add(1.0, 0.17, 0);
    coverage.add(1.0, 1.83, 1);
    CHECK(coverage.largest_gap() == doctest::Approx((4.0 - 1.17) * 2.0).epsilon(0.02));
}

TEST_CASE("coverage: positions outside count as the nearest inside, those that are none do not") {
    const Floor floor = floor_of(LabWorld{});
    Coverage outside(floor);
    outside.add(-100.0, 2.4, 0);
    Coverage inside(floor);
    inside.add(0.17, 2.4, 0);
    CHECK(outside.open() == inside.open());
    inside.add(std::numeric_limits<double>::quiet_NaN(), 1.0, 1);
    inside.add(1.0, std::numeric_limits<double>::quiet_NaN(), 2);
    CHECK(outside.open() == inside.open());
    inside.add(0.17, 2.4, 3);
    CHECK(outside.open() == inside.open());
}

}  // namespace
}  // namespace trellis
