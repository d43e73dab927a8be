// World files: what they give, and exactly what is said about those that are wrong.
// SPDX-License-Identifier: MIT
#include "sim/bridge/world_file.h"

#include "support/files.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis {
namespace {

/// A world of one room, with `more` members.
std::string room(const std::string& more) {
    return R"({"starts": [{"x": 1, "y": 1}],
"rooms": [{"name": "hall", "corners": [[0, 0], [4, 0], [4, 3], [0, 3]]}])" +
           more + "}";
}

/// Findings as "line:column: id: message" lines.
std::string findings(const std::string& text) {
    Diagnostics diagnostics;
    const std::uint32_t file = diagnostics.add_file("w.json", text);
    const bool read = read_world(text, file, diagnostics).has_value();
    CHECK(read == diagnostics.ok());
    diagnostics.sort();
    std::string lines;
    for (const Diagnostic& d : diagnostics.all())
        lines += std::to_string(d.where.line) + ':' + std::to_string(d.where.column) + ": " + d.id +
                 ": " + d.message + '\n';
    return lines;
}

TEST_CASE("world file: every member is read") {
    Diagnostics diagnostics;
    const std::string text = R"({"$schema": "x", "doc": "y", "name": "n",
        "robot": {"radius": 0.2, "max_linear": 0.6, "max_angular": 3},
        "starts": [{"x": 1, "y": 1.5, "rotation": -1}],
        "rooms": [{"name": "a", "corners": [[0, 0], [4, 0], [4, 3], [0, 3]]}],
        "doors": [{"from": [4, 1], "to": [4, 2]}],
        "furniture": [{"corners": [[2, 2], [3, 2], [3, 2.5]]}],
        "dirt": [{"x": 1, "y": 2}, {"x": 3, "y": 1, "radius": 0.3}],
        "dock": {"x": 0.5, "y": 0.5, "reach": 0.2, "range": 3},
        "battery": {"life": 100, "charging": 10, "start": 0.5},
        "noise": {"linear_slip": 0.1, "angular_slip": 0.2, "wall_distance": 0.3, "dock_bearing": 0.4}})";
    const std::optional<World> world =
        read_world(text, diagnostics.add_file("w", text), diagnostics);
    CHECK(diagnostics.render() == "");
    REQUIRE(world);
    World expected;
    expected.name = "n";
    expected.robot = {.radius = 0.2, .max_linear = 0.6, .max_angular = 3.0};
    expected.starts = {{1.0, 1.5, -1.0}};
    expected.rooms = {{.name = "a", .corners = {{0, 0}, {4, 0}, {4, 3}, {0, 3}}}};
    expected.doors = {{{4, 1}, {4, 2}}};
    expected.furniture = {{.name = "", .corners = {{2, 2}, {3, 2}, {3, 2.5}}}};
    expected.dirt = {{.centre = {1, 2}, .radius = 0.1}, {.centre = {3, 1}, .radius = 0.3}};
    expected.docks = {{.place = {0.5, 0.5}, .reach = 0.2, .range = 3.0}};
    expected.battery = {.life = 100.0, .charging = 10.0, .start = 0.5};
    expected.noise = {
        .linear_slip = 0.1, .angular_slip = 0.2, .wall_distance = 0.3, .dock_bearing = 0.4};
    CHECK(*world == expected);
}

TEST_CASE("world file: the worlds that come with Trellis have no faults") {
    for (const auto& file : test::files_below("sim/worlds", {".json"})) {
        CAPTURE(file.string());
        CHECK(findings(test::read_file(TRELLIS_SOURCE_DIR / file)) == "");
    }
}

