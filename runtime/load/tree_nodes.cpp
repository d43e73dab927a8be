// The built-in nodes of tree_compiler.h: their ports, the entries they name, what they remember.
// SPDX-License-Identifier: MIT
#include "core/ports.h"
#include "load/attribute_rule.h"
#include "load/json_literal.h"
#include "load/text.h"
#include "load/tree_compiler.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace trellis {

namespace {

/// What names mean in the scripts of a tree.
class TreeNames final : public Names {
public:
    TreeNames(Builder& builder, Scopes& scopes, VariableTypes& types, ScopeId scope, RowId row,
              Builder::Text text)
        : builder_(builder), scopes_(scopes), types_(types), scope_(scope), row_(row), text_(text) {
    }

    Meaning variable(std::string_view name, Use use) override {
        if (use != Use::create) {
            for (const auto& [known, number] : builder_.registry().enumerators()) {
                if (known == name) {
                    return {.kind = Meaning::Kind::constant,
                            .value = Value::integer(number),
                            .message = {}};
                }
            }
            if (name == "pi" && !scopes_.find(scope_, name)) { return {}; }
        }
        if (use == Use::read && name == Builder::unknown_call(text_) &&
            !scopes_.find(scope_, name)) {
            builder_.report_unknown_call(text_, name);
            return {};
        }
        const SlotId slot = scopes_.variable(scope_, name);
        if (use == Use::create) {
            scopes_.written(slot);
        } else {
            scopes_.needed(slot, builder_.place_of(text_, name), row_);
        }
        return {.kind = Meaning::Kind::slot, .index = slot.index, .value = {}, .message = {}};
    }
    void assigned(std::uint32_t slot, const Value& value, std::uint32_t offset) override {
        types_.given({slot}, value, builder_.place_in(text_, offset));
    }
    Meaning sensor(std::string_view name) override { return builder_.sensor(name); }
    Meaning elapsed() override {
        return {.kind = Meaning::Kind::elapsed_count,
                .index = scopes_.row(scope_).index,
                .value = {},
                .message = {}};
    }
    Meaning state(std::string_view) override {
        return {.kind = Meaning::Kind::error,
                .value = {},
                .message = "In() is for machines: a tree has no states"};
    }

private:
    Builder& builder_;
    Scopes& scopes_;
    VariableTypes& types_;
    ScopeId scope_;
    RowId row_;  // whose script it is
    Builder::Text text_;
};

/// One line of builtin_ports.def.
struct BuiltInPort {
    Op op;
    std::string_view name, type, initial;
};
constexpr BuiltInPort built_in_ports[] = {
#define PORT(op, name, type, required, initial, doc) {Op::op, name, #type, initial},
#include "core/builtin_ports.def"
};

/// The ports of one kind of node: they are neighbours in the table.
std::span<const BuiltInPort> ports_of(Op op) {
    struct Range {
        std::uint8_t first = 0, count = 0;
    };
    constexpr std::size_t ops = static_cast<std::size_t>(Op::invoke) + 1;
    static constexpr std::array<Range, ops> ranges = [] {
        std::array<Range, ops> found = {};
        for (std::uint8_t i = 0; i < std::size(built_in_ports); ++i) {
            Range& range = found[static_cast<std::size_t>(built_in_ports[i].op)];
            if (range.count++ == 0) { range.first = i; }
        }
        return found;
    }();
    const Range range = ranges[static_cast<std::size_t>(op)];
    return {built_in_ports + range.first, range.count};
}

/// The type that a port gives an entry it is bound to. BehaviorTree.CPP has a type of its own for
/// statuses: it is left open here.
PortType port_type(std::string_view type) {
    if (type == "int32") { return PortType::int32; }
    if (type == "count") { return PortType::int64; }
    if (type == "number") { return PortType::real; }
    if (type == "boolean") { return PortType::boolean; }
    return type == "text" ? PortType::text : PortType::any;
}

bool is_queue_loop(Op op) {
    return op == Op::loop_int || op == Op::loop_bool || op == Op::loop_double ||
           op == Op::loop_string;
}

/// What the elements of a loop are.
PortType element_type(Op op) {
    switch (op) {
    case Op::loop_int: return PortType::int32;
    case Op::loop_bool: return PortType::boolean;
    case Op::loop_double: return PortType::real;
    default: return PortType::text;
    }
}

/// An element of a literal queue; undefined if the text does not spell one.
Value queue_element(Op op, std::string_view text) {
    const Value literal = literal_value(text);
    std::int64_t integer = 0;
    bool boolean = false;
    switch (op) {
    case Op::loop_int: return to_integer(literal, integer) ? Value::integer(integer) : Value();
    case Op::loop_bool: return to_boolean(literal, boolean) ? Value::integer(boolean) : Value();
    case Op::loop_double: return literal.is_number() ? Value::real(literal.number()) : Value();
    default: return Value::text(text);
    }
}

/// Nodes that remember more than a word of State::memory.
bool has_word(Op op) {
    return op == Op::try_catch || op == Op::delay || op == Op::timeout || op == Op::sleep ||
           op == Op::skip_unless_updated || op == Op::wait_value_update ||
           op == Op::was_entry_updated;
}

}  // namespace

