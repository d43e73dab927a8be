// Ticks of trees of other sizes and shapes than the lab's: steady RUNNING with and without memory,
// a thousand leaves in one tick, one script; what a node weighs. Per node: time divided by the
// nodes that a tick reaches. Results per machine are in bench/README.md.
// SPDX-License-Identifier: MIT
#include "exec/step.h"
#include "support.h"
#include "tree_shapes.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

namespace trellis {
namespace {

void tick(benchmark::State& bench, const std::string& root, std::int64_t nodes) {
    const Program program = bench::loaded("bench.xml", bench::tree_file(root));
    State state = fresh_state(program);
    bench::Host host;
    for (auto _ : bench) {
        benchmark::DoNotOptimize(step(program, state, host));
    }
    bench.counters["per node"] = benchmark::Counter(static_cast<double>(nodes),
                                                    benchmark::Counter::kIsIterationInvariantRate |
                                                        benchmark::Counter::kInvert);
}

void steady_with_memory(benchmark::State& bench) {
    tick(bench, bench::nested_with_memory(bench.range(0)), bench.range(0));
}
BENCHMARK(steady_with_memory)->Name("tree/steady, memory")->Arg(3)->Arg(10)->Arg(50);

void steady_reactive(benchmark::State& bench) {
    tick(bench, bench::reactive(bench.range(0)), bench.range(0) + 2);
}
BENCHMARK(steady_reactive)->Name("tree/steady, reactive")->Arg(1)->Arg(10)->Arg(100);

void thousand_leaves(benchmark::State& bench, const std::string& leaf) {
    tick(bench, bench::thousand(leaf), 1001);
}
BENCHMARK_CAPTURE(thousand_leaves, actions, "<Done/>")->Name("tree/1000 actions in a tick");
BENCHMARK_CAPTURE(thousand_leaves, conditions, "<Yes/>")->Name("tree/1000 conditions in a tick");

void script_node(benchmark::State& bench) {
    tick(bench, bench::two_scripts, 2);
}
BENCHMARK(script_node)->Name("tree/two scripts in a tick");

// Not a time: what a node of a large tree weighs.
void weight(benchmark::State& bench) {
    const Program program = bench::loaded(
        "bench.xml", bench::tree_file("<Sequence>" +
                                      bench::repeated("<Fallback><Busy/><Done/></Fallback>", 3000) +
                                      "</Sequence>"));
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
