// Worlds and coverage: painting alone, the whole lab step with coverage, and a step in a world of a
// thousand walls. The angles are random.Random(0)'s. Results per machine are in bench/README.md.
// SPDX-License-Identifier: MIT
#include "core/random.h"
#include "sim/coverage.h"
#include "sim/surroundings.h"
#include "support/hand_written.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <numbers>
#include <vector>

namespace trellis {
namespace {

std::vector<double> drawn_angles() {
    Random random(0);
    std::vector<double> angles(4000);
    for (double& angle : angles)
        angle = random.uniform(-std::numbers::pi, std::numbers::pi);
    return angles;
}

/// Ten minutes of the lab's run, painted again and again.
void painting(benchmark::State& state) {
    const std::vector<double> angles = drawn_angles();
    const LabWorld world;
    Roomba robot = at_start(world);
    test::HandWrittenFsm behaviour{test::Angles(angles)};
    std::vector<Point> way;
    for (int tick = 0; tick < 36'000; ++tick) {
        sense(world, robot);
        behaviour.tick(robot);
        move(robot, lab_dt);
        way.push_back({robot.x, robot.y});
    }
    const Floor floor = floor_of(world);
    for (auto _ : state) {
        Coverage coverage(floor);
        for (std::uint64_t tick = 0; tick < way.size(); ++tick)
            coverage.add(way[tick].x, way[tick].y, tick);
        benchmark::DoNotOptimize(coverage.share());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(way.size()));
}
BENCHMARK(painting)->Name("coverage/painting 36,000 ticks");

void lab_with_coverage(benchmark::State& state) {
    const std::vector<double> angles = drawn_angles();
    const LabWorld world;
    const Floor floor = floor_of(world);
    Coverage coverage(floor);
    Roomba robot = at_start(world);
    test::HandWrittenFsm behaviour{test::Angles(angles)};
    std::uint64_t tick = 0;
    for (auto _ : state) {
        sense(world, robot);
        behaviour.tick(robot);
        move(robot, lab_dt);
        coverage.add(robot.x, robot.y, ++tick);
        benchmark::DoNotOptimize(robot);
    }
}
BENCHMARK(lab_with_coverage)->Name("world step/lab, with coverage");

/// A room of 20 m by 15 m with `posts` posts of four walls.
WalledWorld room_of_posts(int posts) {
    World world = lab_room({.width = 20.0, .height = 15.0, .start = {0.5, 0.5, 0.3}});
    for (int i = 0; i < posts; ++i) {
        const double x = 1.0 + (i % 20) * 0.95;
        const double y = 1.0 + (i / 20) * 1.1;
        world.furniture.push_back(
            {.name = "", .corners = {{x, y}, {x + 0.1, y}, {x + 0.1, y + 0.1}, {x, y + 0.1}}});
    }
    return WalledWorld(world);
}

void among_walls(benchmark::State& state) {
    const std::vector<double> angles = drawn_angles();
    const WalledWorld world = room_of_posts(static_cast<int>(state.range(0)));
    const Pose start = world.plan.starts.front();
    const Floor floor = floor_of(world.walls, {start.x, start.y});
    Coverage coverage(floor);
    Surroundings around = surroundings_of(world.plan);
    Roomba robot = at_start(world, start);
    test::HandWrittenFsm behaviour{test::Angles(angles)};
    std::uint64_t tick = 0;
    for (auto _ : state) {
        sense(world, around, robot);
        behaviour.tick(robot);
        move(world, around, robot, lab_dt);
        coverage.add(robot.x, robot.y, ++tick);
        benchmark::DoNotOptimize(robot);
    }
    state.counters["walls"] = static_cast<double>(world.walls.segments().size());
}
BENCHMARK(among_walls)->Name("world step/walls, with coverage")->Arg(2)->Arg(249);

}  // namespace
}  // namespace trellis
