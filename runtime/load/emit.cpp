// Values and operators: syntax → code, see emitter.h. Where each value comes to lie, constant
// folding, order of evaluation. Covered by tests/load/expression_test.cpp and
// tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/emit.h"

#include "load/emitter.h"

#include <algorithm>

namespace trellis {
namespace {

// what BehaviorTree.CPP computes in doubles anyway: a whole number that a double holds exactly
bool is_exact(const Value& v) {
    constexpr std::int64_t limit = std::int64_t{1} << 53;
    return v.is(Value::Kind::real) ||
           (v.is(Value::Kind::integer) && v.as_integer() >= -limit && v.as_integer() <= limit);
}

std::optional<double> folded(CodeOp op, double a, double b) {
    switch (op) {
    case CodeOp::add: return a + b;
    case CodeOp::subtract: return a - b;
    case CodeOp::multiply: return a * b;
    case CodeOp::divide: return a / b;
    case CodeOp::negate: return -a;
    default: return std::nullopt;
    }
}

// the operators that take their operands as doubles, whatever numbers they are
bool takes_doubles(CodeOp op) {
    return op <= CodeOp::negate || (op >= CodeOp::less && op <= CodeOp::not_equal);
}

}  // namespace

CodeId Emitter::whole() {
    const CodeId id{position()};
    const std::uint32_t result = temporary();
    if (node(syntax_.root).kind == SyntaxKind::sequence) {
        sequence(syntax_.root, result);
    } else {
        into(syntax_.root, result, true);
    }
    return finished(id);
}

CodeId Emitter::store() {
    const CodeId id{position()};
    const std::uint32_t value = temporary();
    write(syntax_.root, Operand(Space::temporary, value), value, true);
    return finished(id);
}

Operand Emitter::value(std::uint32_t n) {
    const SyntaxNode& it = node(n);
    if (it.kind == SyntaxKind::literal) return constant(syntax_.literals[it.index]);
    if (it.kind == SyntaxKind::name) {
        Meaning meaning = variable(n, Use::read);
        if (meaning.kind == Meaning::Kind::slot || meaning.kind == Meaning::Kind::read_only_slot) {
            return Operand(Space::slot, meaning.index);
        }
        if (meaning.kind == Meaning::Kind::constant) return constant(std::move(meaning.value));
        const std::uint32_t t = temporary();
        read(n, meaning, syntax_.names[it.index], t, false);
        return Operand(Space::temporary, t);
    }
    if (std::optional<double> number = fold(n)) return constant(Value::real(*number));
    const std::uint32_t t = temporary();
    into(n, t, false);
    return Operand(Space::temporary, t);
}

Operand Emitter::stable_value(std::uint32_t n, bool assigned_later) {
    const Operand operand = value(n);
    if (!assigned_later || operand.space() != Space::slot) return operand;
    const std::uint32_t t = temporary();
    add(n, CodeOp::copy, t, false, {.a = operand});
    return Operand(Space::temporary, t);
}

std::optional<double> Emitter::fold(std::uint32_t n) const {
    const SyntaxNode& it = node(n);
    if (it.kind == SyntaxKind::literal) {
        const Value& v = syntax_.literals[it.index];
        return is_exact(v) ? std::optional(v.number()) : std::nullopt;
    }
    if (it.kind != SyntaxKind::unary && it.kind != SyntaxKind::binary) return std::nullopt;
    if (!folded(it.op, 1, 1)) return std::nullopt;
    const std::optional<double> a = fold(child(n, 0));
    const std::optional<double> b = it.count > 1 ? fold(child(n, 1)) : 0.0;
    return a && b ? folded(it.op, *a, *b) : std::nullopt;
}

Operand Emitter::as_double(CodeOp op, Operand operand) {
    const Value* v = constant_at(operand);
    if (v == nullptr || !v->is(Value::Kind::integer) || !is_exact(*v) || !takes_doubles(op))
        return operand;
    return constant(Value::real(v->number()));
}

void Emitter::into(std::uint32_t n, std::uint32_t t, bool last) {
    const std::uint32_t mark = next_temporary_;
    const SyntaxNode& it = node(n);
    switch (it.kind) {
    case SyntaxKind::literal: add(n, CodeOp::copy, t, last, {.a = value(n)}); break;
    case SyntaxKind::name: read(n, variable(n, Use::read), syntax_.names[it.index], t, last); break;
    case SyntaxKind::path: path(n, t, last); break;
    case SyntaxKind::unary:
    case SyntaxKind::binary: operation(n, t, last); break;
    case SyntaxKind::comparisons: comparisons(n, t, last); break;
    case SyntaxKind::conditional: conditional(n, t, last); break;
    case SyntaxKind::assignment: assignment(n, t, last); break;
    case SyntaxKind::call: call(n, t, last); break;
    case SyntaxKind::array:
    case SyntaxKind::object: {
        const CodeOp op = it.kind == SyntaxKind::array ? CodeOp::make_array : CodeOp::make_object;
        add(n, op, t, last, {.a = run(syntax_.children_of(it)), .extra = it.count});
        break;
    }
    case SyntaxKind::sequence: break;  // only at the root: whole()
    }
    next_temporary_ = mark;
}

void Emitter::sequence(std::uint32_t n, std::uint32_t result) {
    const SyntaxNode& it = node(n);
    if (it.count == 0) add(n, CodeOp::copy, result, true, {.a = constant(Value())});
    for (std::uint32_t i = 0; i < it.count; ++i) {
        const bool last = i + 1 == it.count;
        into(child(n, i), result, last);
        if (last || code_.instructions.empty()) continue;
        // nobody reads what this assignment comes to
        Instruction& in = code_.instructions.back();
        if (in.op >= CodeOp::assign && in.op <= CodeOp::store)
            in.target = accumulator_operand.index();
    }
}

Operand Emitter::run(std::span<const std::uint32_t> nodes) {
    if (nodes.empty()) return {};
    if (nodes.size() == 1) return value(nodes[0]);
    const bool literals = std::all_of(nodes.begin(), nodes.end(), [&](std::uint32_t n) {
        return node(n).kind == SyntaxKind::literal;
    });
    if (literals) {
        const Operand first(Space::constant, static_cast<std::uint32_t>(code_.constants.size()));
        for (std::uint32_t n : nodes)
            code_.constants.push_back(syntax_.literals[node(n).index]);
        return first;
    }
    const std::uint32_t first = next_temporary_;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        temporary();
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const std::uint32_t mark = next_temporary_;
        into_whole(nodes[i], first + i);
        next_temporary_ = mark;
    }
    return Operand(Space::temporary, first);
}

