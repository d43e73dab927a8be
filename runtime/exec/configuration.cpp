// Entering and leaving states: which rows become active or idle, in which order, and what runs then
// (SCXML 3.4, 3.7, 3.8, 3.9, 3.13). Covered by tests/exec/machine_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

#include <algorithm>

namespace trellis {

// Leaves every active state inside `domain`, innermost first.
void Stepper::leave_below(RowId domain) {
    RowId n = s_.session.atom;
    while (n != domain && p_.within(n, domain)) {
        const RowId parent = rows_[n.index].parent;
        leave(n);
        n = parent;
    }
    s_.session.atom = n;
}

void Stepper::leave(RowId n) {
    const StateInfo& state = p_.state(n);
    run_blocks(state.first_exit, state.exit_count);
    if (state.invokes != 0) {
        for (const RowId invoke : invokes_of(n)) {
            reset(invoke);
        }
        std::erase_if(s_.session.invokes, [&](RowId invoke) { return p_.within(invoke, n); });
    }
    store(n, Status::idle);
    trace({.kind = TraceEvent::Kind::leave, .row = n});
}

void Stepper::take_initial(RowId n) {
    const Transition& initial = p_.transitions[p_.state(n).initial.index];
    if (initial.block) { run_block(initial.block); }
    enter_targets(initial);
}

void Stepper::enter_targets(const Transition& transition) {
    for (std::uint32_t i = 0; i < transition.target_count; ++i) {
        const RowId target = p_.targets[transition.first_target + i];
        enter_path(transition.domain, target);
        if (p_.state(target).initial) { take_initial(target); }
    }
}

// Enters the states from below `domain` down to `target`, outermost first. A state entered on the
// way to a target does not run its <initial> (SCXML 3.6).
void Stepper::enter_path(RowId domain, RowId target) {
    if (rows_[target.index].parent != domain) { enter_path(domain, rows_[target.index].parent); }
    enter(target);
}

void Stepper::enter(RowId n) {
    const StateInfo& state = p_.state(n);
    store(n, Status::running);
    memory_[n.index] = s_.session.clock;
    s_.session.atom = n;
    trace({.kind = TraceEvent::Kind::enter, .row = n});
    run_blocks(state.first_entry, state.entry_count);
    if (state.invokes != 0) {
        for (const RowId invoke : invokes_of(n)) {
            ++memory_[invoke.index];
            store(invoke, Status::running);
            s_.session.invokes.push_back(invoke);
        }
    }
    if (rows_[n.index].op == Op::final) { finish(n); }
}

// A final state ends its parent: the machine, or a compound state (SCXML 3.7).
void Stepper::finish(RowId n) {
    const RowId parent = rows_[n.index].parent;
    if (rows_[parent.index].op == Op::machine) {
        s_.session.final = n;
    } else if (p_.state(parent).done) {
        s_.session.internal.push_back(
            {.name = p_.state(parent).done, .type = Event::Type::platform});
    }
}

Children Stepper::invokes_of(RowId n) const {
    return children(p_, n).first(p_.state(n).invokes);
}

// Leaves every active state of the machine.
void Stepper::leave_all() {
    leave_below({0});
}

}  // namespace trellis
