// From JSON values to a World, and what is wrong with it beyond names and types.
// SPDX-License-Identifier: MIT
#include "sim/bridge/world_file.h"

#include "core/number.h"
#include "load/json_tree.h"
#include "load/text.h"
#include "sim/bridge/world_grammar.h"
#include "sim/walled_world.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace trellis {
namespace {

/// Takes values out of a file that check_file() has accepted.
class Reader {
public:
    explicit Reader(const JsonTree& json) : json_(json) {}

    World world() const {
        const JsonId root = json_.root();
        World world;
        world.name = text(root, "name");
        if (const JsonId robot = json_.member(root, "robot")) world.robot = body(robot);
        for (const JsonId start : list("starts"))
            world.starts.push_back(
                {number(start, "x", 0.0), number(start, "y", 0.0), number(start, "rotation", 0.0)});
        for (const JsonId room : list("rooms"))
            world.rooms.push_back(outline(room));
        for (const JsonId door : list("doors"))
            world.doors.push_back(
                {point(json_.member(door, "from")), point(json_.member(door, "to"))});
        for (const JsonId piece : list("furniture"))
            world.furniture.push_back(outline(piece));
        for (const JsonId spot : list("dirt"))
            world.dirt.push_back(
                {.centre = place(spot), .radius = number(spot, "radius", Dirt{}.radius)});
        if (const JsonId dock = json_.member(root, "dock"))
            world.docks.push_back({.place = place(dock),
                                   .reach = number(dock, "reach", Dock{}.reach),
                                   .range = number(dock, "range", Dock{}.range)});
        if (const JsonId battery = json_.member(root, "battery"))
            world.battery = {.life = number(battery, "life", Battery{}.life),
                             .charging = number(battery, "charging", Battery{}.charging),
                             .start = number(battery, "start", Battery{}.start)};
        if (const JsonId noise = json_.member(root, "noise"))
            world.noise = {.linear_slip = number(noise, "linear_slip", 0.0),
                           .angular_slip = number(noise, "angular_slip", 0.0),
                           .wall_distance = number(noise, "wall_distance", 0.0),
                           .dock_bearing = number(noise, "dock_bearing", 0.0)};
        return world;
    }

    /// The values of a list of the file; none if it does not have the list.
    std::vector<JsonId> list(std::string_view name) const {
        return list_in(json_, json_.root(), name);
    }

    /// Where the corner of that number stands in the file.
    Where corner(JsonId outline, int wanted) const {
        int i = 0;
        for (const JsonId value : json_.children(json_.member(outline, "corners"))) {
            if (i++ == wanted) return json_.at(value).where;
        }
        return json_.at(outline).where;
    }

private:
    std::string text(JsonId object, std::string_view key) const {
        return text_in(json_, object, key);
    }

    double number(JsonId object, std::string_view key, double otherwise) const {
        return number_in(json_, object, key, otherwise);
    }

    Point place(JsonId object) const {
        return {number(object, "x", 0.0), number(object, "y", 0.0)};
    }

    Point point(JsonId pair) const {
        double coordinates[2] = {0.0, 0.0};
        double* next = coordinates;
        for (const JsonId value : json_.children(pair))
            *next++ = parse_whole_number(json_.text(value)).value;
        return {coordinates[0], coordinates[1]};
    }

    Polygon outline(JsonId object) const {
        Polygon polygon{.name = text(object, "name"), .corners = {}};
        for (const JsonId corner : json_.children(json_.member(object, "corners")))
            polygon.corners.push_back(point(corner));
        return polygon;
    }

    RobotBody body(JsonId object) const {
        const RobotBody usual;
        return {.radius = number(object, "radius", usual.radius),
                .max_linear = number(object, "max_linear", usual.max_linear),
                .max_angular = number(object, "max_angular", usual.max_angular)};
    }

    const JsonTree& json_;
};

/// Checks what the values mean together.
class Judge {
public:
    Judge(const JsonTree& json, const World& world, Diagnostics& diagnostics)
        : json_(json), reader_(json), world_(world), diagnostics_(diagnostics) {}

