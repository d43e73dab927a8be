// Worlds and coverage: painting alone, the whole lab step with coverage, by hand and from a file, a
// step in a world of a thousand walls, the runs of a sweep in one thread and in two, and ticks that
// are leaped over. The angles are random.Random(0)'s. Results per machine are in bench/README.md.
// SPDX-License-Identifier: MIT
#include "core/random.h"
#include "sim/bridge/fast_forward.h"
#include "sim/bridge/leaves.h"
#include "sim/bridge/measured_run.h"
#include "sim/coverage.h"
#include "sim/surroundings.h"
#include "support.h"
#include "support/hand_written.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
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

struct Roombas : Registry {
    Roombas() { register_roomba(*this); }
};

Program program_of(const std::string& file, const Registry& registry) {
    std::ifstream in(TRELLIS_SOURCE_DIR "/" + file);
    std::ostringstream text;
    text << in.rdbuf();
    return bench::loaded(file, text.str(), registry);
}

constexpr const char* behaviours[] = {"machines/roomba.scxml", "trees/roomba.xml"};

void lab_file_with_coverage(benchmark::State& state) {
    const Roombas registry;
    const Program program = program_of(behaviours[state.range(0)], registry);
    state.SetLabel(behaviours[state.range(0)]);
    const Floor floor = floor_of(LabWorld{});
    Coverage coverage(floor);
    Episode episode(program, {.random = Random(0)});
    for (auto _ : state) {
        episode.tick();
        coverage.add(episode.robot().x, episode.robot().y, episode.state().tick);
        benchmark::DoNotOptimize(episode);
    }
}
BENCHMARK(lab_file_with_coverage)
    ->Name("world step/lab, from a file, with coverage")
    ->DenseRange(0, 1);

/// Runs of ten minutes as a sweep makes them, every thread its own.
void sweep_runs(benchmark::State& state) {
    static const Roombas registry;
    static const Program program = program_of(behaviours[0], registry);
    static const Floor floor = floor_of(LabWorld{});
    std::int64_t seed = state.thread_index();
    for (auto _ : state) {
        benchmark::DoNotOptimize(measured_run(program, {.random = Random(seed)}, floor,
                                              {.stops = {36'000}, .curve = {36'000}}));
        seed += state.threads();
    }
    state.SetItemsProcessed(state.iterations() * 36'000);
}
BENCHMARK(sweep_runs)->Name("sweep/runs of 36,000 ticks")->Threads(1)->Threads(2)->UseRealTime();

/// Ten minutes, ticked or leaped over.
void ten_minutes(benchmark::State& state) {
    const Roombas registry;
    const Program program = program_of(behaviours[state.range(0)], registry);
    const bool leaps = state.range(1) != 0;
    state.SetLabel(behaviours[state.range(0)] + std::string(leaps ? ", leaped" : ", ticked"));
    FastForward forward(program);
    constexpr std::uint64_t ticks = 36'000;
    std::int64_t seed = 0;
    for (auto _ : state) {
        Episode episode(program, {.random = Random(seed++)});
        while (episode.state().tick < ticks) {
            if (leaps && forward.leap(episode, ticks - episode.state().tick) != 0) continue;
            episode.tick();
        }
        benchmark::DoNotOptimize(episode);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(ticks));
}
BENCHMARK(ten_minutes)->Name("ten minutes")->ArgsProduct({{0, 1}, {0, 1}});

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
