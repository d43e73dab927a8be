// A world of walls: rooms with doors and furniture as polygons, where a robot starts, what lies on
// the floor, and what the robot can do. A description; it moves nothing (sim/walls.h finds walls,
// sim/drive.h moves) and reads no file (sim/bridge/world_file.h does). Covered by
// tests/sim/world_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/lab_world.h"

#include <string>
#include <vector>

namespace trellis {

/// A place on the floor, m; y points downwards as drawn.
struct Point {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const Point&, const Point&) = default;
};

/// A straight piece of wall. It has no thickness and stops a robot from both sides.
struct Segment {
    Point from;
    Point to;

    friend bool operator==(const Segment&, const Segment&) = default;
};

/// A closed line without crossings: its last corner is joined to its first.
struct Polygon {
    std::string name;
    std::vector<Point> corners;  ///< at least 3

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Something on the floor that a robot cleans by being over it.
struct Dirt {
    Point centre;
    double radius = 0.1;  ///< m, above 0

    friend bool operator==(const Dirt&, const Dirt&) = default;
};

/// Where the robot charges: it is docked when its centre is within `reach` of the place.
struct Dock {
    Point place;
    double reach = 0.1;  ///< m, above 0
    double range = 5.0;  ///< m, from where it can be seen when no wall is between

    friend bool operator==(const Dock&, const Dock&) = default;
};

/// How long the battery lasts; a full one holds 1.
struct Battery {
    double life = 3600.0;     ///< s, from full to empty while not docked; above 0
    double charging = 600.0;  ///< s, from empty to full while docked; above 0
    double start = 1.0;       ///< of a full one, at the start; 0 to 1

    friend bool operator==(const Battery&, const Battery&) = default;
};

/// What is not exact about the robot: standard deviations. All 0: nothing is drawn.
struct Noise {
    double linear_slip = 0.0;    ///< part of each tick's linear velocity
    double angular_slip = 0.0;   ///< part of each tick's angular velocity
    double wall_distance = 0.0;  ///< m, of each reading
    double dock_bearing = 0.0;   ///< rad, of each reading

    friend bool operator==(const Noise&, const Noise&) = default;
};

/// The body and the drive of the robot. The defaults are the lab's.
struct RobotBody {
    double radius = 0.34 / 2.0;  ///< m, above 0
    double max_linear = 1.0;     ///< m/s, at least 0
    double max_angular = 2.0;    ///< rad/s, at least 0

    friend bool operator==(const RobotBody&, const RobotBody&) = default;
};

/// Everything that a world file says.
struct World {
    std::string name;
    RobotBody robot;
    std::vector<Pose> starts;        ///< at least one; the first is taken unless another is chosen
    std::vector<Polygon> rooms;      ///< at least one; their outlines are walls
    std::vector<Segment> doors;      ///< pieces of the rooms' outlines where there is no wall
    std::vector<Polygon> furniture;  ///< their outlines are walls
    std::vector<Dirt> dirt;
    std::vector<Dock> docks;  ///< none or one
    Battery battery;
    Noise noise;

    friend bool operator==(const World&, const World&) = default;
};

/// The smallest upright rectangle around all rooms.
struct Bounds {
    Point least;
    Point most;
};
Bounds bounds_of(const World& world);

/// The walls of a world: the outlines of rooms without their doors, and of furniture.
std::vector<Segment> walls_of(const World& world);

/// Whether a place lies inside a polygon; on its line either answer is given.
bool is_inside(const Polygon& polygon, Point place);

/// Whether a piece of `wall` lies on `door`: both on one line, to 0.1 mm, and overlapping.
bool lies_on(const Segment& wall, const Segment& door);

/// Where two lines of the polygon that are no neighbours touch or cross: the number of the corner
/// at which the second one begins; -1 if nowhere. A corner that repeats its neighbour counts.
int crossing(const Polygon& polygon);

/// The lab's room as a world of four walls.
World lab_room(const LabWorld& lab = {});

}  // namespace trellis