    void outlines(std::string_view list, const std::vector<Polygon>& polygons) {
        const std::vector<JsonId> values = reader_.list(list);
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const int corner = crossing(polygons[i]);
            if (corner >= 0)
                diagnostics_.error(
                    "world-outline", reader_.corner(values[i], corner),
                    "the outline" + of(polygons[i].name) +
                        " touches or crosses itself in the line from this corner on");
        }
    }

    void doors() {
        const std::vector<JsonId> values = reader_.list("doors");
        for (std::size_t i = 0; i < world_.doors.size(); ++i) {
            const Segment& door = world_.doors[i];
            const bool on_wall =
                std::any_of(world_.rooms.begin(), world_.rooms.end(), [&](const Polygon& room) {
                    for (std::size_t k = 0; k < room.corners.size(); ++k) {
                        if (lies_on({room.corners[k], room.corners[(k + 1) % room.corners.size()]},
                                    door))
                            return true;
                    }
                    return false;
                });
            if (!on_wall)
                diagnostics_.error("world-door", json_.at(values[i]).where,
                                   "the door lies on the outline of no room");
        }
    }

    void starts(const WalledWorld& walled) {
        const std::vector<JsonId> values = reader_.list("starts");
        for (std::size_t i = 0; i < world_.starts.size(); ++i) {
            const Point start{world_.starts[i].x, world_.starts[i].y};
            if (fits(walled, start)) continue;
            const double distance = walled.walls.nearest(start).distance;
            diagnostics_.error("world-start", json_.at(values[i]).where,
                               distance < world_.robot.radius
                                   ? "the robot does not fit here: a wall is " +
                                         print_number(distance) +
                                         " m from its centre, and its radius is " +
                                         print_number(world_.robot.radius) + " m"
                                   : "the robot starts in no room, or inside furniture");
        }
    }

    void reach(const WalledWorld& walled) {
        const Pose& start = world_.starts.front();
        const double radius = world_.robot.radius;
        const std::vector<Point> places = places_of(walled.walls, {start.x, start.y}, radius / 2.0);
        const auto comes_near = [&](Point wanted, double distance) {
            return std::any_of(places.begin(), places.end(), [&](Point place) {
                return std::hypot(place.x - wanted.x, place.y - wanted.y) <= distance;
            });
        };
        for (std::size_t i = 0; i < world_.rooms.size(); ++i) {
            const Polygon& room = world_.rooms[i];
            if (std::none_of(places.begin(), places.end(),
                             [&](Point place) { return is_inside(room, place); }))
                warn(reader_.list("rooms")[i],
                     "the room" + (room.name.empty() ? "" : " " + quoted(room.name)));
        }
        for (std::size_t i = 0; i < world_.dirt.size(); ++i) {
            if (!comes_near(world_.dirt[i].centre, radius + world_.dirt[i].radius))
                warn(reader_.list("dirt")[i], "the dirt");
        }
        for (const Dock& dock : world_.docks) {
            if (!comes_near(dock.place, dock.reach + radius / 2.0))
                warn(json_.member(json_.root(), "dock"), "the dock");
        }
    }

private:
    static std::string of(const std::string& name) {
        return name.empty() ? "" : " of " + quoted(name);
    }

    void warn(JsonId value, const std::string& what) {
        diagnostics_.warning("world-unreachable", json_.at(value).where,
                             what + " cannot be reached from the first start");
    }

    const JsonTree& json_;
    Reader reader_;
    const World& world_;
    Diagnostics& diagnostics_;
};

}  // namespace

std::optional<World> read_world(std::string_view text, std::uint32_t file,
                                Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.errors();
    const std::optional<JsonTree> json = parse_json(text, file, diagnostics);
    if (!json) return {};
    check_file(*json, world_grammar(), diagnostics);
    if (diagnostics.errors() != before) return {};

    World world = Reader(*json).world();
    Judge judge(*json, world, diagnostics);
    judge.outlines("rooms", world.rooms);
    judge.outlines("furniture", world.furniture);
    judge.doors();
    if (diagnostics.errors() != before) return {};

    const WalledWorld walled(world);
    judge.starts(walled);
    if (diagnostics.errors() != before) return {};
    judge.reach(walled);
    return world;
}

}  // namespace trellis
