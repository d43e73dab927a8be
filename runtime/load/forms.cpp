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

// The only variable that instructions [begin, end) read; none if they read none, more than one, or
// anything else that may change. Variables of trees have rules for reading, those of machines none.
SlotId only_variable(const CodeTable& code, std::uint32_t begin, std::uint32_t end) {
    SlotId found;
    for (std::uint32_t i = begin; i < end; ++i) {
        const Instruction& in = code.instructions[i];
        if (in.tree || !is_pure(in.op)) { return {}; }
        for (const Operand operand : {in.a, in.b}) {
            if (operand.space() != Space::slot) { continue; }
            const SlotId slot{operand.index()};
            if (found && slot != found) { return {}; }
            found = slot;
        }
    }
    return found;
}

DerivedId add_derived(Program& program, SlotId variable, CodeId code) {
    const Derived number{variable, code};
    const auto known = std::find(program.derived.begin(), program.derived.end(), number);
    const auto index = static_cast<std::uint32_t>(known - program.derived.begin());
    if (known == program.derived.end()) { program.derived.push_back(number); }
    return {index};
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
        better.variable = {limit.index()};
        return better;
    }
    if (end - begin == 2 && limit.space() == Space::constant &&
        code.constants[limit.index()].is(Value::Kind::real)) {
        better.form = Condition::Form::elapsed;
        better.limit = code.constants[limit.index()].as_real();
        return better;
    }
    const std::uint32_t last = end - 2;
    const SlotId variable = only_variable(code, begin + 1, end - 1);
    const bool straight = std::none_of(code.instructions.begin() + begin,
                                       code.instructions.begin() + end, [&](const Instruction& in) {
                                           return in.op == CodeOp::jump ||
                                                  in.op == CodeOp::jump_if ||
                                                  in.op == CodeOp::jump_unless;
                                       });
    if (!variable || !straight || limit.space() != Space::temporary ||
        limit.index() != code.instructions[last].target) {
        return found;
    }
    better.form = Condition::Form::elapsed_derived;
    better.derived = add_derived(program, variable, copy_of(code, begin + 1, end - 1));
    return better;
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
        steps.push_back({next.op, !result_first, code.constants[other.index()].as_real()});
    }
    return true;
}

}  // namespace

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

FormulaId find_formula(Program& program, CodeId code) {
    const Instruction& first = program.code.instructions[code.index];
    const auto end = static_cast<std::uint32_t>(program.code.instructions.size());
    Formula found{.at = first.extra};
    std::vector<FormulaStep> steps;
    switch (first.op) {
    case CodeOp::elapsed_since: break;
    case CodeOp::elapsed_count: found.source = Formula::Source::elapsed_count; break;
    case CodeOp::sensor_real: found.source = Formula::Source::sensor; break;
    default: {
        const SlotId variable = only_variable(program.code, code.index, end);
        if (!variable) { return {}; }
        found.source = Formula::Source::derived;
        found.at = add_derived(program, variable, code).index;
    }
    }
    if (found.source != Formula::Source::derived && !chain(program.code, &first, steps)) {
        return {};
    }
    found.first_step = static_cast<std::uint32_t>(program.formula_steps.size());
    found.step_count = static_cast<std::uint32_t>(steps.size());
    program.formula_steps.insert(program.formula_steps.end(), steps.begin(), steps.end());
    program.formulas.push_back(found);
    return {static_cast<std::uint32_t>(program.formulas.size() - 1)};
}

}  // namespace trellis
