// What a compiled machine can reach: the states that may become active, and the transitions that
// never fire because another always comes first. Guards are not evaluated: one that is no literal
// may hold or not. Private to runtime/load; said in words by machine_checks.h.
// Covered by tests/load/machine_checks_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"

#include <vector>

namespace trellis {

struct MachineReach {
    std::vector<bool> entered;  ///< by row: may become active, or be gone to (histories)
    /// By transition: the one that is always taken instead, itself if its condition is literally
    /// false; none if it may be taken.
    std::vector<TransitionId> instead;
};

/// Of a machine that was compiled without errors.
MachineReach find_reach(const Program& program);

/// Whether the transition has no condition, or one that is literally true.
bool is_unguarded(const Program& program, const Transition& transition);

}  // namespace trellis
