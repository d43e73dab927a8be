// How the nodes of a tree are ticked: BehaviorTree.CPP 4.10's rules, one function each (TREES §1).
// Here are the nodes of every tree; the others are in tree_controls.cpp, tree_decorators.cpp and
// tree_leaves.cpp.
// Covered by tests/exec/tree_test.cpp and, on all small trees, tests/exec/tree_reference_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

namespace trellis {

Status Stepper::dispatch(RowId n, const Row& row) {
    using enum Status;
    switch (row.op) {
    case Op::sequence: return tick_in_order<failure, success>(n, row);
    case Op::fallback: return tick_in_order<success, failure>(n, row);
    case Op::reactive_sequence: return tick_reactive<failure, success>(n);
    case Op::reactive_fallback: return tick_reactive<success, failure>(n);
    case Op::inverter: return tick_mapped(n, failure, success);
    case Op::force_success: return tick_mapped(n, success, success);
    case Op::force_failure: return tick_mapped(n, failure, failure);
    case Op::repeat: return tick_loop<failure, success>(n, row);
    case Op::retry: return tick_loop<success, failure>(n, row);
    case Op::async_sequence: return tick_in_order<failure, success, true>(n, row);
    case Op::async_fallback: return tick_in_order<success, failure, true>(n, row);
    case Op::sequence_with_memory: return tick_in_order<failure, success, true, true>(n, row);
    case Op::parallel: return tick_parallel(n, row);
    case Op::parallel_all: return tick_parallel_all(n, row);
    case Op::if_then_else: return tick_if_then_else(n);
    case Op::while_do_else: return tick_while_do_else(n);
    case Op::switch2:
    case Op::switch3:
    case Op::switch4:
    case Op::switch5:
    case Op::switch6: return tick_switch(n, row);
    case Op::try_catch: return tick_try_catch(n, row);
    case Op::keep_running: return tick_keep_running(n);
    case Op::delay: return tick_delay(n, row);
    case Op::timeout: return tick_timeout(n, row);
    case Op::run_once: return tick_run_once(n, row);
    case Op::precondition: return tick_precondition(n, row);
    case Op::loop_int: return tick_queue(n, row, EntryType::integer);
    case Op::loop_bool: return tick_queue(n, row, EntryType::boolean);
    case Op::loop_double: return tick_queue(n, row, EntryType::real);
    case Op::loop_string: return tick_queue(n, row, EntryType::text);
    case Op::skip_unless_updated: return tick_updated(n, row, skipped);
    case Op::wait_value_update: return tick_updated(n, row, running);
    case Op::always_success: return ticked(n, success);
    case Op::always_failure: return ticked(n, failure);
    case Op::set_blackboard: return tick_set_blackboard(n, row);
    case Op::unset_blackboard: return tick_unset_blackboard(n, row);
    case Op::sleep: return tick_sleep(n, row);
    case Op::was_entry_updated:
        return ticked(n, was_written(p_.nodes[row.arg]) ? success : failure);
    case Op::run_machine: return tick_run_machine(n, row);
    case Op::test: return tick_test(n, row);
    case Op::script: return tick_script(n, row);
    case Op::script_condition: return tick_script_condition(n, row);
    case Op::action: return tick_action(n, row);
    case Op::condition: return tick_at_once(n, row);
    case Op::tree:
    case Op::subtree: return tick_scope(n);
    case Op::invoke: return tick_only_child(n);
    case Op::machine: return tick_machine(n);
    case Op::state:
    case Op::parallel_state:
    case Op::history:
    case Op::final: break;  // entered and left, never ticked
    }
    return fault(Fault::Kind::leaf_status, n, "a state cannot be ticked");
}

// Nobody may watch, and the budget must suffice.
template <Status go_on>
RowId Stepper::tick_leaves(RowId child, RowId last, Status& status) {
    if (trace_ != nullptr || budget_ <= last.index - child.index) { return child; }
    const RowId first = child;
    for (; child != last; ++child.index) {
        const Row& row = rows_[child.index];
        const bool leaf = row.op == Op::action || row.op == Op::condition;
        if (!leaf || row.conditional || status_[child.index] != Status::idle) { break; }
        const LeafCall& call = p_.calls[row.arg];
        if (call.input_count != 0 || call.output_count != 0) { break; }
        std::byte* const self = s_.leaves.data() + call.offset;
        refresh(call, self);
        s_.last_leaf = child;
        status = call.type->tick(self, host_, tick_);
        if (status != go_on) {
            if (status == Status::idle) { returned_idle(child, call); }
            if (status == Status::running && row.op == Op::condition) {
                status = did_not_answer(child, call);
            }
            keep(child, status);
            break;
        }
        status_[child.index] = go_on;
    }
    budget_ -= child.index - first.index;
    return child;
}

// Sequence and Fallback: tick children in order until one returns `stop`, resume at the running
// one. A tick of children that were all skipped is skipped. The others of their kind yield after
// each child that completes in the tick it began, or begin again where they stopped.
template <Status stop, Status go_on, bool yields, bool keeps_place>
Status Stepper::tick_in_order(RowId n, const Row& row) {
    const RowId first = first_child(n);
    const RowId last = row.end;
    std::uint32_t& memory = memory_[n.index];

    // a fresh start counts skipped children anew; one that begins later cannot skip them all
    RowId child{memory & ~not_all_skipped};
    if (child.index == 0) { child = first; }
    std::uint32_t seen = memory & not_all_skipped;
    const Status stored = status_[n.index];
    if (stored == Status::idle || stored == Status::skipped) {
        seen = child == first ? 0 : not_all_skipped;
        clear_skips(row);
    }
    store(n, Status::running);

    RowId answered = first;  // all before it are leaves that have completed
    while (child != last) {
        const bool fresh = yields && status_[child.index] == Status::idle;
        Status status = go_on;
        if (!yields) {
            const RowId begin = child;
            child = tick_leaves<go_on>(begin, last, status);
            if (child != begin) { seen = not_all_skipped; }
            if (begin == answered) { answered = child; }
            if (child == last) { break; }
        }
        if (status == go_on) { status = tick_child(child); }
        const RowId next = rows_[child.index].end;
        switch (status) {
        case Status::running: memory = child.index | seen; return status;
        case Status::idle: return status;
        case stop:
            memory = keeps_place ? child.index | seen : 0;
            reset_from(keeps_place ? child : first, last);
            return status;
        case Status::skipped:
            if (row.arg != 0) { ++s_.words[row.arg - 1]; }
            break;
        case go_on:
            seen = not_all_skipped;
            if (fresh && next != last) {
                memory = next.index | seen;
                s_.woken = true;
                return Status::running;
            }
            break;
        }
        child = next;
    }
    memory = 0;
    reset_leaves(first, answered);
    reset_from(answered, last);
    const bool all_skipped = row.arg != 0 ? s_.words[row.arg - 1] == child_count(n) : seen == 0;
    clear_skips(row);
    return all_skipped ? Status::skipped : go_on;
}

// ReactiveSequence and ReactiveFallback: start at the first child in every tick. While one runs,
// every other child is reset, before and after it.
template <Status stop, Status go_on>
Status Stepper::tick_reactive(RowId n) {
    const RowId first = first_child(n);
    const RowId last = rows_[n.index].end;
    store(n, Status::running);
    Status status = go_on;
    const RowId answered = tick_leaves<go_on>(first, last, status);
    bool all_skipped = answered == first;
    for (RowId child = answered; child != last; child = rows_[child.index].end) {
        if (status == go_on) { status = tick_child(child); }
        switch (status) {
        case Status::running:
            reset_leaves(first, answered);
            for (RowId other = answered; other != last; other = rows_[other.index].end) {
                if (other != child) { reset(other); }
            }
            return status;
        case Status::idle: return status;
        case stop:
            reset_leaves(first, answered);
            reset_from(answered, last);
            return status;
        case Status::skipped: reset(child); break;
        case go_on: all_skipped = false; break;
        }
        status = go_on;
    }
    reset_leaves(first, answered);
    reset_from(answered, last);
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
