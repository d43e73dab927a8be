// Machines as nodes of trees: a session inside, stepped once in every tick of its node. Covered by
// tests/exec/machine_node_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

namespace trellis {

// Like a leaf, one that has completed and was not reset repeats its result (TREES §1.3).
Status Stepper::tick_run_machine(RowId n, const Row& row) {
    if (is_done(status_[n.index])) { return status_[n.index]; }
    const MachineNode& node = p_.machine_nodes[row.arg];
    if (status_[n.index] != Status::running) {
        if (!may_nest(n)) { return Status::idle; }
        start_machine_node(n, node);
    }
    s_.last_leaf = n;
    const std::size_t child = child_of(n);
    share_entries(node, s_.children[child].state);
    Status status = Status::idle;
    Event last;
    in_child(child, [&](Stepper& machine) {
        status = machine.tick_machine({0});
        const RowId final = machine.s_.session.final;
        if (is_done(status) && machine.carry(machine.p_.state(final).donedata, last)) {
            status = machine.status_from(last.data, status);
        }
    });
    if (s_.fault || !take_entries(n, node, s_.children[child].state)) { return Status::idle; }
    if (is_done(status)) {
        s_.children.erase(s_.children.begin() + static_cast<std::ptrdiff_t>(child));
    }
    trace_leaf(n, status);
    return status;
}

// The first step of the machine is a whole cycle, as if it ran alone.
void Stepper::start_machine_node(RowId n, const MachineNode& node) {
    Value given = Value::object();
    for (std::uint32_t i = 0; i < node.param_count; ++i) {
        const MachineParam& param = p_.machine_params[node.first_param + i];
        if (!param.entry) { given.set_member(param.name, param.value); }
    }
    add_child(n, node.machine, given);
    s_.children[child_of(n)].state.tick = tick_.count;
}

// Entries of the blackboard that have no value leave the machine its own.
void Stepper::share_entries(const MachineNode& node, State& machine) {
    for (std::uint32_t i = 0; i < node.param_count; ++i) {
        const MachineParam& param = p_.machine_params[node.first_param + i];
        if (!param.entry || s_.slots[param.entry.index].is(Value::Kind::undefined)) { continue; }
        machine.slots[param.variable.index] = s_.slots[param.entry.index];
        machine.entries[param.variable.index] = EntryType::any;
    }
}

// False after a fault: a value does not fit the type of its entry.
bool Stepper::take_entries(RowId n, const MachineNode& node, State& machine) {
    for (std::uint32_t i = 0; i < node.param_count; ++i) {
        const MachineParam& param = p_.machine_params[node.first_param + i];
        const Value& value = machine.slots[param.variable.index];
        if (!param.entry || value.is(Value::Kind::undefined) ||
            value == s_.slots[param.entry.index]) {
            continue;
        }
        if (!copy_entry(n, param.entry, value)) { return false; }
        count_write(param.entry);
    }
    return true;
}

// The member `status` of the donedata of its end, where that has one.
Status Stepper::status_from(const Value& data, Status otherwise) {
    const Value* const status = data.is(Value::Kind::object) ? data.member("status") : nullptr;
    if (status == nullptr) { return otherwise; }
    if (status->is(Value::Kind::text)) {
        if (status->as_text() == "success") { return Status::success; }
        if (status->as_text() == "failure") { return Status::failure; }
    }
    return fault(Fault::Kind::output, s_.session.final,
                 "the status of a machine is \"success\" or \"failure\", not " + print(*status));
}

}  // namespace trellis
