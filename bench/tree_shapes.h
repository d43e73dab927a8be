// The trees that tree_bench.cpp measures, as files: here, because other engines are to run the same
// ones. Their leaves are those of support.h: Busy, Done, Yes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace trellis::bench {

inline std::string tree_file(const std::string& root) {
    return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + root + "</BehaviorTree></root>";
}

inline std::string repeated(const std::string& element, std::int64_t count) {
    std::string all;
    for (std::int64_t i = 0; i < count; ++i) {
        all += element;
    }
    return all;
}

/// Nodes with memory, so deep: a tick leads straight to the leaf that runs.
inline std::string nested_with_memory(std::int64_t depth) {
    std::string root = "<Busy/>";
    for (std::int64_t i = 1; i < depth; ++i) {
        root = i % 2 == 0 ? "<Sequence><Done/>" + root + "</Sequence>"
                          : "<Fallback>" + root + "<Done/></Fallback>";
    }
    return root;
}

/// Conditions that are asked in every tick, and the leaf behind them.
inline std::string reactive(std::int64_t conditions) {
    return "<ReactiveSequence>" + repeated("<Yes/>", conditions) + "<Busy/></ReactiveSequence>";
}

inline std::string thousand(const std::string& leaf) {
    return "<Sequence>" + repeated(leaf, 1000) + "</Sequence>";
}

inline const char* const two_scripts =
    "<Sequence><Script code=\"n := 1.5\"/><Script code=\"n += 1\"/></Sequence>";

}  // namespace trellis::bench
