// How much of the floor a robot has cleaned: the area swept by its disc, on the cells of a Floor. A
// value: copy it with the run that it belongs to. It draws nothing and knows no behaviour. Covered
// by tests/sim/coverage_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/floor.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace trellis {

/// The cells covered since the run began. A cell is covered when its centre comes within the
/// robot's radius of its centre's way. That is exact to 0.4 cells: the way is taken as straight
/// lines between positions that far apart, or a tick's move where that is longer; bends of the
/// lab's spiral then err by less than 1 mm.
class Coverage {
public:
    /// Nothing is covered. `floor` must outlive it.
    explicit Coverage(const Floor& floor);

    /// The robot's centre has come to (x, y), in m, at the end of tick `tick`; ticks never
    /// decrease. The first call is the start. A position outside the floor counts as the nearest
    /// one inside, one that is not finite does not count.
    void add(double x, double y, std::uint64_t tick) {
        x = floor_->allowed_x(x);
        y = floor_->allowed_y(y);
        const double dx = x - checked_x_;
        const double dy = y - checked_y_;
        if (!(dx * dx + dy * dy < step_squared_)) sweep_to(x, y, tick);
    }

    const Floor& floor() const { return *floor_; }
    /// Reachable cells that are not covered.
    const CellSet& open() const { return open_; }
    std::size_t covered_count() const { return covered_at_.size(); }
    /// Covered, m².
    double area() const;
    /// Covered part of the reachable area, from 0 to 1; 0 where nothing can be reached.
    double share() const;
    /// The part that was covered at the end of that tick, and its number of cells.
    double share_at(std::uint64_t tick) const;
    std::size_t count_at(std::uint64_t tick) const;
    /// The tick in which that part, from 0 to 1, was covered; none if it never was.
    std::optional<std::uint64_t> tick_of(double share) const;
    /// The largest piece of reachable floor in one piece that is not covered, m². Cells belong
    /// together when they share a side.
    double largest_gap() const;
    /// Its number of cells.
    std::size_t largest_gap_count() const;

private:
    struct Place {
        double x, y;  // m
    };

    void sweep_to(double x, double y, std::uint64_t tick);
    void sweep_piece(Place to, std::uint64_t tick);

    const Floor* floor_;
    CellSet open_;
    std::vector<std::uint64_t> covered_at_;  // ticks, one for each covered cell

    // the place up to which the way is swept, and how far from it the next sweep is due
    double checked_x_ = 0.0;
    double checked_y_ = 0.0;
    double step_squared_ = -1.0;  // m²; below 0 before the start
};

}  // namespace trellis
