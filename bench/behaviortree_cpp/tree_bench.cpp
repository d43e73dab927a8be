// The trees of bench/tree_bench.cpp on BehaviorTree.CPP 4, in the same run: same files, leaves that
// do as little. Compiled where CMake finds the library.
// SPDX-License-Identifier: MIT
#include "tree_shapes.h"

#include <behaviortree_cpp/bt_factory.h>
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

namespace trellis::bench {
namespace {

class Busy final : public BT::StatefulActionNode {
public:
    using StatefulActionNode::StatefulActionNode;
    static BT::PortsList providedPorts() { return {}; }

private:
    BT::NodeStatus onStart() override { return BT::NodeStatus::RUNNING; }
    BT::NodeStatus onRunning() override { return BT::NodeStatus::RUNNING; }
    void onHalted() override {}
};

BT::NodeStatus succeed(BT::TreeNode&) {
    return BT::NodeStatus::SUCCESS;
}

void tick(benchmark::State& bench, const std::string& root, std::int64_t nodes) {
    BT::BehaviorTreeFactory factory;
    factory.registerNodeType<Busy>("Busy");
    factory.registerSimpleAction("Done", succeed);
    factory.registerSimpleCondition("Yes", succeed);
    BT::Tree tree = factory.createTreeFromText(tree_file(root));
    for (auto _ : bench) {
        benchmark::DoNotOptimize(tree.tickExactlyOnce());
    }
    bench.counters["per node"] = benchmark::Counter(static_cast<double>(nodes),
                                                    benchmark::Counter::kIsIterationInvariantRate |
                                                        benchmark::Counter::kInvert);
}

void steady_with_memory(benchmark::State& bench) {
    tick(bench, nested_with_memory(bench.range(0)), bench.range(0));
}
BENCHMARK(steady_with_memory)
    ->Name("tree/steady, memory, BehaviorTree.CPP")
    ->Arg(3)
    ->Arg(10)
    ->Arg(50);

void steady_reactive(benchmark::State& bench) {
    tick(bench, reactive(bench.range(0)), bench.range(0) + 2);
}
BENCHMARK(steady_reactive)
    ->Name("tree/steady, reactive, BehaviorTree.CPP")
    ->Arg(1)
    ->Arg(10)
    ->Arg(100);

void thousand_leaves(benchmark::State& bench, const std::string& leaf) {
    tick(bench, thousand(leaf), 1001);
}
BENCHMARK_CAPTURE(thousand_leaves, actions, "<Done/>")
    ->Name("tree/1000 actions in a tick, BehaviorTree.CPP");
BENCHMARK_CAPTURE(thousand_leaves, conditions, "<Yes/>")
    ->Name("tree/1000 conditions in a tick, BehaviorTree.CPP");

void script_node(benchmark::State& bench) {
    tick(bench, two_scripts, 2);
}
BENCHMARK(script_node)->Name("tree/two scripts in a tick, BehaviorTree.CPP");

}  // namespace
}  // namespace trellis::bench
