// Runs a tree file with scripted leaves and writes what happened as the recorded runs of
// BehaviorTree.CPP are written, so that the two texts can be compared (TREES, "The test driver").
// Covered by tests/exec/tree_cases_test.cpp; the program is tests/conformance/tree_driver.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace trellis::test {

struct DriveOptions {
    std::uint64_t ticks = 20;
    bool once = false;                   ///< tick again while a wake-up is pending
    bool transitions = false;            ///< write changes of stored statuses
    bool blackboards = true;             ///< write them at the end
    std::set<std::uint64_t> halts = {};  ///< halt the tree after these ticks
    std::string main_tree = {};          ///< empty: what the file says
};

/// The options that words like "20", "--once", "--halt-at=2,3" spell.
DriveOptions drive_options(const std::vector<std::string>& words);

struct Drive {
    std::string output;    ///< the recorded format; "LOAD_ERROR\n" if the file has faults
    std::string messages;  ///< why: rendered diagnostics or the fault of the run
};

/// Runs the tree file at `path`; includes are read from the disk.
Drive drive_tree(const std::string& path, const DriveOptions& options);

}  // namespace trellis::test
