// Keeping and thinning out the points of a trail.
// SPDX-License-Identifier: MIT
#include "sim/trail.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace trellis {
namespace {

Eigen::Vector2d position(const TrailPoint& point) {
    return {point.x, point.y};
}

/// Square of the distance in m from `p` to the segment from `a` to `b`.
double squared_distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = b - a;
    const double length = along.squaredNorm();
    const double part = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (p - (a + part * along)).squaredNorm();
}

}  // namespace

void Trail::add(const TrailPoint& point) {
    // dropping half of a full buffer at once keeps the kept points adjacent and add cheap
    if (limit_ != 0 && points_.size() == 2 * limit_)
        points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(limit_));
    points_.push_back(point);
}

std::span<const TrailPoint> Trail::points() const {
    const std::span<const TrailPoint> all(points_);
    return limit_ == 0 || all.size() <= limit_ ? all : all.last(limit_);
}

Pixel lab_pixel(double x, double y) {
    return {std::lrint(100.0 * x), std::lrint(100.0 * y)};
}

std::vector<std::size_t> simplified(std::span<const TrailPoint> points, double tolerance) {
    // the recursion is quadratic where nothing can be left out, so it gets bounded pieces
    constexpr std::size_t piece = 256;
    std::vector<std::size_t> kept;
    if (points.empty()) return kept;
    kept.push_back(0);

    std::vector<std::pair<std::size_t, std::size_t>> open;
    for (std::size_t begin = 0; begin + 1 < points.size(); begin += piece) {
        open.emplace_back(begin, std::min(begin + piece, points.size() - 1));
        while (!open.empty()) {
            const auto [first, last] = open.back();
            open.pop_back();
            const Eigen::Vector2d a = position(points[first]);
            const Eigen::Vector2d b = position(points[last]);
            std::size_t farthest = last;
            double distance = tolerance * tolerance;
            for (std::size_t i = first + 1; i < last; ++i) {
                const double d = squared_distance(position(points[i]), a, b);
                if (d > distance) {
                    distance = d;
                    farthest = i;
                }
            }
            if (farthest == last) {
                kept.push_back(last);
            } else {  // the first half is taken first
                open.emplace_back(farthest, last);
                open.emplace_back(first, farthest);
            }
        }
    }
    return kept;
}

}  // namespace trellis
