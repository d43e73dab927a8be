// Names, places, assignments and calls: syntax → code, see emitter.h. Covered by
// tests/load/expression_test.cpp and tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/emitter.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace trellis {
namespace {

CodeOp arithmetic_of(CodeOp assignment) {
    switch (assignment) {
    case CodeOp::assign_add: return CodeOp::add;
    case CodeOp::assign_subtract: return CodeOp::subtract;
    case CodeOp::assign_multiply: return CodeOp::multiply;
    default: return CodeOp::divide;
    }
}

bool is_compound(CodeOp assignment) {
    return assignment != CodeOp::declare && assignment != CodeOp::assign;
}

}  // namespace

Meaning Emitter::variable(std::uint32_t n, Use use) {
    const std::string& name = syntax_.names[node(n).index];
    Meaning meaning = names_.variable(name, use);
    if (meaning.kind == Meaning::Kind::undeclared && use == Use::read && name == "pi") {
        return {.kind = Meaning::Kind::constant, .value = Value::real(std::numbers::pi)};
    }
    return meaning;
}

void Emitter::read(std::uint32_t n, const Meaning& meaning, std::string_view name, std::uint32_t t,
                   bool last) {
    const auto at_index = [&](CodeOp op) { add(n, op, t, last, {.extra = meaning.index}); };
    switch (meaning.kind) {
    case Meaning::Kind::slot:
    case Meaning::Kind::read_only_slot:
        add(n, CodeOp::copy, t, last, {.a = Operand(Space::slot, meaning.index)});
        break;
    case Meaning::Kind::constant:
        add(n, CodeOp::copy, t, last, {.a = constant(meaning.value)});
        break;
    case Meaning::Kind::sensor_boolean: at_index(CodeOp::sensor_boolean); break;
    case Meaning::Kind::sensor_integer: at_index(CodeOp::sensor_integer); break;
    case Meaning::Kind::sensor_real: at_index(CodeOp::sensor_real); break;
    case Meaning::Kind::elapsed_count: at_index(CodeOp::elapsed_count); break;
    case Meaning::Kind::elapsed_since: at_index(CodeOp::elapsed_since); break;
    case Meaning::Kind::state: at_index(CodeOp::in_state); break;
    case Meaning::Kind::undeclared: fail(n, EvalErrorKind::undeclared, name); break;
    case Meaning::Kind::error: report(n, meaning.message); break;
    }
}

void Emitter::path(std::uint32_t n, std::uint32_t t, bool last) {
    std::span<const std::uint32_t> parts = syntax_.children_of(node(n));
    Operand base;
    std::optional<Meaning> sensor = sensor_of(n);
    if (sensor && parts.size() == 2) {
        return read(n, *sensor, syntax_.literals[node(parts[1]).index].as_text(), t, last);
    }
    if (sensor) {
        // below a sensor there is nothing, but that is for the evaluation to say
        const std::uint32_t below = temporary();
        read(n, *sensor, syntax_.literals[node(parts[1]).index].as_text(), below, false);
        base = Operand(Space::temporary, below);
        parts = parts.subspan(1);
    } else {
        const bool keys_assign = std::any_of(parts.begin() + 1, parts.end(),
                                             [&](std::uint32_t key) { return node(key).assigns; });
        base = stable_value(parts[0], keys_assign);
    }
    const auto count = static_cast<std::uint32_t>(parts.size() - 1);
    add(n, CodeOp::read_at, t, last, {.a = base, .b = run(parts.subspan(1)), .extra = count});
}

std::optional<Meaning> Emitter::sensor_of(std::uint32_t n) {
    const SyntaxNode& base = node(child(n, 0));
    const SyntaxNode& key = node(child(n, 1));
    if (base.kind != SyntaxKind::name || syntax_.names[base.index] != "_x") return std::nullopt;
    if (key.kind != SyntaxKind::literal || !syntax_.literals[key.index].is(Value::Kind::text))
        return std::nullopt;
    Meaning meaning = names_.sensor(syntax_.literals[key.index].as_text());
    if (meaning.kind == Meaning::Kind::undeclared) return std::nullopt;
    return meaning;
}

void Emitter::assignment(std::uint32_t n, std::uint32_t t, bool last) {
    if (tree()) return tree_assignment(n, t, last);
    // as SCXML users expect, the value is known before the place is looked at
    const std::uint32_t place = child(n, 0);
    const CodeOp op = node(n).op;
    if (!is_compound(op) && node(place).kind == SyntaxKind::name) {
        write(place, value(child(n, 1)), t, last);
        return;
    }
    into(child(n, 1), t, false);
    const Operand right(Space::temporary, t);
    if (is_compound(op)) {
        const CodeOp arithmetic = arithmetic_of(op);
        add(n, arithmetic, t, false, {.a = value(place), .b = right});
    }
    write(place, right, t, last);
}

void Emitter::write(std::uint32_t place, Operand value, std::uint32_t t, bool last) {
    const bool below = node(place).kind == SyntaxKind::path;
    const std::uint32_t base = below ? child(place, 0) : place;
    const std::string& name = syntax_.names[node(base).index];
    const Meaning meaning = variable(base, Use::write);
    switch (meaning.kind) {
    case Meaning::Kind::slot: break;
    case Meaning::Kind::undeclared: return fail(place, EvalErrorKind::undeclared, name);
    case Meaning::Kind::error: return report(place, meaning.message);
    default: return fail(place, EvalErrorKind::read_only, name);
    }
    const Operand slot(Space::slot, meaning.index);
    if (!below) {
        add(place, CodeOp::store, t, last, {.a = slot, .b = value});
        return;
    }
    const auto keys = syntax_.children_of(node(place)).subspan(1);
    const auto count = static_cast<std::uint32_t>(keys.size());
    add(place, CodeOp::store_at, t, last, {.a = slot, .b = run(keys), .extra = count});
}

