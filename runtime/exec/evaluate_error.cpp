// Failures of evaluations in words. Nothing here runs while an evaluation succeeds.
// Covered by tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/evaluate.h"
#include "exec/evaluate_rules.h"

#include <string>

namespace trellis {
namespace {

std::string_view sign_of(CodeOp op) {
    switch (op) {
    case CodeOp::add:
    case CodeOp::assign_add: return "+";
    case CodeOp::subtract:
    case CodeOp::negate:
    case CodeOp::assign_subtract: return "-";
    case CodeOp::multiply:
    case CodeOp::assign_multiply: return "*";
    case CodeOp::divide:
    case CodeOp::assign_divide: return "/";
    case CodeOp::remainder: return "%";
    case CodeOp::complement: return "~";
    case CodeOp::bit_and: return "&";
    case CodeOp::bit_or: return "|";
    case CodeOp::bit_xor: return "^";
    case CodeOp::concatenate: return "..";
    case CodeOp::less: return "<";
    case CodeOp::less_equal: return "<=";
    case CodeOp::greater: return ">";
    case CodeOp::greater_equal: return ">=";
    case CodeOp::equal: return "==";
    case CodeOp::not_equal: return "!=";
    case CodeOp::logical_not: return "!";
    case CodeOp::logical_and: return "&&";
    case CodeOp::logical_or: return "||";
    default: return "";
    }
}

std::string variable(Operand operand, std::span<const std::string> slot_names) {
    if (operand.space() != Space::slot) return "a value";
    if (operand.index() >= slot_names.size()) return "variable " + std::to_string(operand.index());
    return "variable \"" + slot_names[operand.index()] + '"';
}

// the name that a `fail` instruction is about
std::string quoted_name(const Instruction& in, const CodeTable& code) {
    return '"' + code.constants[in.a.index()].as_text() + '"';
}

std::string refused_operands(const Instruction& in, const EvalError& error) {
    const std::string left(name_of(error.left));
    if (in.op == CodeOp::call)
        return "function " + std::string(functions()[in.b.index()].name) + " does not take " + left;
    if (in.op == CodeOp::in_named) return "In() takes the name of a state, found " + left;
    if (in.op == CodeOp::absolute) return "function abs does not take " + left;
    const bool one =
        in.op == CodeOp::negate || in.op == CodeOp::complement || in.op == CodeOp::logical_not;
    std::string text = "operator " + std::string(sign_of(in.op)) + " does not take " + left;
    return one ? text : text + " and " + std::string(name_of(error.right));
}

}  // namespace

bool fail(EvalContext& context, EvalErrorKind kind, const Value& a, const Value& b) {
    context.error.kind = kind;
    context.error.left = a.kind();
    context.error.right = b.kind();
    return false;
}

std::string describe(const EvalError& error, const CodeTable& code,
                     std::span<const std::string> slot_names) {
    if (error.kind == EvalErrorKind::none) return "no error";
    const Instruction& in = code.instructions[error.instruction];
    const std::string left(name_of(error.left));
    const std::string right(name_of(error.right));
    const bool named = in.op == CodeOp::fail;
    switch (error.kind) {
    case EvalErrorKind::none: break;
    case EvalErrorKind::undeclared: return "there is no variable " + quoted_name(in, code);
    case EvalErrorKind::read_only: return quoted_name(in, code) + " cannot be assigned to";
    case EvalErrorKind::not_assignable: return "only a variable can be assigned to";
    case EvalErrorKind::missing:
        return (named ? "variable " + quoted_name(in, code) : variable(in.a, slot_names)) +
               " does not exist yet";
    case EvalErrorKind::empty:
        return "an operand of " + std::string(sign_of(in.op)) + " has no value yet";
    case EvalErrorKind::operands: return refused_operands(in, error);
    case EvalErrorKind::not_integral: return "a whole number of 64 bits is needed here";
    case EvalErrorKind::inexact: return "the integer is too large to be computed with exactly";
    case EvalErrorKind::not_a_condition: return "a condition is needed here, found " + left;
    case EvalErrorKind::not_a_number: return "a number is needed here, found " + left;
    case EvalErrorKind::text_not_a_number: return "the text is no number and names none";
    case EvalErrorKind::type_fixed:
        return variable(in.a, slot_names) + " holds " + left + ", which this " + right +
               " cannot become";
    case EvalErrorKind::no_such_place: return "there is no such place in a value of kind " + left;
    case EvalErrorKind::nested_too_deeply: return "arrays and objects nest too deeply";
    case EvalErrorKind::no_such_state:
        return named ? "there is no state " + quoted_name(in, code) : "there is no such state";
    case EvalErrorKind::no_random: return "there are no random numbers here";
    }
    return {};
}

}  // namespace trellis
