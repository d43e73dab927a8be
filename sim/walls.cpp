// Discs and rays against line segments. A disc of radius r hits a segment where its centre hits the
// segment's outline at distance r: two parallel lines and a half circle around each end.
// SPDX-License-Identifier: MIT
#include "sim/walls.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace trellis {
namespace {

using Eigen::Vector2d;

/// Width of a cell of the grid, and how far a question may go, m. Larger ones list more walls for
/// each cell, smaller ones cost more questions for a ray.
constexpr double cell_width = 0.25;
/// More cells than that are made wider.
constexpr double most_cells = 250'000.0;
/// A way that leads this part of its length towards a wall runs along it: what is left of a way
/// that was turned along a wall does not meet the same wall again because of rounding.
constexpr double most_grazing = 1e-9;

Vector2d vector(Point p) {
    return {p.x, p.y};
}

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

Vector2d from_of(const Walls::Line& line) {
    return {line.x, line.y};
}

Vector2d along_of(const Walls::Line& line) {
    return {line.along_x, line.along_y};
}

Vector2d nearest_on(const Walls::Line& line, const Vector2d& place) {
    const Vector2d away = place - from_of(line);
    const double part = std::clamp(away.dot(along_of(line)) * line.per_squared, 0.0, 1.0);
    return from_of(line) + part * along_of(line);
}

/// The part of `way` after which a point that starts at `from` (relative to the circle's centre)
/// comes to within `radius` of it; above 1 if it does not.
double part_to_circle(const Vector2d& from, const Vector2d& way, double radius) {
    constexpr double none = 2.0;
    const double a = way.squaredNorm();
    const double b = from.dot(way);  // below 0: it comes nearer
    const double c = from.squaredNorm() - radius * radius;
    const double root = b * b - a * c;
    if (b >= 0.0 || root < 0.0) return none;
    return std::max(0.0, c) / (-b + std::sqrt(root));  // the smaller one, without cancellation
}

/// The same for the segment as a whole, for a disc that is clear of it.
double part_to_wall(const Walls::Line& wall, const Vector2d& from, const Vector2d& way,
                    double radius) {
    const Vector2d begin = from_of(wall);
    const Vector2d along = along_of(wall);
    const double length = along.norm();
    double part = std::min(part_to_circle(from - begin, way, radius),
                           part_to_circle(from - begin - along, way, radius));
    if (length == 0.0) return part;

    const double off = cross(along, from - begin) / length;  // signed distance from the line
    const double towards = cross(along, way) / length;
    // below 0 by rounding where the disc touches the line, by more where it is beyond an end
    const double gap = std::max(0.0, std::fabs(off) - radius);
    if (off * towards < 0.0) {
        const double at = gap / std::fabs(towards);
        const double beside = along.dot(from + at * way - begin);
        if (at < part && beside >= 0.0 && beside <= length * length) part = at;
    }
    return part;
}

/// Number of cells of a width over a size, at least one.
int cells_over(double size, double per_cell) {
    return std::max(1, static_cast<int>(std::ceil(size * per_cell)));
}

}  // namespace

Walls::Walls(std::vector<Segment> segments, double radius, Bounds bounds)
    : segments_(std::move(segments)), radius_(radius), bounds_(bounds), reach_(cell_width) {
    const double width = bounds.most.x - bounds.least.x;
    const double height = bounds.most.y - bounds.least.y;
    const double cell = std::max(cell_width, std::sqrt(width * height / most_cells));
    per_cell_ = 1.0 / cell;
    columns_ = cells_over(width, per_cell_);
    rows_ = cells_over(height, per_cell_);

    for (const Segment& wall : segments_) {
        const Vector2d along = vector(wall.to) - vector(wall.from);
        const double squared = along.squaredNorm();
        lines_.push_back({.x = wall.from.x,
                          .y = wall.from.y,
                          .along_x = along.x(),
                          .along_y = along.y(),
                          .per_squared = squared > 0.0 ? 1.0 / squared : 0.0});
    }

    // a wall is listed in each cell whose middle is so near that a place of the cell may be near
    const double near = radius_ + reach_ + cell * std::sqrt(0.5);
    std::vector<std::vector<std::uint32_t>> lists(static_cast<std::size_t>(columns_) *
                                                  static_cast<std::size_t>(rows_));
    const auto cell_of = [&](double value, double least, int count) {
        return std::clamp(static_cast<int>(std::floor((value - least) * per_cell_)), 0, count - 1);
    };
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
        const auto [left, right] = std::minmax(segments_[i].from.x, segments_[i].to.x);
        const auto [upper, lower] = std::minmax(segments_[i].from.y, segments_[i].to.y);
        const int last_row = cell_of(lower + near, bounds.least.y, rows_);
        const int last_column = cell_of(right + near, bounds.least.x, columns_);
        for (int row = cell_of(upper - near, bounds.least.y, rows_); row <= last_row; ++row) {
            for (int column = cell_of(left - near, bounds.least.x, columns_); column <= last_column;
                 ++column) {
                const Vector2d middle(bounds.least.x + (column + 0.5) * cell,
                                      bounds.least.y + (row + 0.5) * cell);
                if ((nearest_on(lines_[i], middle) - middle).norm() <= near)
                    lists[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(column)]
                        .push_back(i);
            }
        }
    }
    begins_.push_back(0);
    for (const std::vector<std::uint32_t>& list : lists) {
        entries_.insert(entries_.end(), list.begin(), list.end());
        begins_.push_back(static_cast<std::uint32_t>(entries_.size()));
    }
}

