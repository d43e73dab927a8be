// The commonest steps, in which nothing is decided: a machine that gets no event but `tick` and
// finds no guard that holds, a tree that goes on at the leaf it stopped at; then one leaf is
// ticked, and goes on. Run without setting up the interpreter, inlined into step(). Everything is
// asked before anything is done, so that a step that proves to be another kind can begin anew in
// machine_rules.cpp or tree_rules.cpp. What lies ahead is found in quiet_step.cpp. Private to
// runtime/exec. Covered by tests/exec/quiet_step_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "core/state.h"
#include "exec/forms.h"
#include "exec/step.h"

#include <cstring>

namespace trellis {

/// What such a step came to.
struct QuietStep {
    bool taken = false;               ///< else nothing has happened: this may be another kind
    Status status = Status::running;  ///< what the leaf returned; it is State::last_leaf
};

namespace detail {

[[gnu::always_inline]] inline QuietStep tick_leaf(const LeafCall& leaf, std::byte* self, RowId row,
                                                  State& state, HostRef host, double dt) {
    state.last_leaf = row;
    return {true, leaf.type->tick(self, host.object, {state.tick, dt, &state.random})};
}

}  // namespace detail

/// Tries it on a machine.
[[gnu::always_inline]] inline QuietStep quiet_cycle(const Program& program, State& state,
                                                    HostRef host, const StepOptions& options) {
    Session& session = state.session;
    if (options.trace != nullptr || options.dt != state.quiet.dt || !session.external.empty())
        [[unlikely]] {
        return {};
    }
    const QuietState& quiet = program.quiet_states[state.quiet.id.index];
    const std::uint32_t* const sensors = program.quiet_sensors.data();
    for (std::uint32_t i = quiet.first_sensor; i != quiet.sensor_end; ++i) {
        if (sensed(host.object, sensors[i])) [[unlikely]] { return {}; }
    }

    --state.quiet.cycles;
    ++session.clock;
    const LeafCall& leaf = program.calls[quiet.call];
    std::byte* const self = state.leaves.data() + leaf.offset;
    const FormView view{program, state, host.object, session.clock, options.dt};
    const QuietInput* const inputs = program.quiet_inputs.data();
    for (std::uint32_t i = quiet.first_input; i != quiet.input_end; ++i) {
        const double value = compute(view, inputs[i].formula);
        std::memcpy(self + inputs[i].offset, &value, sizeof value);
    }
    return detail::tick_leaf(leaf, self, quiet.activity, state, host, options.dt);
}

/// Tries it on a tree; a machine has nowhere to resume.
[[gnu::always_inline]] inline QuietStep quiet_tick(const Program& program, State& state,
                                                   HostRef host, const StepOptions& options) {
    const RowId n = state.resume;
    if (!n || options.trace != nullptr || (options.while_woken && state.woken)) { return {}; }
    const Row* const rows = program.rows.data();
    const Row& row = rows[n.index];
    if (row.op != Op::action || row.conditional) { return {}; }
    const LeafCall& leaf = program.calls[row.arg];
    if (leaf.input_count != 0 || leaf.output_count != 0) { return {}; }
    for (RowId scope = row.scope; scope; scope = rows[scope.index].scope) {
        ++state.memory[scope.index];
    }
    return detail::tick_leaf(leaf, state.leaves.data() + leaf.offset, n, state, host, options.dt);
}

}  // namespace trellis
