// Which transitions do nothing but change states. Private to runtime/load. Covered by
// tests/exec/plain_events_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"

namespace trellis {

/// Fills Transition::only_moves, Program::entered, StateInfo::silent and
/// Program::takes_plain_events of a compiled machine; nothing to do for a tree. Linear in its size.
void find_moves(Program& program);

}  // namespace trellis
