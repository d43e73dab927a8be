// How the nodes of a tree are ticked: BehaviorTree.CPP 4.10's rules, one function each (TREES §1).
// Covered by tests/exec/tree_test.cpp and, on all small trees, tests/exec/tree_reference_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

namespace trellis {

Status Stepper::dispatch(RowId n, const Row& row) {
    using enum Status;
    switch (row.op) {
    case Op::sequence: return tick_in_order<failure, success>(n);
    case Op::fallback: return tick_in_order<success, failure>(n);
    case Op::reactive_sequence: return tick_reactive<failure, success>(n);
    case Op::reactive_fallback: return tick_reactive<success, failure>(n);
    case Op::inverter: return tick_mapped(n, failure, success);
    case Op::force_success: return tick_mapped(n, success, success);
    case Op::force_failure: return tick_mapped(n, failure, failure);
    case Op::repeat: return tick_loop<failure, success>(n, row);
    case Op::retry: return tick_loop<success, failure>(n, row);
    case Op::script: return tick_script(n, row);
    case Op::script_condition: return tick_script_condition(n, row);
    case Op::action: return tick_action(n, row);
    case Op::condition: return tick_at_once(n, row);
    case Op::tree:
    case Op::subtree: return tick_scope(n);
    case Op::invoke: return tick_only_child(n);
    case Op::machine: return tick_machine(n);
    case Op::state:
    case Op::final: break;  // entered and left, never ticked
    }
    return fault(Fault::Kind::leaf_status, n, "a state cannot be ticked");
}

// Sequence and Fallback: tick children in order until one returns `stop`, resume at the running
// one. A tick of children that were all skipped is skipped.
template <Status stop, Status go_on>
Status Stepper::tick_in_order(RowId n) {
    const RowId first = first_child(n);
    const RowId last = rows_[n.index].end;
    std::uint32_t& memory = memory_[n.index];

    // a fresh start counts skipped children anew; one that begins later cannot skip them all
    RowId child{memory & ~not_all_skipped};
    if (child.index == 0) { child = first; }
    std::uint32_t seen = memory & not_all_skipped;
    const Status stored = status_[n.index];
    if (stored == Status::idle || stored == Status::skipped) {
        seen = child == first ? 0 : not_all_skipped;
    }
    store(n, Status::running);

    while (child != last) {
        const Status status = tick(child);
        switch (status) {
        case Status::running: memory = child.index | seen; return status;
        case Status::idle: return status;
        case stop:
            memory = 0;
            reset_children(n);
            return status;
        case Status::skipped: break;
        case go_on: seen = not_all_skipped; break;
        }
        child = rows_[child.index].end;
    }
    memory = 0;
    reset_children(n);
    return seen != 0 ? go_on : Status::skipped;
}

// ReactiveSequence and ReactiveFallback: start at the first child in every tick. While one runs,
// every other child is reset, before and after it.
template <Status stop, Status go_on>
Status Stepper::tick_reactive(RowId n) {
    const RowId last = rows_[n.index].end;
    bool all_skipped = true;
    store(n, Status::running);
    for (RowId child = first_child(n); child != last; child = rows_[child.index].end) {
        const Status status = tick(child);
        switch (status) {
        case Status::running:
            for (const RowId other : children(p_, n)) {
                if (other != child) { reset(other); }
            }
            return status;
        case Status::idle: return status;
        case stop: reset_children(n); return status;
        case Status::skipped: reset(child); break;
        case go_on: all_skipped = false; break;
        }
    }
    reset_children(n);
    return all_skipped ? Status::skipped : go_on;
}

// Inverter, ForceSuccess, ForceFailure: running and skipped pass.
Status Stepper::tick_mapped(RowId n, Status on_success, Status on_failure) {
    store(n, Status::running);
    const RowId child = first_child(n);
    const Status status = tick(child);
    if (!is_done(status)) { return status; }
    reset(child);
    return status == Status::success ? on_success : on_failure;
}

// Repeat and RetryUntilSuccessful: run the child again while it returns `go_on`. A child that
// completes in the tick it began yields, so that a tick is at most one cycle of a synchronous
// child.
template <Status stop, Status go_on>
Status Stepper::tick_loop(RowId n, const Row& row) {
    const RowId child = first_child(n);
    std::uint32_t& count = memory_[n.index];
    std::int64_t cycles = 0;
    if (!integer_port(n, p_.ports[row.arg], cycles)) { return Status::idle; }
    const auto more = [&] { return cycles == -1 || count < cycles; };

    store(n, Status::running);
    bool again = more();
    while (again) {
        const bool fresh = status_[child.index] == Status::idle;
        const Status status = tick(child);
        switch (status) {
        case go_on:
            ++count;
            // only RetryUntilSuccessful sees that its child has changed the number
            if (row.op == Op::retry && !integer_port(n, p_.ports[row.arg], cycles)) {
                return Status::idle;
            }
            again = more();
            reset(child);
            if (fresh && again) {
                s_.woken = true;
                return Status::running;
            }
            break;
        case stop:
            count = 0;
            reset(child);
            return status;
        case Status::skipped: reset(child); return status;  // the count is kept
        case Status::running:
        case Status::idle: return status;
        }
    }
    count = 0;
    return go_on;
}

Status Stepper::tick_script(RowId n, const Row& row) {
    s_.last_leaf = n;
    const CodeId code = p_.ports[row.arg];
    if (code && !run_script(n, code)) { return Status::idle; }
    trace_leaf(n, Status::success);
    return Status::success;
}

Status Stepper::tick_script_condition(RowId n, const Row& row) {
    s_.last_leaf = n;
    bool holds = false;
    if (!condition(n, p_.ports[row.arg], holds)) { return Status::idle; }
    const Status status = holds ? Status::success : Status::failure;
    trace_leaf(n, status);
    return status;
}

// A tree or subtree: passes its root's status on, and counts its ticks for elapsed().
Status Stepper::tick_scope(RowId n) {
    if (status_[n.index] == Status::idle) {
        memory_[n.index] = 0;
        store(n, Status::running);
    }
    ++memory_[n.index];
    return tick_only_child(n);
}

Status Stepper::tick_only_child(RowId n) {
    const RowId child = first_child(n);
    const Status status = tick(child);
    if (is_done(status)) { reset(child); }
    return status;
}

}  // namespace trellis
