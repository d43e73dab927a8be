// The leaves of a state that run: only their structs hold anything. Private to runtime/core.
// Covered by tests/core/state_test.cpp and tests/exec/save_restore_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"

#include <cstddef>
#include <vector>

namespace trellis {

/// Calls `visit(call)` for every leaf that runs: others begin anew.
template <class Visit>
void for_each_running(const Program& program, const std::vector<Status>& status, Visit visit) {
    for (std::size_t n = 0; n < program.rows.size(); ++n) {
        const Row& row = program.rows[n];
        if (status[n] == Status::running && row.op == Op::action) { visit(program.calls[row.arg]); }
    }
}

/// Calls `visit(place in State::leaves, size)` for every registered state member of these leaves.
template <class Visit>
void for_each_member(const Program& program, const std::vector<Status>& status, Visit visit) {
    for_each_running(program, status, [&](const LeafCall& call) {
        for (const StateMember& member : call.type->state) {
            visit(call.offset + member.offset, member.size);
        }
    });
}

}  // namespace trellis
