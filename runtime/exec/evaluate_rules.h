// What operations mean for operands that the inner loop (evaluate.cpp) does not decide itself:
// everything but two numbers. Internal to exec/evaluate*.cpp; one file per setting. Covered by
// tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "exec/evaluate.h"

#include <optional>

namespace trellis {

inline const Value& value_at(const EvalContext& context, Operand operand) {
    return context.base[static_cast<std::size_t>(operand.space())][operand.index()];
}

/// Notes what went wrong, with the kinds of the operands; always false. The inner loop adds the
/// instruction.
bool fail(EvalContext& context, EvalErrorKind kind, const Value& a, const Value& b);

/// A number that arithmetic can use: of a real, of an integer that a double holds exactly. Nothing
/// for other values.
inline bool exact_number(const Value& v, double& number) {
    constexpr std::int64_t limit = std::int64_t{1} << 53;
    if (v.is(Value::Kind::real)) {
        number = v.as_real();
        return true;
    }
    if (!v.is(Value::Kind::integer) || v.as_integer() < -limit || v.as_integer() > limit)
        return false;
    number = static_cast<double>(v.as_integer());
    return true;
}

/// BehaviorTree.CPP: numbers are equal up to std::numeric_limits<float>::epsilon().
inline constexpr double tree_tolerance = 1.1920928955078125e-07;

// Each computes the result of one instruction into its temporary; false: it failed.

/// Arithmetic, comparison, logic, assignment of trees.
bool tree_operation(const CodeTable& code, EvalContext& context, const Instruction& in);

/// Arithmetic, comparison, logic of machines.
bool machine_operation(EvalContext& context, const Instruction& in);

/// Calls of functions.
bool call_function(EvalContext& context, const Instruction& in);

/// Arrays, objects and places in them.
bool structure_operation(EvalContext& context, const Instruction& in);

/// Whether `v` counts as true where a condition is needed.
Truth tree_ternary(
    const Value& v);  ///< before a "?": a number other than 0, or a text that begins with one
Truth tree_condition(const Value& v);  ///< of a node: a real that is not negative, 0, 1
Truth machine_condition(const Value& v);

/// What a text spells where a value of that type is wanted, as BehaviorTree.CPP converts it: a
/// number by what the text begins with. False, and `out` as it was, if it spells none.
bool convert_text(EntryType type, std::string_view text, Value& out);

/// a == b in machines: numbers and booleans by their number, a text beside a number by the number
/// it spells, arrays and objects by their content.
bool machine_equal(const Value& a, const Value& b);

/// The text of a value in machines: str(v), `..` and keys.
void append_text(std::string& out, const Value& v);

void append_integer(std::string& out, std::int64_t number);

/// A double as an integer of 64 bits: the digits before the point. Nothing if there are too many,
/// or for NaN.
inline std::optional<std::int64_t> truncated(double number) {
    // written so that NaN fails too; 2^63 itself does not fit
    if (!(number >= -9223372036854775808.0 && number < 9223372036854775808.0)) return std::nullopt;
    return static_cast<std::int64_t>(number);
}

}  // namespace trellis
