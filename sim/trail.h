// Where a robot has been: one point per tick, for drawings. Knows no colours and no formats
// (sim/trail_svg.h has them). Covered by tests/sim/trail_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trellis {

/// The robot at the beginning of a tick, before the collision corrects its pose, and what it did in
/// that tick: the way from here to the next point is this leaf's.
struct TrailPoint {
    static constexpr std::uint16_t no_leaf = 0xFFFF;

    double x = 0.0;                ///< m
    double y = 0.0;                ///< m
    std::uint16_t leaf = no_leaf;  ///< index into a list of names that the caller keeps

    friend bool operator==(const TrailPoint&, const TrailPoint&) = default;
};

/// The points of a run in the order of its ticks: all of them, or the newest.
class Trail {
public:
    /// How many points the lab keeps: 33.3 s of its ticks.
    static constexpr std::size_t lab_limit = 2000;

    /// Keeps the newest `limit` points; 0 keeps every point.
    explicit Trail(std::size_t limit = 0) : limit_(limit) {}

    void add(const TrailPoint& point);

    /// The kept points, oldest first; valid until the next add.
    std::span<const TrailPoint> points() const;

private:
    std::vector<TrailPoint> points_;  // with a limit, up to twice as many as are kept
    std::size_t limit_;
};

/// A point of the lab's window; y grows downwards.
struct Pixel {
    long x = 0;
    long y = 0;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// The pixel at which the lab draws a position given in m: 100 pixels per metre, halves to even.
Pixel lab_pixel(double x, double y);

/// Indices of points that tell the same way within `tolerance` m, first and last included: every
/// point left out is that near to the line between its kept neighbours (Ramer, Douglas, Peucker).
/// Empty for no points.
std::vector<std::size_t> simplified(std::span<const TrailPoint> points, double tolerance);

}  // namespace trellis
