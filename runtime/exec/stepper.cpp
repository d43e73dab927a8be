// What trees and machines share while stepping: stored statuses, conditions, halting, faults,
// trace.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

#include "core/ports.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace trellis {

Stepper::Stepper(const Program& program, State& state, HostRef host, const StepOptions& options)
    : p_(program), s_(state), rows_(program.rows.data()), status_(state.status.data()),
      memory_(state.memory.data()), host_(host.object), trace_(options.trace),
      while_woken_(options.while_woken),
      budget_(options.budget != 0 ? options.budget
                                  : 100'000 + 64 * static_cast<std::uint32_t>(program.rows.size())),
      tick_{state.tick, options.dt, &state.random} {
    context_.use(program.code, state.slots.data(), state.temporaries.data());
    context_.entry_types = reinterpret_cast<std::uint8_t*>(state.entries.data());
    context_.row_memory = memory_;
    context_.cycle = state.session.clock;
    context_.dt = options.dt;
    context_.host = static_cast<const std::byte*>(host.object);
    context_.random = &state.random;
    context_.in_state = [](const void* state_of, RowId row) {
        return static_cast<const State*>(state_of)->status[row.index] == Status::running;
    };
    context_.world = &state;
}

Status Stepper::step_root() {
    in_step_ = true;
    const RowId root{0};
    Status status = tick(root);
    while (while_woken_ && status == Status::running && s_.woken) {
        s_.woken = false;
        status = tick(root);
    }
    if (is_done(status) && !p_.is_machine()) { store(root, Status::idle); }
    if (s_.random.exhausted() && !s_.fault) {
        return fault(Fault::Kind::draws, s_.last_leaf, "there are no random numbers left");
    }
    ++s_.tick;
    return status;
}

Status Stepper::tick(RowId n) {
    const Row& row = rows_[n.index];
    if (budget_-- == 0) {
        return fault(Fault::Kind::budget, n, "this tick does not end: too many nodes were ticked");
    }
    if (row.conditional) { return tick_conditional(n, row); }
    const Status status = dispatch(n, row);
    // a skipped node keeps what its rule has stored (TREES §1)
    if (status != Status::skipped && status != Status::idle) { store(n, status); }
    return status;
}

// Conditions --------------------------------------------------------------------------------------

Status Stepper::tick_conditional(RowId n, const Row& row) {
    const Conditions& conditions = conditions_of(n);
    Status status = pre_conditions(n, conditions);
    if (s_.fault) { return Status::idle; }
    if (status == Status::idle) { status = dispatch(n, row); }
    if (is_done(status) && !post_conditions(n, conditions, status)) { return Status::idle; }
    if (status != Status::skipped && status != Status::idle) { store(n, status); }
    return status;
}

// The status that a pre-condition forces, or idle if none does (TREES §1.5).
Status Stepper::pre_conditions(RowId n, const Conditions& conditions) {
    const struct {
        CodeId code;
        Status forced;
    } before[] = {{conditions.failure_if, Status::failure},
                  {conditions.success_if, Status::success},
                  {conditions.skip_if, Status::skipped}};
    bool holds = false;
    const Status stored = status_[n.index];
    if (stored == Status::idle) {
        for (const auto& [code, forced] : before) {
            if (code && !condition(n, code, holds)) { return Status::idle; }
            if (code && holds) { return forced; }
        }
    }
    if (conditions.while_true && (stored == Status::idle || stored == Status::running)) {
        if (!condition(n, conditions.while_true, holds)) { return Status::idle; }
        if (holds) { return Status::idle; }
        if (stored == Status::running) { halt_node(n); }
        return Status::skipped;
    }
    return Status::idle;
}

bool Stepper::post_conditions(RowId n, const Conditions& conditions, Status status) {
    const CodeId first = status == Status::success ? conditions.on_success : conditions.on_failure;
    return (!first || run_script(n, first)) && (!conditions.post || run_script(n, conditions.post));
}

const Conditions& Stepper::conditions_of(RowId n) const {
    const auto found = std::lower_bound(
        p_.conditions.begin(), p_.conditions.end(), n,
        [](const std::pair<RowId, Conditions>& entry, RowId row) { return entry.first < row; });
    return found->second;
}

// Halting -----------------------------------------------------------------------------------------

void Stepper::halt_node(RowId n) {
    const Row& row = rows_[n.index];
    switch (row.op) {
    case Op::sequence:
    case Op::fallback:
    case Op::repeat:
    case Op::retry: memory_[n.index] = 0; [[fallthrough]];
    case Op::reactive_sequence:
    case Op::reactive_fallback:
    case Op::inverter:
    case Op::force_success:
    case Op::force_failure:
    case Op::tree:
    case Op::subtree:
    case Op::invoke: reset_children(n); break;
    case Op::action:
    case Op::condition:
        if (status_[n.index] == Status::running) { halt_leaf(n); }
        break;
    case Op::machine: leave_all(); break;
    case Op::script:
    case Op::script_condition:
    case Op::state:
    case Op::final: break;
    }
    if (status_[n.index] != Status::idle) { store(n, Status::idle); }
    if (row.conditional) {
        const CodeId script = conditions_of(n).on_halted;
        if (script) { run_script(n, script); }
    }
}

void Stepper::reset_children(RowId n) {
    for (const RowId child : children(p_, n)) {
        reset(child);
    }
}

void Stepper::halt_root() {
    const RowId root{0};
    halt_node(root);
}

// Expressions -------------------------------------------------------------------------------------

bool Stepper::run_script(RowId n, CodeId code) {
    if (execute(p_.code, code, context_)) { return true; }
    fault(Fault::Kind::expression, n, evaluation_error());
    return false;
}

bool Stepper::condition(RowId n, CodeId code, bool& holds) {
    const Truth truth = evaluate_condition(p_.code, code, context_);
    holds = truth == Truth::yes;
    if (truth != Truth::failed) { return true; }
    fault(Fault::Kind::expression, n, evaluation_error());
    return false;
}

std::string Stepper::evaluation_error() const {
    std::vector<std::string> names;
    for (const Slot& slot : p_.slots) {
        names.push_back(slot.name);
    }
    return trellis::describe(context_.error, p_.code, names);
}

bool Stepper::integer_port(RowId n, CodeId code, std::int64_t& result) {
    Value value;
    if (!evaluate(p_.code, code, context_, value)) {
        fault(Fault::Kind::expression, n, evaluation_error());
        return false;
    }
    if (to_integer(value, result)) { return true; }
    fault(Fault::Kind::expression, n, print(value) + " is not a whole number");
    return false;
}

// Faults and trace --------------------------------------------------------------------------------

Status Stepper::fault(Fault::Kind kind, RowId n, std::string message) {
    // the first fault explains the others
    if (!s_.fault) { s_.fault = {kind, n, std::move(message)}; }
    return Status::idle;
}

void Stepper::trace_status(RowId n, Status status) {
    const Status from = status_[n.index];
    if (from == status) { return; }
    trace({.kind = TraceEvent::Kind::status, .row = n, .from = from, .to = status});
}

void Stepper::trace_tick(RowId n, Status status) {
    trace({.kind = TraceEvent::Kind::tick, .row = n, .to = status});
}

}  // namespace trellis
