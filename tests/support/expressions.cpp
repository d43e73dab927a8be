// The names that every test of expressions sees: see expressions.h.
// SPDX-License-Identifier: MIT
#include "support/expressions.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace trellis {

Meaning ExpressionWorld::slot(std::string_view name, bool create) {
    const auto at = std::find(slot_names.begin(), slot_names.end(), name);
    if (at == slot_names.end()) {
        if (!create) return {};
        slot_names.emplace_back(name);
        slots.emplace_back();
        entry_types.push_back(static_cast<std::uint8_t>(EntryType::missing));
        writes.push_back(0);
        return {.kind = Meaning::Kind::slot, .index = static_cast<std::uint32_t>(slots.size() - 1)};
    }
    return {.kind = Meaning::Kind::slot,
            .index = static_cast<std::uint32_t>(at - slot_names.begin())};
}

Meaning ExpressionWorld::variable(std::string_view name, Use use) {
    if (name.starts_with('@')) name.remove_prefix(1);
    if (use == Use::read) {
        for (const EnumValue& e : code.enums) {
            if (e.name == name)
                return {.kind = Meaning::Kind::constant, .value = Value::real(e.value)};
        }
    }
    if (name == "locked")
        return {.kind = Meaning::Kind::error, .message = "locked is not for expressions"};
    Meaning meaning = slot(name, dialect_ == Dialect::tree && name != "pi");
    if (name == "_event" && meaning.kind == Meaning::Kind::slot)
        meaning.kind = Meaning::Kind::read_only_slot;
    return meaning;
}

Meaning ExpressionWorld::sensor(std::string_view name) {
    if (name == "bumper")
        return {.kind = Meaning::Kind::sensor_boolean, .index = offsetof(Host, bumper)};
    if (name == "count")
        return {.kind = Meaning::Kind::sensor_integer, .index = offsetof(Host, count)};
    if (name == "range")
        return {.kind = Meaning::Kind::sensor_real, .index = offsetof(Host, range)};
    return {};
}

Meaning ExpressionWorld::elapsed() {
    return {.kind = counts_cycles ? Meaning::Kind::elapsed_count : Meaning::Kind::elapsed_since,
            .index = 0};
}

Meaning ExpressionWorld::state(std::string_view name) {
    if (name == "idle") return {.kind = Meaning::Kind::state, .index = 0};
    if (name == "active") return {.kind = Meaning::Kind::state, .index = 1};
    return {};
}

void ExpressionWorld::declare(std::string_view name, Value value, EntryType type) {
    const std::uint32_t index = slot(name, true).index;
    slots[index] = std::move(value);
    entry_types[index] = static_cast<std::uint8_t>(type);
}

const Value& ExpressionWorld::value_of(std::string_view name) {
    return slots[slot(name, true).index];
}

void ExpressionWorld::add_enum(std::string_view name, double value) {
    code.enums.push_back({.name = std::string(name), .value = value});
    std::sort(code.enums.begin(), code.enums.end(),
              [](const EnumValue& a, const EnumValue& b) { return a.name < b.name; });
}

CodeId ExpressionWorld::compile(std::string_view text, SyntaxMode mode) {
    ParseError parse_error;
    const std::optional<Syntax> syntax = parse_expression(text, dialect_, mode, parse_error);
    if (!syntax) {
        message = std::to_string(parse_error.offset) + ": " + parse_error.message;
        return {};
    }
    std::vector<EmitError> errors;
    const CodeId id = mode == SyntaxMode::location ? emit_store(*syntax, *this, code, errors)
                                                   : emit(*syntax, *this, code, errors);
    message.clear();
    for (const EmitError& e : errors) {
        message += (message.empty() ? "" : "; ") + std::to_string(e.offset) + ": " + e.message;
    }
    return id;
}

EvalContext ExpressionWorld::context() {
    scratch_.resize(std::max<std::size_t>(scratch_.size(), code.temporaries));
    EvalContext context;
    context.use(code, slots.data(), scratch_.data());
    context.entry_types = entry_types.data();
    context.writes = writes.data();
    context.row_memory = row_memory.data();
    context.cycle = cycle;
    context.dt = dt;
    context.host = reinterpret_cast<const std::byte*>(&host);
    context.random = &random;
    context.in_state = [](const void*, RowId row) { return row.index == 1; };
    context.state_named = [](const void*, std::string_view name) {
        return name == "idle" ? RowId{0} : name == "active" ? RowId{1} : RowId();
    };
    return context;
}

std::string ExpressionWorld::run(std::string_view text, SyntaxMode mode) {
    const CodeId id = compile(text, mode);
    if (!id) return "parse error " + message;
    EvalContext here = context();
    Value result;
    if (!evaluate(code, id, here, result)) return "error " + describe(here.error, code, slot_names);
    return print(result);
}

ExpressionWorld sample_machine() {
    ExpressionWorld world(Dialect::machine);
    world.declare("x", Value::real(2));
    world.declare("n", Value::integer(3));
    world.declare("s", Value::text("abc"));
    world.declare("u", Value());
    world.declare("a", Value::array());
    world.declare("o", Value::object());
    world.declare("_event", Value::object());
    world.run("a = [1, 'two', [3]]; o = {k: 1, 'two words': {deep: 5}}");
    return world;
}

}  // namespace trellis
