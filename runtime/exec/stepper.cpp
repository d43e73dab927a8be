// What trees and machines share while stepping: stored statuses, conditions, halting, faults,
// trace.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

#include "core/ports.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace trellis {

void Stepper::fill_context() {
    EvalContext& context = context_.emplace();
    context.use(p_.code, s_.slots.data(), s_.temporaries.data());
    context.entry_types = reinterpret_cast<std::uint8_t*>(s_.entries.data());
    context.writes = s_.writes.empty() ? nullptr : s_.writes.data();
    context.row_memory = memory_;
    context.cycle = s_.session.clock;
    context.dt = tick_.dt;
    context.host = static_cast<const std::byte*>(host_);
    context.random = tick_.random;
    context.world = this;
    context.in_state = [](const void* stepper, RowId n) {
        return static_cast<const Stepper*>(stepper)->status_[n.index] == Status::running;
    };
    context.state_named = [](const void* stepper, std::string_view name) {
        const Program& program = static_cast<const Stepper*>(stepper)->p_;
        for (std::uint32_t i = 1; i < program.rows.size(); ++i) {
            const bool is_state = op_table()[program.rows[i].op].group == OpGroup::state;
            if (is_state && program.names[i] == name) { return RowId{i}; }
        }
        return RowId();
    };
}

Status Stepper::step_root() {
    in_step_ = true;
    const RowId root{0};
    return finish_step(rows_[0].op == Op::machine ? tick_machine(root) : step_tree(root));
}

Status Stepper::finish_step(Status status) {
    s_.quiet = {};
    if (s_.random.exhausted()) {
        return fault(Fault::Kind::draws, s_.last_leaf, "there are no random numbers left");
    }
    // a script that fails while something is halted does not stop the tick at once
    if (s_.fault) { return Status::idle; }
    if (status != Status::idle) { ++s_.tick; }
    if (status == Status::running && s_.session.atom) { find_quiet_cycles(); }
    return status;
}

Status Stepper::step_tree(RowId root) {
    return rest_of_tree(root, s_.resume ? tick_resumed(root) : tick(root));
}

Status Stepper::rest_of_tree(RowId root, Status status) {
    while (while_woken_ && status == Status::running && s_.woken) {
        s_.woken = false;
        s_.resume = {};
        status = tick(root);
    }
    if (is_done(status)) { store(root, Status::idle); }
    if (status == Status::running && !s_.resume) { s_.resume = resumable(root); }
    return status;
}

// A tick that only leads back to where the last one stopped can begin there: on the way down,
// running nodes with memory do nothing but tick the child they remember. When what is there ends,
// the tick is done again from the root, with the result known.
Status Stepper::tick_resumed(RowId root) {
    const RowId n = s_.resume;
    count_scopes_around(n, 1);
    const Status status = tick_again(n);
    return status == Status::running || status == Status::idle ? status : end_resumed(root, status);
}

Status Stepper::end_resumed(RowId root, Status status) {
    count_scopes_around(s_.resume, -1U);
    ended_ = s_.resume;
    ended_status_ = status;
    s_.resume = {};
    return tick(root);
}

// The first row on the running path that does more than tick the child it remembers; none if that
// is the root, or does not run itself.
RowId Stepper::resumable(RowId root) const {
    RowId n = root;
    for (;;) {
        const Row& row = rows_[n.index];
        if (status_[n.index] != Status::running) { return {}; }
        if (row.conditional) { break; }
        if (row.op == Op::sequence || row.op == Op::fallback || row.op == Op::async_sequence ||
            row.op == Op::async_fallback || row.op == Op::sequence_with_memory) {
            const std::uint32_t child = memory_[n.index] & ~not_all_skipped;
            n = child != 0 ? RowId{child} : first_child(n);
        } else if (row.op == Op::inverter || row.op == Op::force_success ||
                   row.op == Op::force_failure || row.op == Op::subtree || row.op == Op::tree ||
                   ((row.op == Op::repeat || row.op == Op::retry) && is_constant(row))) {
            n = first_child(n);
        } else {
            break;
        }
    }
    return n == root ? RowId() : n;
}

bool Stepper::is_constant(const Row& loop) const {
    const Instruction& port = p_.code.instructions[p_.ports[loop.arg].index];
    return port.op == CodeOp::copy && port.last && port.a.space() == Space::constant;
}

Status Stepper::tick(RowId n) {
    const Row& row = rows_[n.index];
    if (--budget_ == 0) {
        return fault(Fault::Kind::budget, n, "this tick does not end: too many nodes were ticked");
    }
    if (n == ended_) {
        ended_ = {};
        return ended_status_;
    }
    if (row.conditional) { return tick_conditional(n, row); }
    const Status status = dispatch(n, row);
    keep(n, status);
    return status;
}

// Conditions --------------------------------------------------------------------------------------

