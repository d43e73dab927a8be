// Ticks of trees of other sizes and shapes than the lab's: steady RUNNING with and without memory,
// a thousand leaves in one tick, one script; what a node weighs. Per node: time divided by the
// nodes that a tick reaches. Results per machine are in bench/README.md.
// SPDX-License-Identifier: MIT
#include "exec/step.h"
#include "support.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

namespace trellis {
namespace {

std::string tree(const std::string& root) {
    return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + root + "</BehaviorTree></root>";
}

std::string repeated(const std::string& element, std::int64_t count) {
    std::string all;
    for (std::int64_t i = 0; i < count; ++i) {
        all += element;
    }
    return all;
}

void tick(benchmark::State& bench, const std::string& root, std::int64_t nodes) {
    const Program program = bench::loaded("bench.xml", tree(root));
    State state = fresh_state(program);
    bench::Host host;
    for (auto _ : bench) {
        benchmark::DoNotOptimize(step(program, state, host));
    }
    bench.counters["per node"] = benchmark::Counter(static_cast<double>(nodes),
                                                    benchmark::Counter::kIsIterationInvariantRate |
                                                        benchmark::Counter::kInvert);
}

// nodes of memory: a tick leads straight to the leaf that runs
void steady_with_memory(benchmark::State& bench) {
    const std::int64_t depth = bench.range(0);
    std::string root = "<Busy/>";
    for (std::int64_t i = 1; i < depth; ++i) {
        root = i % 2 == 0 ? "<Sequence><Done/>" + root + "</Sequence>"
                          : "<Fallback>" + root + "<Done/></Fallback>";
    }
    tick(bench, root, depth);
}
BENCHMARK(steady_with_memory)->Name("tree/steady, memory")->Arg(3)->Arg(10)->Arg(50);

// conditions that are asked in every tick, and the leaf behind them
void steady_reactive(benchmark::State& bench) {
    const std::int64_t conditions = bench.range(0);
    tick(bench,
         "<ReactiveSequence>" + repeated("<Yes/>", conditions) + "<Busy/></ReactiveSequence>",
         conditions + 2);
}
BENCHMARK(steady_reactive)->Name("tree/steady, reactive")->Arg(1)->Arg(10)->Arg(100);

void thousand_leaves(benchmark::State& bench, const std::string& leaf) {
    tick(bench, "<Sequence>" + repeated(leaf, 1000) + "</Sequence>", 1001);
}
BENCHMARK_CAPTURE(thousand_leaves, actions, "<Done/>")->Name("tree/1000 actions in a tick");
BENCHMARK_CAPTURE(thousand_leaves, conditions, "<Yes/>")->Name("tree/1000 conditions in a tick");

void script_node(benchmark::State& bench) {
    tick(bench, "<Sequence><Script code=\"n := 1.5\"/><Script code=\"n += 1\"/></Sequence>", 2);
}
BENCHMARK(script_node)->Name("tree/two scripts in a tick");

// Not a time: what a node of a large tree weighs.
void weight(benchmark::State& bench) {
    const Program program = bench::loaded(
        "bench.xml",
        tree("<Sequence>" + repeated("<Fallback><Busy/><Done/></Fallback>", 3000) + "</Sequence>"));
    const State state = fresh_state(program);
    const auto rows = static_cast<double>(program.rows.size());
    for (auto _ : bench) {
        benchmark::DoNotOptimize(fresh_state(program));
    }
    const auto bytes = [](const auto& table) {
        return static_cast<double>(table.capacity() * sizeof(table[0]));
    };
    bench.counters["program bytes per node"] =
        (bytes(program.rows) + bytes(program.names.by_row) + bytes(program.origins) +
         bytes(program.calls) + bytes(program.prototypes) + bytes(program.live_inputs)) /
        rows;
    bench.counters["state bytes per node"] =
        (bytes(state.status) + bytes(state.memory) + bytes(state.leaves) + bytes(state.inputs)) /
        rows;
}
BENCHMARK(weight)->Name("tree/a fresh state of 9000 nodes");

}  // namespace
}  // namespace trellis
