// Polygons, and walls with doors cut out.
// SPDX-License-Identifier: MIT
#include "sim/world.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace trellis {
namespace {

using Eigen::Vector2d;

/// How near to a line counts as on it, m.
constexpr double on_line = 1e-4;

Vector2d vector(Point p) {
    return {p.x, p.y};
}

Point point(const Vector2d& v) {
    return {v.x(), v.y()};
}

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

std::vector<Segment> outline(const Polygon& polygon) {
    std::vector<Segment> lines;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i)
        lines.push_back({polygon.corners[i], polygon.corners[(i + 1) % polygon.corners.size()]});
    return lines;
}

/// The part of a wall that a door takes, from 0 to 1 along it; last <= first if it takes none.
struct Part {
    double first = 0.0;
    double last = 0.0;
};

Part taken(const Segment& wall, const Segment& door) {
    const Vector2d begin = vector(wall.from);
    const Vector2d along = vector(wall.to) - begin;
    const double length = along.norm();
    if (length == 0.0) return {};
    const Vector2d from = vector(door.from) - begin;
    const Vector2d to = vector(door.to) - begin;
    if (std::fabs(cross(along, from)) > on_line * length) return {};
    if (std::fabs(cross(along, to)) > on_line * length) return {};
    const double a = along.dot(from) / (length * length);
    const double b = along.dot(to) / (length * length);
    return {.first = std::max(0.0, std::min(a, b)), .last = std::min(1.0, std::max(a, b))};
}

/// Adds what is left of a wall between its doors.
void add_without_doors(std::vector<Segment>& walls, const Segment& wall,
                       const std::vector<Segment>& doors) {
    std::vector<Part> gaps;
    for (const Segment& door : doors) {
        const Part part = taken(wall, door);
        if (part.first < part.last) gaps.push_back(part);
    }
    std::sort(gaps.begin(), gaps.end(),
              [](const Part& a, const Part& b) { return a.first < b.first; });
    const Vector2d begin = vector(wall.from);
    const Vector2d along = vector(wall.to) - begin;
    double done = 0.0;
    for (const Part& gap : gaps) {
        if (gap.first > done)
            walls.push_back({point(begin + done * along), point(begin + gap.first * along)});
        done = std::max(done, gap.last);
    }
    if (done == 0.0)
        walls.push_back(wall);
    else if (done < 1.0)
        walls.push_back({point(begin + done * along), wall.to});
}

/// Whether two lines have a place in common.
bool meet(const Segment& a, const Segment& b) {
    const auto side = [](const Segment& line, Point p) {
        return cross(vector(line.to) - vector(line.from), vector(p) - vector(line.from));
    };
    const auto within = [](const Segment& line, Point p) {
        return p.x >= std::min(line.from.x, line.to.x) && p.x <= std::max(line.from.x, line.to.x) &&
               p.y >= std::min(line.from.y, line.to.y) && p.y <= std::max(line.from.y, line.to.y);
    };
    const double a_from = side(b, a.from);
    const double a_to = side(b, a.to);
    const double b_from = side(a, b.from);
    const double b_to = side(a, b.to);
    if (a_from * a_to < 0.0 && b_from * b_to < 0.0) return true;
    return (a_from == 0.0 && within(b, a.from)) || (a_to == 0.0 && within(b, a.to)) ||
           (b_from == 0.0 && within(a, b.from)) || (b_to == 0.0 && within(a, b.to));
}

/// Whether two neighbouring lines, a before b, lie on each other.
bool turns_back(const Segment& a, const Segment& b) {
    const Vector2d first = vector(a.to) - vector(a.from);
    const Vector2d second = vector(b.to) - vector(b.from);
    return cross(first, second) == 0.0 && first.dot(second) <= 0.0;
}

}  // namespace

Bounds bounds_of(const World& world) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Bounds bounds{{infinity, infinity}, {-infinity, -infinity}};
    for (const Polygon& room : world.rooms) {
        for (const Point& corner : room.corners) {
            bounds.least = {std::min(bounds.least.x, corner.x), std::min(bounds.least.y, corner.y)};
            bounds.most = {std::max(bounds.most.x, corner.x), std::max(bounds.most.y, corner.y)};
        }
    }
    return bounds;
}

std::vector<Segment> walls_of(const World& world) {
    std::vector<Segment> walls;
    for (const Polygon& room : world.rooms) {
        for (const Segment& line : outline(room))
            add_without_doors(walls, line, world.doors);
    }
    for (const Polygon& piece : world.furniture) {
        for (const Segment& line : outline(piece))
            walls.push_back(line);
    }
    return walls;
}

bool is_inside(const Polygon& polygon, Point place) {
    bool inside = false;
    for (const Segment& line : outline(polygon)) {
        if ((line.from.y > place.y) == (line.to.y > place.y)) continue;
        const double part = (place.y - line.from.y) / (line.to.y - line.from.y);
        if (place.x < line.from.x + part * (line.to.x - line.from.x)) inside = !inside;
    }
    return inside;
}

bool lies_on(const Segment& wall, const Segment& door) {
    const Part part = taken(wall, door);
    return part.first < part.last;
}

int crossing(const Polygon& polygon) {
    const std::vector<Segment> lines = outline(polygon);
    const std::size_t n = lines.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (lines[i].from == lines[i].to || turns_back(lines[i], lines[(i + 1) % n]))
            return static_cast<int>((i + 1) % n);
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1) continue;  // neighbours
            if (meet(lines[i], lines[j])) return static_cast<int>(j);
        }
    }
    return -1;
}

World lab_room(const LabWorld& lab) {
    World world;
    world.name = "lab";
    world.robot.radius = lab.radius;
    world.starts = {lab.start};
    world.rooms = {
        {.name = "room",
         .corners = {{0.0, 0.0}, {lab.width, 0.0}, {lab.width, lab.height}, {0.0, lab.height}}}};
    return world;
}

}  // namespace trellis
