// Questions about walls, against answers that are known and, for random ones, against asking every
// wall.
// SPDX-License-Identifier: MIT
#include "sim/walls.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace trellis {
namespace {

constexpr double radius = 0.17;

Walls room_with_post() {
    World world = lab_room();
    world.furniture = {{.name = "post", .corners = {{3.0, 2.0}, {3.1, 2.0}, {3.05, 2.1}}}};
    return Walls(walls_of(world), radius, bounds_of(world));
}

double distance(const Segment& wall, Point p) {
    const double dx = wall.to.x - wall.from.x;
    const double dy = wall.to.y - wall.from.y;
    const double part = std::clamp(
        ((p.x - wall.from.x) * dx + (p.y - wall.from.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(p.x - wall.from.x - part * dx, p.y - wall.from.y - part * dy);
}

TEST_CASE("walls: a disc is stopped where it touches a line, with the line's normal") {
    const Hit hit = room_with_post().first_hit({6.1, 2.0}, {6.3, 2.1});
    CHECK(hit.part == doctest::Approx(0.65));
    CHECK(hit.normal.x == doctest::Approx(-1.0));
    CHECK(hit.normal.y == doctest::Approx(0.0));
}

TEST_CASE("walls: a disc is stopped where it touches a corner, with the normal from the corner") {
    const Hit hit = room_with_post().first_hit({2.95, 1.75}, {2.95, 1.95});
    const double down = std::sqrt(radius * radius - 0.05 * 0.05);
    CHECK(hit.part == doctest::Approx((0.25 - down) / 0.2));
    CHECK(hit.normal.x == doctest::Approx(-0.05 / radius));
    CHECK(hit.normal.y == doctest::Approx(-down / radius));
}

TEST_CASE("walls: ways along a wall, away from it or short of it are free") {
    const Walls walls = room_with_post();
    CHECK(walls.first_hit({6.23, 2.0}, {6.23, 2.2}).part == 1.0);
    CHECK(walls.first_hit({6.23, 2.0}, {6.1, 2.0}).part == 1.0);
    CHECK(walls.first_hit({6.0, 2.0}, {6.2, 2.0}).part == 1.0);
    CHECK(walls.first_hit({6.23, 2.0}, {6.24, 2.0}).part == doctest::Approx(0.0));
}

TEST_CASE("walls: the nearest wall, and none where none is near") {
    const Walls walls = room_with_post();
    CHECK(walls.nearest({6.2, 2.0}).distance == doctest::Approx(0.2));
    CHECK(walls.nearest({6.2, 2.0}).place.x == doctest::Approx(6.4));
    CHECK(walls.nearest({1.5, 2.4}).distance >= radius + walls.reach());
}

TEST_CASE("walls: a ray ends at the first wall, or where it is cut") {
    const Walls walls = room_with_post();
    CHECK(walls.ray({3.05, 1.0}, std::numbers::pi / 2.0, 10.0) == doctest::Approx(1.0));
    CHECK(walls.ray({3.05, 1.0}, -std::numbers::pi / 2.0, 10.0) == doctest::Approx(1.0));
    CHECK(walls.ray({1.0, 1.0}, 0.0, 10.0) == doctest::Approx(5.4));
    CHECK(walls.ray({1.0, 1.0}, 0.0, 2.0) == 2.0);
}

TEST_CASE("walls: the grid leaves out no wall that matters") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 10.0);
    std::uniform_real_distribution<double> step(-0.17, 0.17);
    std::vector<Segment> segments;
    for (int i = 0; i < 200; ++i) {
        const Point from{place(random), place(random)};
        segments.push_back({from, {from.x + 5.0 * step(random), from.y + 5.0 * step(random)}});
    }
    const Walls walls(segments, radius, {{-1.0, -1.0}, {11.0, 11.0}});
    for (int i = 0; i < 20'000; ++i) {
        const Point from{place(random), place(random)};
        double nearest = std::numeric_limits<double>::infinity();
        for (const Segment& wall : segments)
            nearest = std::min(nearest, distance(wall, from));
        if (nearest <= radius + walls.reach())
            REQUIRE(walls.nearest(from).distance == doctest::Approx(nearest));
        if (nearest < radius) continue;
        // until the hit the disc is clear of all walls, at the hit it touches one
        const Point to{from.x + step(random), from.y + step(random)};
        const Hit hit = walls.first_hit(from, to);
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= 20; ++k) {
            const double part = hit.part * k / 20.0;
            const Point at{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
            for (const Segment& wall : segments)
                least = std::min(least, distance(wall, at));
        }
        REQUIRE(least >= radius - 1e-9);
        if (hit.part < 1.0) REQUIRE(least <= radius + 1e-9);
    }
}

}  // namespace
}  // namespace trellis
