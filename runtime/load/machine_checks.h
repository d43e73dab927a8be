// What is probably not meant in a machine that has no errors: states that are never entered or
// cannot be left, transitions that are never taken, events that nothing raises or that no
// transition is for, eventless transitions that never come to rest. Only what is certain is said,
// and as warnings. Private to runtime/load. Covered by tests/load/machine_checks_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "load/diagnostics.h"
#include "load/document.h"

#include <vector>

namespace trellis {

/// A machine that was compiled without errors, and where its rows and transitions come from.
struct CheckedMachine {
    const Program& program;
    const Document& document;
    const std::vector<ElementId>& rows;         ///< by row; none below invoke rows
    const std::vector<ElementId>& transitions;  ///< by transition; none for ways of entering
    const std::vector<ElementId>& raises;       ///< <raise>, and <send> to the machine itself
    bool computes_events = false;               ///< a <send> has an eventexpr
    bool forwards_events = false;               ///< to an invoked machine
};

/// Warns about `machine`. Linear in its rows, transitions and names, times how deep states nest.
void check_machine(const CheckedMachine& machine, Diagnostics& diagnostics);

}  // namespace trellis