void TreeCompiler::built_in(const Place& place, const OpInfo& op) {
    const std::uint32_t arg = node_arg(place, op.op);
    const RowId n = builder_.open(op.op, place.parent, instance_name(place),
                                  document(place).at(place.element).where, arg);
    if (!n) { return; }
    conditions(place, n);
    if (op.most_children != 0) { children_of(place, n); }
    builder_.close(n);
    const std::size_t count = document(place).child_count(place.element);
    if (op.op == Op::parallel) {
        check_threshold(place, "success_count", count);
        check_threshold(place, "failure_count", count);
    }
    if (op.op == Op::parallel_all) { check_threshold(place, "max_failures", count); }
    if (op.op == Op::if_then_else || op.op == Op::while_do_else) { keep_skips({n.index + 1}); }
}

// What a row of this kind has in Row::arg.
std::uint32_t TreeCompiler::node_arg(const Place& place, Op op) {
    if (op == Op::run_machine) { return machine(place); }
    const bool has_ports = std::any_of(std::begin(built_in_ports), std::end(built_in_ports),
                                       [&](const BuiltInPort& port) { return port.op == op; });
    if (!has_ports) { return 0; }
    const std::uint32_t first = ports(place, op);
    if (op == Op::repeat || op == Op::retry || op == Op::script || op == Op::script_condition) {
        return first;
    }
    Program& program = builder_.program;
    NodeInfo node{.first_port = first};
    node.entry = named_entry(place, op);
    if (has_word(op)) { node.word = {program.words++}; }
    if (is_queue_loop(op)) { node.queue = {program.queues++}; }
    program.nodes.push_back(node);
    return static_cast<std::uint32_t>(program.nodes.size() - 1);
}

// The first child of IfThenElse and WhileDoElse is ticked again after it has failed without being
// reset: what it counts goes on, as in BehaviorTree.CPP.
void TreeCompiler::keep_skips(RowId question) {
    Program& program = builder_.program;
    if (question.index >= program.rows.size()) { return; }
    Row& row = program.rows[question.index];
    if (row.op == Op::sequence || row.op == Op::fallback || row.op == Op::async_sequence ||
        row.op == Op::async_fallback || row.op == Op::sequence_with_memory) {
        row.arg = ++program.words;
    }
}

// Ports -------------------------------------------------------------------------------------------

// The code of all ports of a built-in node, in the order of builtin_ports.def; returns the first.
std::uint32_t TreeCompiler::ports(const Place& place, Op op) {
    std::vector<CodeId> codes;
    for (const BuiltInPort& port : ports_of(op)) {
        const Attribute* attribute = document(place).find(place.element, port.name);
        if (attribute != nullptr && port.type != "key") {
            // BehaviorTree.CPP lets a Script be empty, and succeeds
            const bool empty = op == Op::script && attribute->value.size == 0;
            codes.push_back(empty ? CodeId()
                                  : port_code(place, op, port.name, port.type, *attribute));
        } else if (!port.initial.empty()) {
            codes.push_back(builder_.constant(literal_value(port.initial), Dialect::tree));
        } else {
            codes.emplace_back();
        }
    }
    std::vector<CodeId>& table = builder_.program.ports;
    table.insert(table.end(), codes.begin(), codes.end());
    return static_cast<std::uint32_t>(table.size() - codes.size());
}

