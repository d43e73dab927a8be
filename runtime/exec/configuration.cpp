// Entering and leaving states: which rows become active or idle, in which order, and what runs then
// (SCXML 3.4, 3.7 to 3.10, 3.13). The configuration is a list of rows in document order: what a
// transition leaves is the slice of it below the transition's domain. Covered by
// tests/exec/machine_test.cpp, parallel_test.cpp, and machine_reference_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

#include <algorithm>

namespace trellis {

namespace {

// What Workspace::marks say of a row while states are being entered.
constexpr std::uint8_t is_wanted = 1;    // it is in Workspace::entering
constexpr std::uint8_t has_inner = 2;    // so is one of its children
constexpr std::uint8_t by_default = 4;   // nothing in it was targeted: its <initial> runs
constexpr std::uint8_t has_history = 8;  // content of a history's default way runs

}  // namespace

// Domains -----------------------------------------------------------------------------------------

Stepper::Slice Stepper::active_below(RowId domain) const {
    const std::vector<RowId>& active = s_.session.active;
    const auto first = std::upper_bound(active.begin(), active.end(), domain);
    const auto last = std::lower_bound(first, active.end(), rows_[domain.index].end);
    return {static_cast<std::size_t>(first - active.begin()),
            static_cast<std::size_t>(last - active.begin())};
}

// Calls `visit` for every state that the targets stand for now: a history for what it has stored,
// else for where it leads (getEffectiveTargetStates).
template <class Visit>
void Stepper::visit_targets(const Transition& transition, Visit visit) const {
    for (std::uint32_t i = 0; i < transition.target_count; ++i) {
        const RowId target = p_.targets[transition.first_target + i];
        const Row& row = rows_[target.index];
        if (row.op != Op::history) {
            visit(target);
        } else if (!s_.session.histories[row.arg].empty()) {
            for (const RowId stored : s_.session.histories[row.arg]) {
                visit(stored);
            }
        } else {
            visit_targets(p_.transitions[p_.histories[row.arg].initial.index], visit);
        }
    }
}

// The row below which a transition leaves states; none if it leaves none. The compiler has found
// it, unless that depends on what a history has stored (getTransitionDomain).
RowId Stepper::domain_of(const Transition& transition) const {
    if (!transition.to_history) { return transition.domain; }
    RowId domain = transition.source;
    const auto grow = [&] {
        do {
            domain = rows_[domain.index].parent;
        } while (!is_compound(domain));
    };
    const auto is_around = [&](RowId target) {
        return target != domain && p_.within(target, domain);
    };
    bool inside = transition.internal;
    visit_targets(transition, [&](RowId target) { inside = inside && is_around(target); });
    if (inside) { return domain; }
    grow();
    visit_targets(transition, [&](RowId target) {
        while (!is_around(target)) {
            grow();
        }
    });
    return domain;
}

// Leaving -----------------------------------------------------------------------------------------

// Leaves every active state inside `domain`, in reverse document order.
void Stepper::leave_below(RowId domain) {
    const Slice leaving = active_below(domain);
    if (!p_.histories.empty()) { record_histories(leaving); }
    std::vector<RowId>& active = s_.session.active;
    for (std::size_t i = leaving.last; i != leaving.first; --i) {
        leave(active[i - 1]);
    }
    const auto begin = active.begin();
    active.erase(begin + static_cast<std::ptrdiff_t>(leaving.first),
                 begin + static_cast<std::ptrdiff_t>(leaving.last));
    s_.session.atom = active.empty() ? RowId() : active.back();
}

// What the states that are left will go back to, before anything of it is left (SCXML 3.10).
void Stepper::record_histories(Slice leaving) {
    const std::vector<RowId>& active = s_.session.active;
    for (std::size_t i = leaving.first; i != leaving.last; ++i) {
        const RowId n = active[i];
        const StateInfo& state = p_.state(n);
        if (state.histories == 0) { continue; }
        for (const RowId child : children(p_, n).first(state.invokes + state.histories)) {
            if (rows_[child.index].op != Op::history) { continue; }
            const std::uint32_t history = rows_[child.index].arg;
            std::vector<RowId>& stored = s_.session.histories[history];
            stored.clear();
            for (std::size_t k = i + 1; k != leaving.last && p_.within(active[k], n); ++k) {
                const bool counts = p_.histories[history].deep ? p_.state(active[k]).atomic
                                                               : rows_[active[k].index].parent == n;
                if (counts) { stored.push_back(active[k]); }
            }
        }
    }
}

void Stepper::leave(RowId n) {
    const StateInfo& state = p_.state(n);
    run_blocks(state.first_exit, state.exit_count);
    if (state.invokes != 0) { stop_invokes(n); }
    store(n, Status::idle);
    trace({.kind = TraceEvent::Kind::leave, .row = n});
}

// What is entered (computeEntrySet) ---------------------------------------------------------------
//
// All targets first, with the states on the way to them; then, for each state in the list, what it
// needs and has not got: a compound state its default, a parallel one its other regions.

void Stepper::want_targets(const Transition& transition, RowId top) {
    for (std::uint32_t i = 0; i < transition.target_count; ++i) {
        const RowId target = p_.targets[transition.first_target + i];
        const Row& row = rows_[target.index];
        if (row.op != Op::history) {
            want(target, top);
            continue;
        }
        const std::vector<RowId>& stored = s_.session.histories[row.arg];
        for (const RowId state : stored) {
            want(state, top);
        }
        if (!stored.empty()) { continue; }
        const Transition& initial = p_.transitions[p_.histories[row.arg].initial.index];
        if (initial.block) {
            s_.work.marks[row.parent.index] |= has_history;
            s_.work.history_content.emplace_back(row.parent, initial.block);
        }
        want_targets(initial, top);
    }
}

// Adds `n` and the states around it, up to and without `top`, outermost first.
void Stepper::want(RowId n, RowId top) {
    std::vector<RowId>& entering = s_.work.entering;
    std::vector<std::uint8_t>& marks = s_.work.marks;
    const auto first = static_cast<std::ptrdiff_t>(entering.size());
    while (n != top && (marks[n.index] & is_wanted) == 0) {
        marks[n.index] |= is_wanted;
        entering.push_back(n);
        n = rows_[n.index].parent;
        if (n != top) { marks[n.index] |= has_inner; }
    }
    std::reverse(entering.begin() + first, entering.end());
}

void Stepper::want_below(RowId n) {
    if (rows_[n.index].op == Op::parallel_state) {
        for (const RowId region : children(p_, n)) {
            if (op_table()[rows_[region.index].op].group == OpGroup::state) { want(region, n); }
        }
        return;
    }
    const TransitionId initial = p_.state(n).initial;
    if (!initial || (s_.work.marks[n.index] & has_inner) != 0) { return; }
    s_.work.marks[n.index] |= by_default;
    want_targets(p_.transitions[initial.index], n);
}

// Entering ----------------------------------------------------------------------------------------

// Enters what was wanted and what that needs, in document order.
void Stepper::enter_wanted() {
    std::vector<RowId>& entering = s_.work.entering;
    for (std::size_t i = 0; i < entering.size(); ++i) {
        want_below(entering[i]);
    }
    if (entering.empty()) { return; }
    if (!std::is_sorted(entering.begin(), entering.end())) {
        std::sort(entering.begin(), entering.end());
    }
    activate(entering);
    for (const RowId n : entering) {
        const std::uint8_t mark = s_.work.marks[n.index];
        s_.work.marks[n.index] = 0;
        enter(n, mark);
    }
    entering.clear();
    for (const auto& [state, block] : s_.work.history_content) {
        s_.work.marks[state.index] = 0;
    }
    s_.work.history_content.clear();
}

// Puts the rows, which are in document order, between those that are active: from the back, in
// place.
void Stepper::activate(const std::vector<RowId>& entering) {
    std::vector<RowId>& active = s_.session.active;
    std::size_t old = active.size();
    std::size_t fresh = entering.size();
    active.resize(old + fresh);
    for (std::size_t to = active.size(); fresh != 0; --to) {
        const bool older = old != 0 && entering[fresh - 1] < active[old - 1];
        active[to - 1] = older ? active[--old] : entering[--fresh];
    }
    s_.session.atom = active.back();
}

void Stepper::enter(RowId n, std::uint8_t mark) {
    const StateInfo& state = p_.state(n);
    store(n, Status::running);
    memory_[n.index] = s_.session.clock;
    trace({.kind = TraceEvent::Kind::enter, .row = n});
    run_blocks(state.first_entry, state.entry_count);
    if ((mark & by_default) != 0) {
        const BlockId content = p_.transitions[state.initial.index].block;
        if (content) { run_block(content); }
    }
    if ((mark & has_history) != 0) {
        for (const auto& [of, content] : s_.work.history_content) {
            if (of == n) { run_block(content); }
        }
    }
    if (state.invokes != 0) {
        for (const RowId invoke : invokes_of(n)) {
            s_.session.pending.push_back(invoke);
        }
    }
    if (rows_[n.index].op == Op::final) { finish(n); }
}

// A final state ends the machine, or the compound state around it and then the parallel states that
// wait for that one last. Appendix D looks only one level up; 3.4 asks for all of them.
void Stepper::finish(RowId n) {
    const auto raise_done = [&](RowId state, PayloadId data) {
        if (!p_.state(state).done) { return; }
        Event event{.name = p_.state(state).done, .type = Event::Type::platform};
        if (data && !carry(data, event)) { event.data.set_undefined(); }
        raise(std::move(event));
    };
    RowId around = rows_[n.index].parent;
    if (rows_[around.index].op == Op::machine) {
        s_.session.final = n;
        return;
    }
    raise_done(around, p_.state(n).donedata);
    for (around = rows_[around.index].parent;
         rows_[around.index].op == Op::parallel_state && is_finished(around);
         around = rows_[around.index].parent) {
        raise_done(around, {});
    }
}

// Whether a final state of `n` is active, of a parallel state: of all its regions (isInFinalState).
bool Stepper::is_finished(RowId n) const {
    const bool all = rows_[n.index].op == Op::parallel_state;
    for (const RowId child : children(p_, n)) {
        const Op op = rows_[child.index].op;
        if (op_table()[op].group != OpGroup::state) { continue; }
        const bool done =
            all ? is_finished(child) : op == Op::final && status_[child.index] == Status::running;
        if (done != all) { return done; }
    }
    return all;
}

}  // namespace trellis
