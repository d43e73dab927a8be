// One whole lab step, behaviour and physics, without a trace: from the files, beside the switch
// that a programmer would write by hand; and the tree's tick alone. The files are those of trees/
// and machines/, the angles are random.Random(0)'s. Results per machine are in bench/README.md.
// SPDX-License-Identifier: MIT
#include "exec/step.h"
#include "load/load.h"
#include "sim/bridge/episode.h"
#include "sim/bridge/leaves.h"
#include "support/hand_written.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trellis {
namespace {

const Registry& roomba_registry() {
    static Registry registry;
    if (registry.leaves().empty()) { register_roomba(registry); }
    return registry;
}

Program program(const std::string& name) {
    std::ifstream file(std::string(TRELLIS_SOURCE_DIR) + '/' + name);
    std::string text(std::istreambuf_iterator<char>(file), {});
    Diagnostics diagnostics;
    std::optional<Program> loaded = load({name, std::move(text)}, roomba_registry(), diagnostics);
    if (!loaded) { std::abort(); }
    return std::move(*loaded);
}

void hand_written(benchmark::State& state) {
    Random random(0);
    std::vector<double> angles(4000);
    for (double& angle : angles) {
        angle = random.uniform(-std::numbers::pi, std::numbers::pi);
    }
    const LabWorld world;
    Roomba robot = at_start(world);
    test::HandWrittenFsm behaviour{test::Angles(angles)};
    for (auto _ : state) {
        sense(world, robot);
        behaviour.tick(robot);
        move(robot, lab_dt);
        benchmark::DoNotOptimize(robot);
    }
}
BENCHMARK(hand_written)->Name("lab step/hand-written switch");

void from_file(benchmark::State& state, const std::string& name) {
    const Program behaviour = program(name);
    Episode episode(behaviour, {.random = Random(0)});
    for (auto _ : state) {
        episode.tick();
        benchmark::DoNotOptimize(episode.robot());
    }
}
BENCHMARK_CAPTURE(from_file, machine, "machines/roomba.scxml")->Name("lab step/roomba.scxml");
BENCHMARK_CAPTURE(from_file, tree, "trees/roomba.xml")->Name("lab step/roomba.xml");
BENCHMARK_CAPTURE(from_file, primitives, "trees/roomba_primitives.xml")
    ->Name("lab step/roomba_primitives.xml");

/// Steady RUNNING: the robot never meets a wall and no time is up.
void tick_alone(benchmark::State& state, const std::string& name) {
    const Program behaviour = program(name);
    State running = fresh_state(behaviour);
    Roomba robot;
    const StepOptions options{.dt = 1e-12};
    for (auto _ : state) {
        benchmark::DoNotOptimize(step(behaviour, running, robot, options));
    }
}
BENCHMARK_CAPTURE(tick_alone, machine, "machines/roomba.scxml")->Name("tick alone/roomba.scxml");
BENCHMARK_CAPTURE(tick_alone, tree, "trees/roomba.xml")->Name("tick alone/roomba.xml");

}  // namespace
}  // namespace trellis