Status Stepper::tick_conditional(RowId n, const Row& row) {
    const Conditions& conditions = conditions_of(n);
    Status status = pre_conditions(n, conditions);
    if (s_.fault) { return Status::idle; }
    if (status == Status::idle) { status = dispatch(n, row); }
    if (is_done(status) && !post_conditions(n, conditions, status)) { return Status::idle; }
    keep(n, status);
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
    case Op::async_sequence:
    case Op::async_fallback:
    case Op::if_then_else:
    case Op::switch2:
    case Op::switch3:
    case Op::switch4:
    case Op::switch5:
    case Op::switch6:
    case Op::repeat:
    case Op::retry:
    case Op::delay:
    case Op::timeout:
    case Op::precondition:
    case Op::skip_unless_updated:
    case Op::wait_value_update: memory_[n.index] = 0; [[fallthrough]];
    case Op::sequence_with_memory:
    case Op::reactive_sequence:
    case Op::reactive_fallback:
    case Op::parallel:
    case Op::parallel_all:
    case Op::while_do_else:
    case Op::inverter:
    case Op::force_success:
    case Op::force_failure:
    case Op::keep_running:
    case Op::run_once:
    case Op::loop_int:
    case Op::loop_bool:
    case Op::loop_double:
    case Op::loop_string:
    case Op::tree:
    case Op::subtree:
    case Op::invoke: reset_children(n); break;
    case Op::try_catch: halt_try_catch(n, row); break;
    case Op::action:
    case Op::condition:
        if (status_[n.index] == Status::running) { halt_leaf(n); }
        break;
    case Op::sleep:
    case Op::test:
        if (status_[n.index] == Status::running) {
            trace({.kind = TraceEvent::Kind::halt, .row = n});
        }
        break;
    case Op::run_machine:
        if (status_[n.index] == Status::running) {
            trace({.kind = TraceEvent::Kind::halt, .row = n});
            stop_child(child_of(n));
        }
        break;
    case Op::machine: leave_all(); break;
    case Op::always_success:
    case Op::always_failure:
    case Op::set_blackboard:
    case Op::unset_blackboard:
    case Op::was_entry_updated:
    case Op::script:
    case Op::script_condition:
    case Op::state:
    case Op::parallel_state:
    case Op::history:
    case Op::final: break;
    }
    if (status_[n.index] != Status::idle) { store(n, Status::idle); }
    if (row.conditional) {
        const CodeId script = conditions_of(n).on_halted;
        if (script) { run_script(n, script); }
    }
}

std::uint32_t Stepper::child_count(RowId n) const {
    std::uint32_t count = 0;
    for (RowId child = first_child(n); child != rows_[n.index].end;
         child = rows_[child.index].end) {
        ++count;
    }
    return count;
}

// Halts what runs; then, in a tree, every node once more as haltTree() of BehaviorTree.CPP does:
// its _onHalted scripts run everywhere (TREES §1.4).
void Stepper::halt_root() {
    s_.resume = {};
    s_.quiet = {};
    halt_node({0});
    if (p_.is_machine()) {
        s_.session = fresh_state(p_).session;
        s_.started = false;
        return;
    }
    for (std::uint32_t i = 0; i < p_.rows.size(); ++i) {
        halt_node({i});
    }
}

// Expressions -------------------------------------------------------------------------------------

bool Stepper::run_script(RowId n, CodeId code) {
    if (execute(p_.code, code, context())) { return true; }
    fault(Fault::Kind::expression, n, evaluation_error());
    return false;
}

bool Stepper::condition(RowId n, CodeId code, bool& holds) {
    const Truth truth = evaluate_condition(p_.code, code, context());
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
    return trellis::describe(context_->error, p_.code, names);
}

bool Stepper::integer_port(RowId n, CodeId code, std::int64_t& result) {
    Value value;
    if (!evaluate(p_.code, code, context(), value)) {
        fault(Fault::Kind::expression, n, evaluation_error());
        return false;
    }
    if (to_integer(value, result)) { return true; }
    fault(Fault::Kind::expression, n, print(value) + " is not a whole number");
    return false;
}

bool Stepper::boolean_port(RowId n, CodeId code, bool& result) {
    const Value* value = port_value(code);
    if (value != nullptr && to_boolean(*value, result)) { return true; }
    fault(Fault::Kind::expression, n,
          value == nullptr ? "a port has no value" : print(*value) + " is neither true nor false");
    return false;
}

Status Stepper::status_of(RowId n, const Value* value) {
    for (const Status status :
         {Status::running, Status::success, Status::failure, Status::skipped}) {
        if (value == nullptr) { break; }
        if (value->is(Value::Kind::text) && value->as_text() == name_of(status)) { return status; }
        if (value->is_number() && value->number() == static_cast<double>(status)) { return status; }
    }
    return fault(Fault::Kind::expression, n,
                 value == nullptr ? "a port has no value" : print(*value) + " is no status");
}

// Ports that are no scripts are compiled to one copy.
const Value* Stepper::port_value(CodeId code) const {
    if (!code) { return nullptr; }
    const Operand from = p_.code.instructions[code.index].a;
    if (from.space() == Space::constant) { return &p_.code.constants[from.index()]; }
    const bool exists = s_.entries[from.index()] != EntryType::missing;
    const Value& value = s_.slots[from.index()];
    return exists && !value.is(Value::Kind::undefined) ? &value : nullptr;
}

// A time that is a whole number of ticks must not take one more because a product is rounded up.
std::uint64_t Stepper::tick_after(std::int64_t ms) const {
    constexpr double rounding = 1e-9;
    constexpr double endless = 9e15;
    if (ms <= 0) { return tick_.count; }
    const double ticks = static_cast<double>(ms) / 1000.0 / tick_.dt * (1.0 - rounding);
    return tick_.count + static_cast<std::uint64_t>(std::ceil(std::min(ticks, endless)));
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
