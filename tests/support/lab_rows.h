// Holding a run of the lab against a recorded one: bit for bit with the mathematics of x86-64
// glibc, within 1e-9 elsewhere; leaf, bumper and status always. Reading recordings is
// lab_streams.h's business. Covered by tests/sim/lab_streams_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/lab_reference.h"

#include <vector>

namespace trellis::test {

/// Checks that every recorded row is the one of its tick in `run`, which holds all ticks from 0 on.
/// Shows the first that is not; what was not recorded (a status, a path) is not compared.
void check_rows(const std::vector<LabRow>& run, const std::vector<LabRow>& recorded);

/// Checks that `recorded` holds exactly the ticks of `run` in which the leaf changes or the bumper
/// is pressed, and every 600th.
void check_events(const std::vector<LabRow>& run, const std::vector<LabRow>& recorded);

}  // namespace trellis::test
