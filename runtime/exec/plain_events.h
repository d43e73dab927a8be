// Steps of machines that only change states: the events that wait are taken without setting up the
// interpreter, as long as their transitions run no content and their guards need no code. Private
// to runtime/exec. Covered by tests/exec/plain_events_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "exec/quiet_step.h"

namespace trellis {

/// Tries such a step, of a machine for which Program::takes_plain_events. If it proves to be more,
/// the events before the first that is not plain have been taken, as the interpreter would have.
QuietStep take_plain_events(const Program& program, State& state, HostRef host,
                            const StepOptions& options);

}  // namespace trellis