void Emitter::tree_assignment(std::uint32_t n, std::uint32_t t, bool last) {
    const std::uint32_t place = child(n, 0);
    const std::uint32_t right = child(n, 1);
    const bool creates = node(n).op == CodeOp::declare;
    if (node(place).kind != SyntaxKind::name) return fail(n, EvalErrorKind::not_assignable, "");

    const Meaning meaning = variable(place, creates ? Use::create : Use::write);
    const std::string& name = syntax_.names[node(place).index];
    switch (meaning.kind) {
    case Meaning::Kind::slot: break;
    case Meaning::Kind::undeclared: return fail(place, EvalErrorKind::missing, name);
    case Meaning::Kind::error: return report(place, meaning.message);
    default: return fail(place, EvalErrorKind::read_only, name);
    }
    const Operand slot(Space::slot, meaning.index);
    if (creates) {
        add(place, CodeOp::declare, t, false, {.a = slot});
    } else if (node(right).assigns) {
        // otherwise asking after the right-hand side makes no difference
        add(place, CodeOp::require, t, false, {.a = slot});
    }
    const CodeOp op = creates ? CodeOp::assign : node(n).op;
    const Operand given = value(right);
    tell_assigned(place, meaning.index, op, right, given);
    add(n, op, t, last, {.a = slot, .b = given});
}

void Emitter::tell_assigned(std::uint32_t place, std::uint32_t slot, CodeOp op, std::uint32_t right,
                            Operand given) {
    const SyntaxNode& it = node(right);
    const bool computes =
        it.kind == SyntaxKind::unary || it.kind == SyntaxKind::comparisons ||
        (it.kind == SyntaxKind::binary && it.op != CodeOp::add && it.op != CodeOp::concatenate);
    if (op != CodeOp::assign) {
        // += also joins texts
        if (op != CodeOp::assign_add) { names_.assigned(slot, Value::real(0), node(place).offset); }
    } else if (const Value* known = constant_at(given); known != nullptr) {
        names_.assigned(slot, *known, node(place).offset);
    } else if (computes) {
        names_.assigned(slot, Value::real(0), node(place).offset);
    }
}

void Emitter::call(std::uint32_t n, std::uint32_t t, bool last) {
    const SyntaxNode& it = node(n);
    const std::string& name = syntax_.names[it.index];
    if (name == "elapsed") {
        if (takes(n, name, 0, 0)) read(n, names_.elapsed(), name, t, last);
    } else if (name == "In") {
        if (takes(n, name, 1, 1)) in_state(n, t, last);
    } else if (name == "abs") {
        if (takes(n, name, 1, 1)) add(n, CodeOp::absolute, t, last, {.a = value(child(n, 0))});
    } else if (name == "isDefined") {
        if (takes(n, name, 1, 1)) is_defined(n, t, last);
    } else {
        for (std::uint32_t f = 0; f < functions().size(); ++f) {
            const FunctionInfo& info = functions()[f];
            if (info.name != name) continue;
            if (!takes(n, name, info.fewest, info.most)) return;
            // the second operand's index is the function
            add(n, CodeOp::call, t, last,
                {.a = run(syntax_.children_of(it)),
                 .b = Operand(Space::constant, f),
                 .extra = it.count});
            return;
        }
        report(n, "unknown function \"" + name + '"');
    }
}

bool Emitter::takes(std::uint32_t n, std::string_view name, std::uint8_t fewest,
                    std::uint8_t most) {
    const std::uint32_t count = node(n).count;
    if (count >= fewest && (most == FunctionInfo::any_number || count <= most)) return true;
    std::string message = std::string(name) + " takes ";
    if (most == FunctionInfo::any_number) message += "at least ";
    message += std::to_string(fewest);
    message += fewest == 1 ? " argument, found " : " arguments, found ";
    report(n, message + std::to_string(count));
    return false;
}

void Emitter::in_state(std::uint32_t n, std::uint32_t t, bool last) {
    const std::uint32_t argument = child(n, 0);
    const SyntaxNode& it = node(argument);
    std::optional<std::string_view> name;
    if (it.kind == SyntaxKind::literal && syntax_.literals[it.index].is(Value::Kind::text)) {
        name = syntax_.literals[it.index].as_text();
    } else if (it.kind == SyntaxKind::name) {
        if (variable(argument, Use::read).kind == Meaning::Kind::undeclared)
            name = syntax_.names[it.index];
    }
    if (!name) {
        add(n, CodeOp::in_named, t, last, {.a = value(argument)});
        return;
    }
    const Meaning meaning = names_.state(*name);
    if (meaning.kind == Meaning::Kind::undeclared) {
        fail(n, EvalErrorKind::no_such_state, *name);
    } else {
        read(n, meaning, *name, t, last);
    }
}

void Emitter::is_defined(std::uint32_t n, std::uint32_t t, bool last) {
    const std::uint32_t begin = position();
    add(n, CodeOp::defined, t, last, {.a = value(child(n, 0))});
    const std::uint32_t end = position();
    const std::uint32_t to_end = last ? 0 : add(n, CodeOp::jump, t, false, {});
    landed_at_ = position();
    code_.guards.push_back({.begin = begin, .end = end, .handler = position()});
    add(n, CodeOp::copy, t, last, {.a = constant(tree() ? Value::real(0) : Value::boolean(false))});
    if (!last) land(to_end);
}

}  // namespace trellis
