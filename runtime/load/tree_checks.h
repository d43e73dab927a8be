// What is probably not meant in a tree that has no errors: nodes that are never ticked, loops that
// never end. Only what is certain is said, and as warnings: a tree with such a part still runs.
// Private to runtime/load. Covered by tests/load/tree_checks_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "load/diagnostics.h"

#include <vector>

namespace trellis {

/// Warns about the trees of `program`, which was compiled without errors; each place once, however
/// often a subtree is used. `unset`: the variables to which nothing gives a value, sorted. Linear
/// in the rows.
void check_trees(const Program& program, const std::vector<SlotId>& unset,
                 Diagnostics& diagnostics);

}  // namespace trellis