void Emitter::into_whole(std::uint32_t n, std::uint32_t t) {
    if (std::optional<double> number = fold(n); number && node(n).kind != SyntaxKind::literal) {
        add(n, CodeOp::copy, t, false, {.a = constant(Value::real(*number))});
    } else {
        into(n, t, false);
    }
}

void Emitter::operation(std::uint32_t n, std::uint32_t t, bool last) {
    const SyntaxNode& it = node(n);
    if (std::optional<double> number = fold(n)) {
        add(n, CodeOp::copy, t, last, {.a = constant(Value::real(*number))});
        return;
    }
    if (it.kind == SyntaxKind::unary) {
        add(n, it.op, t, last, {.a = as_double(it.op, value(child(n, 0)))});
        return;
    }
    if (!tree() && (it.op == CodeOp::logical_and || it.op == CodeOp::logical_or)) {
        // the result is the left operand's truth unless that leaves the question open
        boolean_into(child(n, 0), t, false);
        const CodeOp jump = it.op == CodeOp::logical_and ? CodeOp::jump_unless : CodeOp::jump_if;
        const std::uint32_t decided = add(n, jump, t, last, {.a = Operand(Space::temporary, t)});
        boolean_into(child(n, 1), t, last);
        if (!last) land(decided);
        return;
    }
    const Operand left = stable_value(child(n, 0), node(child(n, 1)).assigns);
    const Operand right = value(child(n, 1));
    add(n, it.op, t, last, {.a = as_double(it.op, left), .b = as_double(it.op, right)});
}

void Emitter::boolean_into(std::uint32_t n, std::uint32_t t, bool last) {
    const SyntaxNode& it = node(n);
    const bool is_boolean =
        (it.kind == SyntaxKind::unary && it.op == CodeOp::logical_not) ||
        (it.kind == SyntaxKind::binary && it.op >= CodeOp::less && it.op <= CodeOp::logical_or);
    if (is_boolean) return into(n, t, last);
    add(n, CodeOp::truth, t, last, {.a = value(n)});
}

void Emitter::comparisons(std::uint32_t n, std::uint32_t t, bool last) {
    const SyntaxNode& it = node(n);
    const auto operand = [&](std::uint32_t i) {
        const auto later = syntax_.children_of(it).subspan(i + 1);
        const bool assigned = std::any_of(later.begin(), later.end(),
                                          [&](std::uint32_t c) { return node(c).assigns; });
        return stable_value(child(n, i), assigned);
    };
    std::vector<std::uint32_t> decided;
    Operand left = operand(0);
    for (std::uint32_t i = 0; i + 1 < it.count; ++i) {
        const bool final = i + 2 == it.count;
        const CodeOp op = syntax_.operators[it.index + i];
        const Operand right = operand(i + 1);
        read_again_ = !final;
        add(n, op, t, last && final, {.a = as_double(op, left), .b = as_double(op, right)});
        read_again_ = false;
        if (!final)
            decided.push_back(
                add(n, CodeOp::jump_unless, t, last, {.a = Operand(Space::temporary, t)}));
        left = right;
    }
    for (std::uint32_t jump : decided) {
        if (!last) land(jump);
    }
}

void Emitter::conditional(std::uint32_t n, std::uint32_t t, bool last) {
    const std::uint32_t mark = next_temporary_;
    const std::uint32_t to_else = add(n, CodeOp::jump_unless, t, false, {.a = value(child(n, 0))});
    next_temporary_ = mark;
    into(child(n, 1), t, last);
    const std::uint32_t to_end = last ? 0 : add(n, CodeOp::jump, t, false, {});
    land(to_else);
    into(child(n, 2), t, last);
    if (!last) land(to_end);
}

CodeId emit(const Syntax& syntax, Names& names, CodeTable& code, std::vector<EmitError>& errors) {
    return Emitter(syntax, names, code, errors).whole();
}

CodeId emit_store(const Syntax& location, Names& names, CodeTable& code,
                  std::vector<EmitError>& errors) {
    return Emitter(location, names, code, errors).store();
}

}  // namespace trellis
