// Answers the forms that need no code (Condition, Formula in core/program.h): inlined into the
// cycle, because robots ask them in every one. Private to runtime/exec. Covered by
// tests/exec/quiet_step_test.cpp, which asks the code of each form for the same.
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

inline bool sensed(const void* host, std::uint32_t at) {
    bool value = false;
    std::memcpy(&value, static_cast<const std::byte*>(host) + at, sizeof value);
    return value;
}

inline Answer answer(const FormView& view, const Condition& condition) {
    switch (condition.form) {
    case Condition::Form::always: return Answer::yes;
    case Condition::Form::sensor: return sensed(view.host, condition.at) ? Answer::yes : Answer::no;
    case Condition::Form::elapsed:
        return view.elapsed_since(condition.at) > condition.limit ? Answer::yes : Answer::no;
    default: return Answer::unknown;
    }
}

[[gnu::always_inline]] inline double compute(const FormView& view, const Formula& formula) {
    double value = 0.0;
    if (formula.source == Formula::Source::elapsed_since) [[likely]] {
        value = view.elapsed_since(formula.at);
    } else if (formula.source == Formula::Source::elapsed_count) {
        value = view.state.memory[formula.at] * view.dt;
    } else {
        std::memcpy(&value, static_cast<const std::byte*>(view.host) + formula.at, sizeof value);
    }
    const FormulaStep* const first = view.program.formula_steps.data() + formula.first_step;
    const FormulaStep* const last = first + formula.step_count;
    for (const FormulaStep* step = first; step != last; ++step) {
        value = value * step->factor + step->summand;
        if (step->division == FormulaStep::Division::none) { continue; }
        value = step->division == FormulaStep::Division::by_literal ? value / step->literal
                                                                    : step->literal / value;
    }
    return value;
}

}  // namespace trellis
