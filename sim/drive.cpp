// Moving a disc among walls, in pieces that end where it meets one.
// SPDX-License-Identifier: MIT
#include "sim/drive.h"

#include "sim/lab_world.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trellis {
namespace {

using Eigen::Vector2d;

/// In one tick a disc meets at most so many walls; in a corner it would go on between two for ever.
constexpr int most_hits = 8;

Point point(const Vector2d& v) {
    return {v.x(), v.y()};
}

/// An angle from -pi to pi.
double wrapped(double angle) {
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// Brings a disc that rounding has put into a wall, by less than 1e-12 m, back to its outside.
Vector2d pushed_out(const Walls& walls, const Vector2d& place) {
    const Nearest wall = walls.nearest(point(place));
    if (wall.distance >= walls.radius() || wall.distance == 0.0) return place;
    const Vector2d on_wall(wall.place.x, wall.place.y);
    return on_wall + (place - on_wall) * (walls.radius() / wall.distance);
}

/// Where the disc gets when it wants to go `way` from `place`; remembers the first wall it meets.
Vector2d slid(const Walls& walls, Drive& drive, double heading, Vector2d place, Vector2d way) {
    Vector2d first_normal(0.0, 0.0);
    for (int hits = 0; hits < most_hits;) {
        const double length = way.norm();
        if (length == 0.0) break;
        const Vector2d piece = length > walls.reach() ? way * (walls.reach() / length) : way;
        const Hit hit = walls.first_hit(point(place), point(place + piece));
        place += hit.part * piece;
        way -= hit.part * piece;
        if (hit.part >= 1.0) {
            if (length <= walls.reach()) break;
            continue;
        }
        ++hits;
        const Vector2d normal(hit.normal.x, hit.normal.y);
        if (!drive.touched) {
            drive.touched = true;
            drive.angle = wrapped(std::atan2(-normal.y(), -normal.x()) - heading);
            first_normal = normal;
        }
        way -= normal * normal.dot(way);
        // between two walls that meet at an acute angle there is no way along either
        if (hits > 1 && first_normal.dot(way) < -1e-9 * length) break;
    }
    return pushed_out(walls, place);
}

}  // namespace

void sense(const Drive& drive, Roomba& robot) {
    robot.release_bumper();
    if (drive.touched) robot.press_bumper(drive.angle);
}

void move(const Walls& walls, Drive& drive, Roomba& robot, double dt) {
    drive.touched = false;
    Roomba moved = robot;
    move(moved, dt);
    const Vector2d from(robot.x, robot.y);
    const Vector2d way = Vector2d(moved.x, moved.y) - from;
    if (!std::isfinite(way.squaredNorm()) || !std::isfinite(moved.rotation)) {
        robot.v = 0.0;
        robot.w = 0.0;
        return;
    }
    const double heading = robot.rotation;
    robot = moved;
    const double gone =
        (Vector2d(moved.x, moved.y) - Vector2d(drive.checked.x, drive.checked.y)).squaredNorm();
    if (gone < drive.clear * drive.clear) return;  // nothing is near

    const Vector2d end = slid(walls, drive, heading, from, way);
    robot.x = end.x();
    robot.y = end.y();
    drive.checked = point(end);
    drive.clear =
        std::clamp(walls.nearest(point(end)).distance - walls.radius(), 0.0, walls.reach());
}

}  // namespace trellis
