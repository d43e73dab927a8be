// Reads the instructions that were just emitted: they reach from `code` to the end of the table.
// SPDX-License-Identifier: MIT
#include "load/forms.h"

#include <algorithm>
#include <vector>

namespace trellis {

namespace {

bool is_arithmetic(CodeOp op) {
    return op == CodeOp::add || op == CodeOp::subtract || op == CodeOp::multiply ||
           op == CodeOp::divide;
}

// What gives the same result for the same operands, in any cycle.
bool is_pure(CodeOp op) {
    switch (op) {
    case CodeOp::remainder:
    case CodeOp::negate:
    case CodeOp::absolute:
    case CodeOp::less:
    case CodeOp::less_equal:
    case CodeOp::greater:
    case CodeOp::greater_equal:
    case CodeOp::equal:
    case CodeOp::not_equal:
    case CodeOp::logical_not:
    case CodeOp::logical_and:
    case CodeOp::logical_or:
    case CodeOp::truth:
    case CodeOp::copy:
    case CodeOp::jump:
    case CodeOp::jump_if:
    case CodeOp::jump_unless: return true;
    default: return is_arithmetic(op);
    }
}

// Whether only variables of a machine decide what instructions [begin, end) give.
bool is_steady(const CodeTable& code, std::uint32_t begin, std::uint32_t end) {
    return std::all_of(code.instructions.begin() + begin, code.instructions.begin() + end,
                       [](const Instruction& in) { return !in.tree && is_pure(in.op); });
}

bool is_jump(const Instruction& in) {
    return in.op == CodeOp::jump || in.op == CodeOp::jump_if || in.op == CodeOp::jump_unless;
}

// A variable as an expression of its own.
CodeId copy_of(CodeTable& code, Operand variable, std::uint32_t offset) {
    const CodeId id{static_cast<std::uint32_t>(code.instructions.size())};
    code.instructions.push_back(
        {.op = CodeOp::copy, .last = true, .tree = false, .a = variable, .b = {}});
    code.offsets.push_back(offset);
    return id;
}

// Instructions [begin, end) as an expression of their own. They do not jump.
CodeId copy_of(CodeTable& code, std::uint32_t begin, std::uint32_t end) {
    const CodeId id{static_cast<std::uint32_t>(code.instructions.size())};
    for (std::uint32_t i = begin; i < end; ++i) {
        code.instructions.push_back(Instruction(code.instructions[i]));
        code.offsets.push_back(std::uint32_t(code.offsets[i]));
    }
    code.instructions.back().last = true;
    return id;
}

// elapsed() > E: the comparison is last and reads the time, and between the two stands E.
Condition elapsed_condition(Program& program, Condition found) {
    CodeTable& code = program.code;
    const auto end = static_cast<std::uint32_t>(code.instructions.size());
    const std::uint32_t begin = found.code.index;
    const Instruction elapsed = code.instructions[begin];
    const Instruction compare = code.instructions[end - 1];
    if (end - begin < 2 || compare.op != CodeOp::greater || !compare.last || compare.tree ||
        compare.a != Operand(Space::temporary, elapsed.target)) {
        return found;
    }
    Condition better = found;
    better.at = elapsed.extra;
    const Operand limit = compare.b;
    if (end - begin == 2 && limit.space() == Space::slot) {
        better.form = Condition::Form::elapsed_variable;
        better.variables = copy_of(code, limit, std::uint32_t(code.offsets[begin]));
        return better;
    }
    if (end - begin == 2 && limit.space() == Space::constant &&
        code.constants[limit.index()].is(Value::Kind::real)) {
        better.form = Condition::Form::elapsed;
        better.limit = code.constants[limit.index()].as_real();
        return better;
    }
    const std::uint32_t last = end - 2;
    const bool straight =
        std::none_of(code.instructions.begin() + begin, code.instructions.begin() + end, is_jump);
    if (!straight || !is_steady(code, begin + 1, end - 1) || limit.space() != Space::temporary ||
        limit.index() != code.instructions[last].target) {
        return found;
    }
    better.form = Condition::Form::elapsed_variable;
    better.variables = copy_of(code, begin + 1, end - 1);
    return better;
}

// Adds `result op literal`, or `literal op result`, to the steps: to the last one if that has room.
void add_step(std::vector<FormulaStep>& steps, CodeOp op, bool literal_first, double literal) {
    const FormulaStep fresh;
    // a number, by its bits: 0.0 is no -0.0
    const auto is_unset = [](double value, double unset) {
        return Value::real(value) == Value::real(unset);
    };
    const auto last = [&](bool has_room) -> FormulaStep& {
        const bool divided = !steps.empty() && steps.back().division != FormulaStep::Division::none;
        return steps.empty() || divided || !has_room ? steps.emplace_back() : steps.back();
    };
    const bool may_add = !steps.empty() && is_unset(steps.back().summand, fresh.summand);
    const bool may_multiply = may_add && is_unset(steps.back().factor, fresh.factor);
    switch (op) {
    case CodeOp::multiply: last(may_multiply).factor = literal; return;
    case CodeOp::add: last(may_add).summand = literal; return;
    case CodeOp::subtract:
        if (literal_first) {
            last(may_multiply).factor = -1.0;
            steps.back().summand = literal;
        } else {
            last(may_add).summand = -literal;
        }
        return;
    default: {
        FormulaStep& step = last(true);
        step.literal = literal;
        step.division =
            literal_first ? FormulaStep::Division::of_literal : FormulaStep::Division::by_literal;
    }
    }
}

// E op E op …, from a number that stands for itself: one chain through the accumulator.
bool chain(const CodeTable& code, const Instruction* in, std::vector<FormulaStep>& steps) {
    for (; !in->last; ++in) {
        const Instruction& next = in[1];
        const bool result_first = next.a == accumulator_operand;
        const Operand other = result_first ? next.b : next.a;
        const bool chained = in->target == accumulator_operand.index() &&
                             (result_first || next.b == accumulator_operand);
        const bool literal =
            other.space() == Space::constant && code.constants[other.index()].is(Value::Kind::real);
        if (!chained || !is_arithmetic(next.op) || !literal) { return false; }
        add_step(steps, next.op, !result_first, code.constants[other.index()].as_real());
    }
    return true;
}

/// The operand that the code is a copy of; null if it computes.
const Operand* copied(const CodeTable& code, CodeId id) {
    if (!id) { return nullptr; }
    const Instruction& in = code.instructions[id.index];
    return in.op == CodeOp::copy && in.last ? &in.a : nullptr;
}

}  // namespace

const Value* literal_of(const CodeTable& code, CodeId id) {
    const Operand* const operand = copied(code, id);
    const bool is_literal = operand != nullptr && operand->space() == Space::constant;
    return is_literal ? &code.constants[operand->index()] : nullptr;
}

SlotId variable_of(const CodeTable& code, CodeId id) {
    const Operand* const operand = copied(code, id);
    const bool is_variable = operand != nullptr && operand->space() == Space::slot;
    return is_variable ? SlotId{operand->index()} : SlotId();
}

Condition find_condition(Program& program, CodeId code) {
    if (!code) { return {}; }
    Condition found{.form = Condition::Form::code, .code = code};
    const Instruction& first = program.code.instructions[code.index];
    if (first.op == CodeOp::sensor_boolean && first.last) {
        found.form = Condition::Form::sensor;
        found.at = first.extra;
    }
    return first.op == CodeOp::elapsed_since && !first.last ? elapsed_condition(program, found)
                                                            : found;
}

bool is_steady(const CodeTable& code, CodeId id) {
    return is_steady(code, id.index, static_cast<std::uint32_t>(code.instructions.size()));
}

FormulaId find_formula(Program& program, CodeId code) {
    const Instruction& first = program.code.instructions[code.index];
    Formula found{.at = first.extra};
    std::vector<FormulaStep> steps;
    switch (first.op) {
    case CodeOp::elapsed_since: break;
    case CodeOp::elapsed_count: found.source = Formula::Source::elapsed_count; break;
    case CodeOp::sensor_real: found.source = Formula::Source::sensor; break;
    default: return {};
    }
    if (!chain(program.code, &first, steps)) { return {}; }
    found.first_step = static_cast<std::uint32_t>(program.formula_steps.size());
    found.step_count = static_cast<std::uint32_t>(steps.size());
    program.formula_steps.insert(program.formula_steps.end(), steps.begin(), steps.end());
    program.formulas.push_back(found);
    return {static_cast<std::uint32_t>(program.formulas.size() - 1)};
}

}  // namespace trellis
