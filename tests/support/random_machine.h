// Random statecharts without faults, of what support/reference_machine.h understands. Covered by
// the tests that use them.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/random.h"

#include <string>

namespace trellis::test {

/// The text of a machine of about `states` states: compound, parallel and final states, histories,
/// initial states of every spelling, all kinds of transitions, content that raises, logs, assigns,
/// loops, sends and fails, invoked machines.
std::string random_machine(Random& random, int states);

/// One of the names that random machines answer to, or raise, or neither.
std::string random_event(Random& random);

}  // namespace trellis::test
