// Answers the forms that need no code (Condition, Formula, Derived in core/program.h): inlined into
// the cycle, because robots ask them in every one. Private to runtime/exec. Covered by
// tests/exec/forms_test.cpp, which asks the code of each form for the same.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/state.h"

#include <cstdint>
#include <cstring>

namespace trellis {

/// What forms read.
struct FormView {
    const Program& program;
    const State& state;
    const void* host;
    std::uint32_t clock;  ///< Session::clock of the cycle that is asked about
    double dt;            ///< s

    /// Seconds since the state or machine of a row was entered.
    double elapsed_since(std::uint32_t row) const { return (clock - state.memory[row]) * dt; }
};

/// `unknown`: only the code of the condition can say.
enum class Answer : std::uint8_t { no, yes, unknown };

/// A derived number; false if it was not computed for what its variable now holds.
inline bool derived(const FormView& view, std::uint32_t id, double& result) {
    const State::Memo& memo = view.state.derived[id];
    const Value& variable = view.state.slots[view.program.derived[id].variable.index];
    // no variable that is undefined has a memo
    if (variable.is(Value::Kind::undefined) || memo.variable != variable) { return false; }
    result = memo.value;
    return true;
}

[[gnu::always_inline]] inline Answer answer(const FormView& view, const Condition& condition) {
    const auto exceeds = [&](double limit) {
        return view.elapsed_since(condition.at) > limit ? Answer::yes : Answer::no;
    };
    switch (condition.form) {
    case Condition::Form::always: return Answer::yes;
    case Condition::Form::sensor: {
        bool sensed = false;
        std::memcpy(&sensed, static_cast<const std::byte*>(view.host) + condition.at,
                    sizeof sensed);
        return sensed ? Answer::yes : Answer::no;
    }
    case Condition::Form::elapsed: return exceeds(condition.limit);
    case Condition::Form::elapsed_variable: {
        const Value& limit = view.state.slots[condition.variable.index];
        return limit.is_number() ? exceeds(limit.number()) : Answer::unknown;
    }
    case Condition::Form::elapsed_derived: {
        double limit = 0.0;
        return derived(view, condition.derived.index, limit) ? exceeds(limit) : Answer::unknown;
    }
    case Condition::Form::code: break;
    }
    return Answer::unknown;
}

/// False if what the formula starts from is not known.
[[gnu::always_inline]] inline bool compute(const FormView& view, const Formula& formula,
                                           double& result) {
    switch (formula.source) {
    case Formula::Source::elapsed_since: result = view.elapsed_since(formula.at); break;
    case Formula::Source::elapsed_count: result = view.state.memory[formula.at] * view.dt; break;
    case Formula::Source::sensor:
        std::memcpy(&result, static_cast<const std::byte*>(view.host) + formula.at, sizeof result);
        break;
    case Formula::Source::derived:
        if (!derived(view, formula.at, result)) { return false; }
        break;
    }
    const FormulaStep* const first = view.program.formula_steps.data() + formula.first_step;
    for (const FormulaStep* step = first; step != first + formula.step_count; ++step) {
        const double left = step->literal_first ? step->literal : result;
        const double right = step->literal_first ? result : step->literal;
        switch (step->op) {
        case CodeOp::add: result = left + right; break;
        case CodeOp::subtract: result = left - right; break;
        case CodeOp::multiply: result = left * right; break;
        default: result = left / right; break;
        }
    }
    return true;
}

}  // namespace trellis