std::span<const std::uint32_t> Walls::around(Point place) const {
    // a place outside by a rounding error belongs to the cell beside it
    const double u = (place.x - bounds_.least.x) * per_cell_;
    const double v = (place.y - bounds_.least.y) * per_cell_;
    const int column = static_cast<int>(std::clamp(u, 0.0, columns_ - 1.0));
    const int row = static_cast<int>(std::clamp(v, 0.0, rows_ - 1.0));
    const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                             static_cast<std::size_t>(column);
    return {entries_.data() + begins_[cell], begins_[cell + 1] - begins_[cell]};
}

Hit Walls::first_hit(Point from_point, Point to) const {
    const Vector2d from = vector(from_point);
    const Vector2d way = vector(to) - from;
    const double length = way.norm();
    const double far = (radius_ + length) * (radius_ + length);
    const double grazing = -most_grazing * length;
    Hit hit;
    for (const std::uint32_t i : around(from_point)) {
        const Line& wall = lines_[i];
        const Vector2d away = from - nearest_on(wall, from);
        const double squared = away.squaredNorm();
        if (squared > far) continue;
        double part = 0.0;
        if (squared > radius_ * radius_)
            part = part_to_wall(wall, from, way, radius_);
        else if (away.dot(way) >= grazing * radius_)
            continue;
        if (part >= hit.part) continue;
        const Vector2d at = from + part * way;
        const Vector2d normal = (at - nearest_on(wall, at)).normalized();
        if (normal.dot(way) >= grazing) continue;
        hit = {.part = part, .normal = {normal.x(), normal.y()}};
    }
    return hit;
}

Nearest Walls::nearest(Point place) const {
    Nearest nearest{.place = {}, .distance = std::numeric_limits<double>::infinity()};
    for (const std::uint32_t i : around(place)) {
        const Vector2d on_wall = nearest_on(lines_[i], vector(place));
        const double distance = (on_wall - vector(place)).norm();
        if (distance < nearest.distance)
            nearest = {.place = {on_wall.x(), on_wall.y()}, .distance = distance};
    }
    return nearest;
}

double Walls::ray(Point from, double angle, double most) const {
    const Vector2d direction(std::cos(angle), std::sin(angle));
    const Vector2d begin = vector(from);
    for (double done = 0.0; done < most; done += reach_) {
        const Vector2d place = begin + done * direction;
        double distance = most - done;
        for (const std::uint32_t i : around({place.x(), place.y()})) {
            // place + at direction = wall + part along, both times `across`
            const Vector2d wall = from_of(lines_[i]) - place;
            const Vector2d along = along_of(lines_[i]);
            double across = cross(direction, along);
            double at = cross(wall, along);
            double part = cross(wall, direction);
            if (across < 0.0) {
                across = -across;
                at = -at;
                part = -part;
            }
            // beside the line, behind, or beyond what was found; parallel: its ends are other
            // walls'
            if (part < 0.0 || part > across || at < 0.0 || at >= distance * across) continue;
            distance = at / across;
        }
        if (distance <= reach_ && distance < most - done) return done + distance;
    }
    return most;
}

}  // namespace trellis
