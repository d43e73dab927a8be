// The commonest cycle of a machine: no event but `tick` is there, no guard holds, one activity goes
// on. Run without setting up the interpreter. Private to runtime/exec. Covered by
// tests/exec/quiet_cycle_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "exec/step.h"

#include <optional>

namespace trellis {

/// What such a cycle came to. `not_quiet`: nothing has happened, and this cycle may be another
/// kind. `ended`: the activity was ticked and has ended, or failed, with `status`.
struct QuietCycle {
    enum class Outcome : std::uint8_t { not_quiet, running, ended };
    Outcome outcome = Outcome::not_quiet;
    Status status = Status::running;
};

/// Tries it on a machine.
QuietCycle quiet_cycle(const Program& program, State& state, HostRef host,
                       const StepOptions& options);

}  // namespace trellis
