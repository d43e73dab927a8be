// Single instructions, constants, temporaries and the accumulator: see emitter.h. Covered by
// tests/load/expression_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/emitter.h"

#include <algorithm>
#include <utility>

namespace trellis {
namespace {

constexpr std::uint32_t most_temporaries = 0xFFFF;

}  // namespace

void Emitter::report(std::uint32_t n, std::string message) {
    errors_.push_back({.offset = node(n).offset, .message = std::move(message)});
}

std::uint32_t Emitter::temporary() {
    const std::uint32_t t = next_temporary_++;
    if (t == most_temporaries) {
        report(syntax_.root, "the expression has too many parts");
        next_temporary_ = first_temporary;
        return first_temporary;
    }
    code_.temporaries = std::max(code_.temporaries, t + 1);
    return t;
}

std::uint32_t Emitter::add(std::uint32_t n, Instruction in) {
    in.tree = tree();
    if (reads_number(in) && !read_again_) {
        in.a = accumulated(in.a);
        in.b = accumulated(in.b);
    }
    code_.instructions.push_back(in);
    code_.offsets.push_back(node(n).offset);
    return position() - 1;
}

bool Emitter::reads_number(const Instruction& in) {
    return in.op <= CodeOp::absolute || (in.op >= CodeOp::less && in.op <= CodeOp::not_equal) ||
           in.op == CodeOp::assign || in.op == CodeOp::store;
}

Operand Emitter::accumulated(Operand operand) {
    if (operand.space() != Space::temporary || position() == landed_at_ || position() == begin_)
        return operand;
    Instruction& previous = code_.instructions.back();
    if (previous.target != operand.index() || !gives_number(previous)) return operand;
    previous.target = static_cast<std::uint16_t>(accumulator_operand.index());
    return accumulator_operand;
}

bool Emitter::gives_number(const Instruction& in) const {
    switch (in.op) {
    case CodeOp::subtract:
    case CodeOp::multiply:
    case CodeOp::divide:
    case CodeOp::negate:
    case CodeOp::absolute:
    case CodeOp::sensor_integer:
    case CodeOp::sensor_real:
    case CodeOp::elapsed_count:
    case CodeOp::elapsed_since: return true;
    case CodeOp::add: return is_number(in.a) || is_number(in.b);  // else it may join texts
    default: return false;
    }
}

bool Emitter::is_number(Operand operand) const {
    const Value* v = constant_at(operand);
    return operand == accumulator_operand || (v != nullptr && v->is_number());
}

std::uint32_t Emitter::add(std::uint32_t n, CodeOp op, std::uint32_t target, bool last,
                           Parts parts) {
    return add(n, {.op = op,
                   .last = last,
                   .tree = false,
                   .target = static_cast<std::uint16_t>(target),
                   .a = parts.a,
                   .b = parts.b,
                   .extra = parts.extra});
}

void Emitter::land(std::uint32_t jump) {
    code_.instructions[jump].extra = position();
    landed_at_ = position();
}

void Emitter::fail(std::uint32_t n, EvalErrorKind kind, std::string_view name) {
    add(n, CodeOp::fail, 0, false,
        {.a = constant(Value::text(name)), .extra = static_cast<std::uint32_t>(kind)});
}

Operand Emitter::constant(Value value) {
    // an expression has few constants; those of others are not searched
    std::vector<Value>& constants = code_.constants;
    const std::size_t nearby = constants.size() > 16 ? constants.size() - 16 : 0;
    for (std::size_t i = std::max(first_constant_, nearby); i < constants.size(); ++i) {
        if (constants[i] == value) return Operand(Space::constant, static_cast<std::uint32_t>(i));
    }
    constants.push_back(std::move(value));
    return Operand(Space::constant, static_cast<std::uint32_t>(constants.size() - 1));
}

const Value* Emitter::constant_at(Operand operand) const {
    return operand.space() == Space::constant ? &code_.constants[operand.index()] : nullptr;
}

}  // namespace trellis
