// Where the structs of leaves lie in a state. Private to runtime/load. Covered by
// tests/load/leaf_places_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"

namespace trellis {

/// Places the leaf structs of a compiled program so that those that never hold state at the same
/// time share their bytes: the children of a Sequence take turns, those of a Parallel do not, and a
/// leaf that answers at once holds none between two ticks. A leaf that can be halted shares none.
/// Structs that are alike on entry share
/// one prototype. Linear in the number of rows.
void place_leaves(Program& program);

}  // namespace trellis
