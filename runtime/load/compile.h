// Document to Program: names to numbers, and every check that needs the whole document. A document
// is expected to have passed check.h; what that has reported is passed over here.
// Covered by tests/load/compile_tree_test.cpp and tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/builder.h"

namespace trellis {

/// Compiles a tree file and what it includes into the empty program of `builder`. Errors go to its
/// diagnostics; the program is usable only if there are none.
void compile_tree(ReadFile file, Builder& builder);

/// Compiles a machine file likewise.
void compile_machine(ReadFile file, Builder& builder);

}  // namespace trellis
