// Loading: from the text of a tree file to a Program, per node, for files of up to a million nodes
// and for one small tree used ten thousand times; the time per node must not grow with either. Also
// what a node costs on the heap, in the Program and in a State. Results per machine are in
// bench/README.md.
// SPDX-License-Identifier: MIT
#include "core/state.h"
#include "load/load.h"
#include "sim/bridge/leaves.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <malloc.h>
#include <string>

namespace trellis {
namespace {

/// A tree of `nodes` leaves with ports below sequences of ten, written as a person would.
std::string big_tree(std::int64_t nodes) {
    std::string text = "<root BTCPP_format=\"4\">\n <BehaviorTree ID=\"Main\">\n  <Fallback>\n";
    for (std::int64_t i = 0; i < nodes; i += 11) {
        text += "   <Sequence name=\"part\">\n";
        for (int k = 0; k < 10; ++k) {
            text += "    <MoveForward speed=\"0.5\" duration=\"3.0\"/>\n";
        }
        text += "   </Sequence>\n";
    }
    return text + "  </Fallback>\n </BehaviorTree>\n</root>\n";
}

/// `uses` of one tree of three nodes, each with a parameter.
std::string many_subtrees(std::int64_t uses) {
    std::string text = "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n"
                       " <BehaviorTree ID=\"Main\">\n  <Fallback>\n";
    for (std::int64_t i = 0; i < uses; ++i) {
        text += "   <SubTree ID=\"Part\" time=\"3.0\"/>\n";
    }
    return text + "  </Fallback>\n </BehaviorTree>\n <BehaviorTree ID=\"Part\">\n  <Sequence>\n"
                  "   <MoveForward speed=\"0.5\" duration=\"{time}\"/>\n   <GoBack/>\n"
                  "  </Sequence>\n </BehaviorTree>\n</root>\n";
}

/// Bytes that are allocated now.
double heap() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Sets the counters of the bytes that one row of the program and of a state of it hold.
void count_bytes(benchmark::State& state, const Source& source, const Registry& registry) {
    std::optional<Program> program;
    const double before = heap();
    {
        Diagnostics diagnostics;
        program = load(source, registry, diagnostics);
    }
    const double loaded = heap();
    const State fresh = fresh_state(*program);
    const double rows = static_cast<double>(program->rows.size());
    state.counters["program B"] = (loaded - before) / rows;
    state.counters["state B"] = (heap() - loaded) / rows;
    state.counters["leaves B"] = static_cast<double>(fresh.leaves.size()) / rows;
}

void load_text(benchmark::State& state, std::string text) {
    Registry registry;
    register_roomba(registry);
    const Source source{"big.xml", std::move(text)};
    std::size_t rows = 0;
    for (auto _ : state) {
        Diagnostics diagnostics;
        const std::optional<Program> program = load(source, registry, diagnostics);
        if (!program) { std::abort(); }
        rows = program->rows.size();
        benchmark::DoNotOptimize(rows);
    }
    state.counters["per node"] = benchmark::Counter(static_cast<double>(rows),
                                                    benchmark::Counter::kIsIterationInvariantRate |
                                                        benchmark::Counter::kInvert);
    count_bytes(state, source, registry);
}

void load_tree(benchmark::State& state) {
    load_text(state, big_tree(state.range(0)));
}
BENCHMARK(load_tree)->Name("load tree")->RangeMultiplier(10)->Range(100, 1'000'000);

void load_subtrees(benchmark::State& state) {
    load_text(state, many_subtrees(state.range(0)));
}
BENCHMARK(load_subtrees)->Name("load subtrees")->RangeMultiplier(10)->Range(100, 10'000);

}  // namespace
}  // namespace trellis
