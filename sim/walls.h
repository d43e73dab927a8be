// Finding walls: what a moving disc meets first, how near the nearest wall is, what a ray hits. The
// walls lie in a uniform grid, so that a question about a place looks at the walls around it only:
// a thousand cost little more than ten. Never changes once it is made. Covered by
// tests/sim/walls_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/world.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trellis {

/// The nearest wall to a place.
struct Nearest {
    Point place;            ///< on the wall
    double distance = 0.0;  ///< m
};

/// Where a moving disc first touches a wall.
struct Hit {
    double part = 1.0;  ///< of the way, 0 to 1; 1 if nothing is in the way
    Point normal;       ///< of length 1, from the wall to the disc's centre; (0, 0) if none
};

/// The walls of a world for one radius of disc.
class Walls {
public:
    /// `radius` of the disc in m, above 0. `bounds` hold every place that will be asked about.
    Walls(std::vector<Segment> segments, double radius, Bounds bounds);

    /// A wall as questions need it.
    struct Line {
        double x = 0.0, y = 0.0;              // m, its beginning
        double along_x = 0.0, along_y = 0.0;  // m, from there to its end
        double per_squared = 0.0;             // 1/m²: 1 / length²; 0 for a wall without length
    };

    const std::vector<Segment>& segments() const { return segments_; }
    double radius() const { return radius_; }  ///< m
    const Bounds& bounds() const { return bounds_; }

    /// How far a disc may move, or a ray go, in one question, m; above 0.
    double reach() const { return reach_; }

    /// What stops the disc whose centre goes straight from `from` to `to`, which is at most reach()
    /// away. A disc that touches a wall, or is in it by a rounding error, is stopped at once if the
    /// way leads closer to the wall by more than 1e-9 of its length, else not at all.
    Hit first_hit(Point from, Point to) const;

    /// The nearest wall within radius() + reach() of a place; at infinity if there is none.
    Nearest nearest(Point place) const;

    /// How far a ray from a place in the direction `angle` (rad) goes before it meets a wall, m; at
    /// most `most`. Walls do not stop a disc here: the ray is thin.
    double ray(Point from, double angle, double most) const;

private:
    /// The numbers of the walls within radius() + reach() of a place, and a few more.
    std::span<const std::uint32_t> around(Point place) const;

    std::vector<Segment> segments_;
    std::vector<Line> lines_;  // of the segments
    double radius_;
    Bounds bounds_;
    double reach_;
    double per_cell_ = 1.0;  // 1/m: cells in a metre
    int columns_ = 1;
    int rows_ = 1;
    std::vector<std::uint32_t> begins_;  // by cell: the first of its entries; one more at the end
    std::vector<std::uint32_t> entries_;
};

}  // namespace trellis
