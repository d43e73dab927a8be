// Recognises literals and single variables, and the expressions that robots ask in every cycle:
// these get forms that the interpreter answers without evaluating code, or not in every cycle:
// sensors, times, formulas, what only variables decide. What has no such form keeps its code alone.
// Private to runtime/load. Covered by tests/load/forms_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"

namespace trellis {

/// What the code always gives, or null: code that computes is not looked into.
const Value* literal_of(const CodeTable& code, CodeId id);

/// The variable whose value is what the code gives; none if it computes.
SlotId variable_of(const CodeTable& code, CodeId id);

/// The condition that the code (none: no condition) asks. The code must be the one emitted last.
Condition find_condition(Program& program, CodeId code);

/// The formula that computes the same as the code, none if there is no such formula. The code must
/// be the one emitted last.
FormulaId find_formula(Program& program, CodeId code);

/// Whether only variables of a machine decide what the code gives, not the time, a sensor or a
/// draw. The code must be the one emitted last.
bool is_steady(const CodeTable& code, CodeId id);

}  // namespace trellis
