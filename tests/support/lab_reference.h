// The lab's two behaviours written the obvious way, as the judge of everything that runs them from
// a file: the machine is hand_written.h, the tree is a tree of objects like the lab's own. Slow
// where that is clearer. Covered by tests/sim/lab_streams_test.cpp, which holds it against recorded
// runs.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/lab_world.h"
#include "support/hand_written.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

/// The robot after one tick of a lab run, the leaf that ran last in it and, for a tree, more.
struct LabRow {
    std::int64_t tick = 0;  ///< 0 is the start, before the first tick
    double x = 0.0;         ///< m
    double y = 0.0;         ///< m
    double rotation = 0.0;  ///< rad
    double v = 0.0;         ///< m/s
    double w = 0.0;         ///< rad/s
    bool bumper = false;
    std::string leaf;    ///< "-" if none has run yet
    std::string status;  ///< of the root, "RUNNING" or "SUCCESS"; empty for a machine
    std::string path;    ///< leaves that ran in this tick, "GoBack>Rotate"; empty for a machine

    friend bool operator==(const LabRow&, const LabRow&) = default;
};

/// The row as the recordings write it, numbers as hex floats, for messages about differences.
std::string text_of(const LabRow& row);

/// "MoveForward", "MoveInSpiral", "GoBack" or "Rotate".
std::string_view name_of(LabLeaf leaf);

/// Rows 0 to `ticks` of the lab's machine in `world`, turning by `angles` (rad, not empty).
std::vector<LabRow> run_lab_machine(const LabWorld& world, std::span<const double> angles,
                                    std::int64_t ticks);

/// The same of the lab's behaviour tree.
std::vector<LabRow> run_lab_tree(const LabWorld& world, std::span<const double> angles,
                                 std::int64_t ticks);

}  // namespace trellis::test
