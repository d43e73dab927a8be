// Keeping the newest points, the lab's pixels, and thinning out: against the definition, point by
// point, on random walks.
// SPDX-License-Identifier: MIT
#include "sim/trail.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace trellis;

namespace {

/// Distance in m of `p` from the segment between `a` and `b`, by trying its points.
double distance(const TrailPoint& p, const TrailPoint& a, const TrailPoint& b) {
    double nearest = std::hypot(p.x - a.x, p.y - a.y);
    for (int i = 1; i <= 1000; ++i) {
        const double x = a.x + (b.x - a.x) * i / 1000.0;
        const double y = a.y + (b.y - a.y) * i / 1000.0;
        nearest = std::min(nearest, std::hypot(p.x - x, p.y - y));
    }
    return nearest;
}

}  // namespace

TEST_CASE("trail: without a limit every point is kept, in order") {
    Trail trail;
    CHECK(trail.points().empty());
    for (int i = 0; i < 5000; ++i)
        trail.add({.x = i * 0.01, .y = 1.0, .leaf = 3});
    REQUIRE(trail.points().size() == 5000);
    CHECK(trail.points().front() == TrailPoint{0.0, 1.0, 3});
    CHECK(trail.points().back() == TrailPoint{49.99, 1.0, 3});
}

TEST_CASE("trail: with a limit exactly the newest points are kept, after every add") {
    Trail trail(3);
    for (int i = 0; i < 20; ++i) {
        trail.add({.x = static_cast<double>(i)});
        const auto points = trail.points();
        REQUIRE(points.size() == static_cast<std::size_t>(std::min(i + 1, 3)));
        for (std::size_t k = 0; k < points.size(); ++k)
            CHECK(points[points.size() - 1 - k].x == i - static_cast<double>(k));
    }
}

TEST_CASE("trail: pixels are 1 cm, halves go to the even neighbour as in the lab") {
    CHECK(lab_pixel(3.2, 2.4) == Pixel{320, 240});
    CHECK(lab_pixel(0.125, 0.135) == Pixel{12, 14});
    CHECK(lab_pixel(0.005, 0.375) == Pixel{0, 38});
    CHECK(lab_pixel(-0.025, 1.0) == Pixel{-2, 100});
}

TEST_CASE("trail: thinning keeps the ends, and only the ends of a straight way") {
    CHECK(simplified({}, 0.01).empty());
    const std::vector<TrailPoint> one(1);
    CHECK(simplified(one, 0.01) == std::vector<std::size_t>{0});
    std::vector<TrailPoint> line;
    for (int i = 0; i <= 200; ++i)
        line.push_back({.x = i * 0.01, .y = i * 0.02});
    CHECK(simplified(line, 0.001) == std::vector<std::size_t>{0, 200});
}

TEST_CASE("trail: thinning keeps a corner and the far end of a way there and back") {
    const std::vector<TrailPoint> corner = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}};
    CHECK(simplified(corner, 0.1) == std::vector<std::size_t>{0, 2, 4});
    const std::vector<TrailPoint> back = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 0}, {0, 0}};
    CHECK(simplified(back, 0.1) == std::vector<std::size_t>{0, 3, 5});
}

TEST_CASE("trail: every point left out is within the tolerance of its kept neighbours' line") {
    std::mt19937_64 random(1);
    std::normal_distribution<double> turn(0.0, 0.3);
    std::vector<TrailPoint> walk(700);
    double heading = 0.0;
    for (std::size_t i = 1; i < walk.size(); ++i) {
        heading += turn(random);
        walk[i].x = walk[i - 1].x + 0.01 * std::cos(heading);
        walk[i].y = walk[i - 1].y + 0.01 * std::sin(heading);
    }
    for (const double tolerance : {0.0015, 0.02, 1.0}) {
        const std::vector<std::size_t> kept = simplified(walk, tolerance);
        REQUIRE(kept.front() == 0);
        REQUIRE(kept.back() == walk.size() - 1);
        REQUIRE(kept.size() < walk.size());
        for (std::size_t k = 1; k < kept.size(); ++k) {
            REQUIRE(kept[k - 1] < kept[k]);
            for (std::size_t i = kept[k - 1] + 1; i < kept[k]; ++i)
                REQUIRE(distance(walk[i], walk[kept[k - 1]], walk[kept[k]]) <= tolerance + 1e-4);
        }
    }
}
