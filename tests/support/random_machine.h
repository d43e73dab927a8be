// Random statecharts without faults, of the part that support/reference_machine.h understands.
// Covered by the tests that use them.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/random.h"

#include <string>

namespace trellis::test {

/// The text of a machine of about `states` states: compound and final states, initial states of
/// every spelling, all kinds of transitions, content that raises, logs, assigns and fails.
std::string random_machine(Random& random, int states);

/// One of the names that random machines answer to, or raise, or neither.
std::string random_event(Random& random);

}  // namespace trellis::test