CodeId TreeCompiler::port_code(const Place& place, Op op, std::string_view name,
                               std::string_view type, const Attribute& attribute) {
    if (type == "script") { return compiled(place, text_of(place, attribute), next_row()); }
    const std::string_view value = document(place).string(attribute.value);
    if (is_pointer(value)) {
        const SlotId slot = scopes_.variable(place.scope, pointer_key(value, name));
        declare(slot, port_type(type), attribute.value_where);
        // a text that is missing decides something; a number that is missing ends the run
        const bool needed = type != "text" && type != "any";
        if (needed) { scopes_.needed(slot, attribute.value_where, next_row()); }
        return builder_.variable(slot, Dialect::tree);
    }
    if (name == "queue") { return queue(attribute, value, op); }
    if (op == Op::set_blackboard && name == "value" && is_json_literal(value)) {
        return builder_.constant(json_literal(builder_, text_of(place, attribute)), Dialect::tree);
    }
    if (type == "text" || type == "any") {
        return builder_.constant(Value::text(value), Dialect::tree);
    }
    return builder_.constant(builder_.enumerated(value), Dialect::tree);
}

CodeId TreeCompiler::compiled(const Place& place, const Builder::Text& script, RowId n) {
    TreeNames names(builder_, scopes_, types_, place.scope, n, script);
    return builder_.expression(script, Dialect::tree, SyntaxMode::script, names);
}

void TreeCompiler::declare(SlotId slot, PortType type, Where where) {
    Slot& entry = builder_.program.slots[slot.index];
    if (entry.type == EntryType::missing) { entry.type = entry_type(type); }
    types_.bound(slot, type, where);
}

// "1;2;3" as an array of what the loop takes.
CodeId TreeCompiler::queue(const Attribute& attribute, std::string_view text, Op op) {
    Value elements = Value::array();
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view part = text.substr(0, end);
        Value element = queue_element(op, part);
        if (element.is(Value::Kind::undefined)) {
            builder_.diagnostics().error("bad-value", attribute.value_where,
                                         "\"queue\": expected " +
                                             std::string(name_of(element_type(op))) +
                                             " values with ; between them, found " + quoted(part));
            return {};
        }
        elements.append(std::move(element));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return builder_.constant(std::move(elements), Dialect::tree);
}

void TreeCompiler::check_threshold(const Place& place, std::string_view port,
                                   std::size_t children) {
    const Attribute* attribute = document(place).find(place.element, port);
    if (attribute == nullptr) { return; }
    const Value asked = builder_.enumerated(document(place).string(attribute->value));
    if (!asked.is(Value::Kind::integer)) { return; }
    if (asked.as_integer() <= static_cast<std::int64_t>(children)) { return; }
    builder_.diagnostics().error("out-of-range", attribute->value_where,
                                 "\"" + std::string(port) + "\": " + print(asked) + " of " +
                                     std::to_string(children) + " children can never happen");
}

// Entries that are named, not read ----------------------------------------------------------------

// The variable that a node watches, writes or removes; none if it has no such port, or if the name
// is itself in a variable.
SlotId TreeCompiler::named_entry(const Place& place, Op op) {
    const bool watches =
        op == Op::skip_unless_updated || op == Op::wait_value_update || op == Op::was_entry_updated;
    const std::string_view port = watches                      ? "entry"
                                  : op == Op::set_blackboard   ? "output_key"
                                  : op == Op::unset_blackboard ? "key"
                                  : is_queue_loop(op)          ? "value"
                                                               : "";
    const Attribute* attribute = document(place).find(place.element, port);
    if (port.empty() || attribute == nullptr) { return {}; }
    std::string_view key = document(place).string(attribute->value);
    const bool pointer = is_pointer(key);
    if (pointer) { key = pointer_key(key, port); }
    if (op == Op::set_blackboard && pointer) { scopes_.all_written(place.scope); }
    if (op == Op::unset_blackboard && pointer) { scopes_.all_used(place.scope); }
    if ((op == Op::set_blackboard || op == Op::unset_blackboard) && pointer) { return {}; }
    // what is removed is an entry of this very blackboard
    if (op == Op::unset_blackboard) { return scopes_.own(place.scope, key); }

    const SlotId slot = scopes_.variable(place.scope, key);
    builder_.program.counts_writes = builder_.program.counts_writes || watches;
    if (is_queue_loop(op)) { declare(slot, element_type(op), attribute->value_where); }
    if (!watches) { scopes_.written(slot); }
    const Attribute* value = document(place).find(place.element, "value");
    if (op == Op::set_blackboard && value != nullptr) {
        const std::string_view text = document(place).string(value->value);
        const bool is_text = !is_pointer(text) && !is_json_literal(text);
        if (is_text) { types_.given(slot, Value::text(text), value->value_where); }
    }
    return slot;
}

}  // namespace trellis
