// Everything is asked before anything is done, so that a cycle that proves to be no quiet one can
// begin anew in machine_rules.cpp.
// SPDX-License-Identifier: MIT
#include "exec/quiet_cycle.h"

#include "core/leaf.h"
#include "exec/forms.h"

namespace trellis {

namespace {

// Whether machines run that this one has invoked, or a message is due.
bool has_business(const State& state) {
    const std::vector<Delayed>& delayed = state.session.delayed;
    return !state.children.empty() || (!delayed.empty() && delayed.front().due <= state.tick + 1);
}

bool any_guard_may_hold(const FormView& view, const StateInfo& atom) {
    const Condition* const first = view.program.quiet_guards.data() + atom.first_guard;
    for (const Condition* guard = first; guard != first + atom.guard_count; ++guard) {
        if (answer(view, *guard) != Answer::no) { return true; }
    }
    return false;
}

// Gives a leaf its inputs; false if one of them takes more than a formula.
bool write_inputs(const FormView& view, const LeafCall& leaf, std::byte* self) {
    const LiveInput* const first = view.program.live_inputs.data() + leaf.first_input;
    for (const LiveInput* input = first; input != first + leaf.input_count; ++input) {
        double value = 0.0;
        if (!input->formula || !compute(view, view.program.formulas[input->formula.index], value)) {
            return false;
        }
        std::memcpy(self + input->offset, &value, sizeof value);
    }
    return true;
}

}  // namespace

QuietCycle quiet_cycle(const Program& program, State& state, HostRef host,
                       const StepOptions& options) {
    Session& session = state.session;
    if (options.trace != nullptr || program.event_slot || !session.atom ||
        session.invokes.size() != 1 || !session.external.empty() || !session.internal.empty() ||
        program.has_parallel || (program.has_messages && has_business(state))) {
        return {};
    }
    const Row* const rows = program.rows.data();
    const StateInfo& atom = program.states[rows[session.atom.index].arg];
    FormView view{program, state, host.object, session.clock, options.dt};
    if (!atom.may_be_quiet || any_guard_may_hold(view, atom)) { return {}; }

    const RowId body{session.invokes[0].index + 1};
    const Row& row = rows[body.index];
    if (row.op != Op::action || state.status[body.index] != Status::running) { return {}; }
    const LeafCall& leaf = program.calls[row.arg];
    std::byte* const self = state.leaves.data() + leaf.offset;
    // the activities of a cycle are in it: elapsed() counts it for them
    ++view.clock;
    if (leaf.output_count != 0 || !write_inputs(view, leaf, self)) { return {}; }

    session.clock = view.clock;
    state.last_leaf = body;
    const Status status =
        leaf.type->tick(self, host.object, {state.tick, options.dt, &state.random});
    if (status != Status::running) { return {QuietCycle::Outcome::ended, status}; }
    return {QuietCycle::Outcome::running, status};
}

}  // namespace trellis
