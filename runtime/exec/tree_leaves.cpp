// The leaves that need no robot (TREES §1.3), one function each; scripts are in tree_rules.cpp.
// Covered by tests/exec/tree_nodes_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/ports.h"
#include "exec/evaluate_rules.h"
#include "exec/stepper.h"

#include <string>

namespace trellis {

/// Notes that the leaf was ticked, and returns its status.
Status Stepper::ticked(RowId n, Status status) {
    s_.last_leaf = n;
    trace_leaf(n, status);
    return status;
}

// Blackboard --------------------------------------------------------------------------------------

// A literal is a text: a new entry holds texts, one of another type gets what the text spells. An
// entry is copied with its type; one without a value is a failure.
Status Stepper::tick_set_blackboard(RowId n, const Row& row) {
    const NodeInfo& node = p_.nodes[row.arg];
    const CodeId from = port(node, 0);
    const SlotId to = named_entry(n, node, port(node, 1));
    if (!to) { return Status::idle; }
    EntryType& type = s_.entries[to.index];
    const Value* value = port_value(from);
    if (type == EntryType::missing) {
        const Operand source = p_.code.instructions[from.index].a;
        type = !is_literal(from)              ? s_.entries[source.index()]
               : value->is(Value::Kind::text) ? EntryType::text
                                              : EntryType::any;
    }
    if (value == nullptr) { return ticked(n, Status::failure); }
    if (!copy_entry(n, to, *value)) { return Status::idle; }
    count_write(to);
    return ticked(n, Status::success);
}

// Writes `value` to a variable; false after a fault.
bool Stepper::copy_entry(RowId n, SlotId to, const Value& value) {
    Value& variable = s_.slots[to.index];
    const EntryType type = s_.entries[to.index];
    // what the text spells; an entry without a type takes the text itself
    if (value.is(Value::Kind::text) && convert_text(type, value.as_text(), variable)) {
        return true;
    }
    std::string why;
    if (write_entry(PortType::any, value, variable, s_.entries[to.index], why)) { return true; }
    fault(Fault::Kind::output, n, "\"" + p_.slots[to.index].name + "\": " + why);
    return false;
}

// The entry is gone: it has neither value nor type, and counts its writes anew.
Status Stepper::tick_unset_blackboard(RowId n, const Row& row) {
    const NodeInfo& node = p_.nodes[row.arg];
    const bool named = is_literal(port(node, 0));
    const SlotId slot = named ? node.entry : named_entry(n, node, port(node, 0));
    if (slot) {
        s_.slots[slot.index].set_undefined();
        s_.entries[slot.index] = EntryType::missing;
        if (!s_.writes.empty()) { s_.writes[slot.index] = 0; }
    }
    return s_.fault ? Status::idle : ticked(n, Status::success);
}

// The variable that a key names: one that was resolved when loading, or, if the key is itself in a
// variable, one of the same blackboard. None after a fault.
SlotId Stepper::named_entry(RowId n, const NodeInfo& node, CodeId port) {
    if (node.entry) { return node.entry; }
    const Value* key = port_value(port);
    const bool is_name = key != nullptr && key->is(Value::Kind::text);
    for (std::uint32_t i = 0; is_name && i < p_.slots.size(); ++i) {
        const bool here = p_.slots[i].scope == rows_[n.index].scope;
        if (here && p_.slots[i].name == key->as_text()) { return {i}; }
    }
    fault(Fault::Kind::expression, n,
          key == nullptr ? "the key has no value"
                         : "nothing in this tree is called " + print(*key));
    return {};
}

// Time --------------------------------------------------------------------------------------------

// Like any leaf that takes time, one that has ended and was not reset repeats its result.
Status Stepper::tick_sleep(RowId n, const Row& row) {
    const Status stored = status_[n.index];
    if (is_done(stored)) { return stored; }
    const NodeInfo& node = p_.nodes[row.arg];
    std::uint64_t& deadline = s_.words[node.word.index];
    if (stored == Status::idle) {
        std::int64_t ms = 0;
        if (!integer_port(n, port(node, 0), ms)) { return Status::idle; }
        deadline = tick_after(ms);
    }
    return ticked(n, tick_.count < deadline ? Status::running : Status::success);
}

Status Stepper::tick_test(RowId n, const Row& row) {
    const Status stored = status_[n.index];
    if (is_done(stored)) { return stored; }
    const TestInfo& test = p_.tests[row.arg];
    std::uint64_t& deadline = s_.words[test.word.index];
    if (stored == Status::idle) { deadline = tick_after(test.delay); }
    if (tick_.count < deadline) { return ticked(n, Status::running); }
    return finish_test(n, test);
}

Status Stepper::finish_test(RowId n, const TestInfo& test) {
    Status status = test.status;
    if (test.status_script) {
        Value& name = s_.temporaries.front();
        if (!evaluate(p_.code, test.status_script, context(), name)) {
            return fault(Fault::Kind::expression, n, evaluation_error());
        }
        status = status_of(n, &name);
        if (status == Status::idle) { return status; }
    }
    const CodeId script = status == Status::success   ? test.on_success
                          : status == Status::failure ? test.on_failure
                                                      : CodeId();
    if (script && !run_script(n, script)) { return Status::idle; }
    if (test.post && !run_script(n, test.post)) { return Status::idle; }
    return ticked(n, status);
}

}  // namespace trellis
