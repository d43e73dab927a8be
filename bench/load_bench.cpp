// Loading: from the text of a tree file to a Program, per node, for files of up to 100,000 nodes;
// the time per node must not grow with the file. Results per machine are in bench/README.md.
// SPDX-License-Identifier: MIT
#include "load/load.h"
#include "sim/bridge/leaves.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
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

void load_tree(benchmark::State& state) {
    Registry registry;
    register_roomba(registry);
    const Source source{"big.xml", big_tree(state.range(0))};
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
}
BENCHMARK(load_tree)->Name("load tree")->Arg(100)->Arg(1'000)->Arg(10'000)->Arg(100'000);

}  // namespace
}  // namespace trellis
