// Why two behaviours part in a tick, in words made from what both of them did. General: it knows
// labels, statuses and transitions, no files. Covered by tests/runner/compare_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/contestant.h"

#include <string>
#include <vector>

namespace trellis {

/// What happened to a contestant in its last tick: one sentence.
std::string describe_tick(const Contestant& contestant);

/// A transition as its author wrote it: `"elapsed() > 3" (line 16)`.
std::string describe_transition(const Entrant& entrant, TransitionId transition);

/// Lines of text: what both did in the tick in which they first differed, what the one that went on
/// does next, by which rule, and what follows.
std::vector<std::string> explain(const Contestant& a, const Contestant& b);

}  // namespace trellis