TEST_CASE("world file: names, types and numbers") {
    CHECK(findings("[]") == "1:1: json-type: the file must be an object, found an array\n");
    CHECK(findings("{}") == "1:1: json-member: a world needs \"starts\"\n"
                            "1:1: json-member: a world needs \"rooms\"\n");
    CHECK(findings(room(R"(, "furnitur": [])")) ==
          "2:76: json-member: a world has no member \"furnitur\"; did you mean \"furniture\"?\n");
    CHECK(findings(room(R"(, "robot": {"radius": "big"})")) ==
          "2:96: json-type: \"radius\" must be a number, found text\n");
    CHECK(findings(room(R"(, "robot": {"radius": 0})")) ==
          "2:95: bad-value: \"radius\" must be above 0, up to 1000000, found 0\n");
    CHECK(findings(room(R"(, "dock": {"x": 1e999, "y": 1})")) ==
          "2:89: json-syntax: the number is too large\n");
    CHECK(findings(room(R"(, "dock": {"x": NaN, "y": 1})")) ==
          "2:89: json-syntax: JSON has no NaN and no Infinity\n");
    CHECK(findings(room(R"(, "dock": {"x": 1001, "y": 1})")) ==
          "2:89: bad-value: \"x\" must be from -1000 to 1000, found 1001\n");
    CHECK(findings(room(R"(, "doors": [{"from": [1], "to": [1, "2"]}])")) ==
          "2:94: json-type: \"from\" must be [x, y]\n"
          "2:110: json-type: a coordinate must be a number, found text\n");
    CHECK(findings(room(R"(, "furniture": [{"corners": [[1, 1], [2, 2]]}])")) ==
          "2:101: bad-value: \"corners\" must be at least 3 points, found 2\n");
    CHECK(findings(R"({"starts": [], "rooms": []})") ==
          "1:12: bad-value: \"starts\" must not be empty\n"
          "1:25: bad-value: \"rooms\" must not be empty\n");
}

TEST_CASE("world file: outlines that cross themselves") {
    CHECK(
        findings(room(
            R"(, "furniture": [{"name": "bow", "corners": [[1, 1], [2, 2], [2, 1], [1, 2]]}])")) ==
        "2:133: world-outline: the outline of \"bow\" touches or crosses itself in the line from "
        "this corner on\n");
}

TEST_CASE("world file: doors beside walls") {
    CHECK(findings(room(R"(, "doors": [{"from": [1, 1], "to": [2, 1]}])")) ==
          "2:85: world-door: the door lies on the outline of no room\n");
}

TEST_CASE("world file: starts where the robot does not fit") {
    const auto start = [](const std::string& place) {
        return findings(R"({"starts": [)" + place +
                        R"(], "rooms": [{"corners": [[0, 0], [4, 0], [4, 3], [0, 3]]}],
                        "furniture": [{"corners": [[2, 1], [3.5, 1], [3.5, 2], [2, 2]]}]})");
    };
    CHECK(start(R"({"x": 0.125, "y": 1})") ==
          "1:13: world-start: the robot does not fit here: a wall is 0.125 m from its centre, and "
          "its radius is 0.17 m\n");
    CHECK(start(R"({"x": -5, "y": 1})") ==
          "1:13: world-start: the robot starts in no room, or inside furniture\n");
    CHECK(start(R"({"x": 2.5, "y": 1.5})") ==
          "1:13: world-start: the robot starts in no room, or inside furniture\n");
}

TEST_CASE("world file: what cannot be reached is a warning") {
    CHECK(findings(R"({"starts": [{"x": 1, "y": 1}], "rooms": [
{"name": "hall", "corners": [[0, 0], [2, 0], [2, 2], [0, 2]]},
{"name": "attic", "corners": [[2, 0], [4, 0], [4, 2], [2, 2]]}],
"doors": [{"from": [2, 0.5], "to": [2, 0.8]}],
"dirt": [{"x": 3, "y": 1}, {"x": 1.5, "y": 0.5}],
"dock": {"x": 1.8, "y": 1.8}})") ==
          "3:1: world-unreachable: the room \"attic\" cannot be reached from the first start\n"
          "5:10: world-unreachable: the dirt cannot be reached from the first start\n");
}

}  // namespace
}  // namespace trellis
