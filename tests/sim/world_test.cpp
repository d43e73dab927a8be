// Polygons, doors and the worlds made of them.
// SPDX-License-Identifier: MIT
#include "sim/world.h"

#include <doctest/doctest.h>

namespace trellis {
namespace {

Polygon polygon(std::vector<Point> corners) {
    return {.name = "", .corners = std::move(corners)};
}

TEST_CASE("world: the walls of the lab's room are its four sides") {
    const std::vector<Segment> expected{{{0.0, 0.0}, {6.4, 0.0}},
                                        {{6.4, 0.0}, {6.4, 4.8}},
                                        {{6.4, 4.8}, {0.0, 4.8}},
                                        {{0.0, 4.8}, {0.0, 0.0}}};
    const std::vector<Segment> walls = walls_of(lab_room());
    REQUIRE(walls.size() == expected.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        CHECK(walls[i].from.x == doctest::Approx(expected[i].from.x));
        CHECK(walls[i].from.y == doctest::Approx(expected[i].from.y));
        CHECK(walls[i].to.x == doctest::Approx(expected[i].to.x));
        CHECK(walls[i].to.y == doctest::Approx(expected[i].to.y));
    }
}

TEST_CASE("world: doors leave the pieces of a wall between them") {
    World world;
    world.rooms = {polygon({{0, 0}, {8, 0}, {8, 4}, {0, 4}})};
    world.doors = {{{6, 0}, {5, 0}}, {{1, 0}, {2, 0}}, {{7.5, 0}, {9, 0}}, {{3, 1}, {4, 1}}};
    const std::vector<Segment> walls = walls_of(world);
    REQUIRE(walls.size() == 6);
    CHECK(walls[0] == Segment{{0, 0}, {1, 0}});
    CHECK(walls[1] == Segment{{2, 0}, {5, 0}});
    CHECK(walls[2] == Segment{{6, 0}, {7.5, 0}});
}

TEST_CASE("world: a door as long as a wall leaves nothing of it") {
    World world;
    world.rooms = {polygon({{0, 0}, {8, 0}, {8, 4}})};
    world.doors = {{{0, 0}, {8, 0}}};
    CHECK(walls_of(world).size() == 2);
}

TEST_CASE("world: a door opens the walls of both rooms that share them") {
    World world;
    world.rooms = {polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}),
                   polygon({{2, 0}, {4, 0}, {4, 2}, {2, 2}})};
    world.doors = {{{2, 0.5}, {2, 1.5}}};
    for (const Segment& wall : walls_of(world))
        CHECK_FALSE(lies_on(wall, {{2, 0.6}, {2, 1.4}}));
    CHECK(walls_of(world).size() == 3 + 2 + 3 + 2);
}

TEST_CASE("world: inside and outside of a polygon that is not convex") {
    const Polygon room = polygon({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}});
    CHECK(is_inside(room, {0.5, 2.5}));
    CHECK(is_inside(room, {3.5, 0.5}));
    CHECK_FALSE(is_inside(room, {2.0, 2.0}));
    CHECK_FALSE(is_inside(room, {-1.0, 0.5}));
}

TEST_CASE("world: lines that cross or touch are found where the second begins") {
    CHECK(crossing(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}})) == -1);
    CHECK(crossing(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})) == 2);
    CHECK(crossing(polygon({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}})) == 2);  // touches
    CHECK(crossing(polygon({{0, 0}, {0, 0}, {2, 2}, {0, 2}})) == 1);          // repeats
    CHECK(crossing(polygon({{0, 0}, {2, 0}, {1, 0}, {1, 2}})) == 1);          // turns back
    CHECK(crossing(polygon({{0, 0}, {2, 0}, {4, 0}, {4, 2}})) == -1);         // goes straight on
}

}  // namespace
}  // namespace trellis
