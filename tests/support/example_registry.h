// A registry with a leaf for every kind of port, for tests that need leaves by name but no robot:
// the grammar, the checks, the schemas. Its leaves do nothing. Covered by the tests that use it.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"

namespace trellis::test {

/// The names of the lab's leaves, and one leaf each with a required text, an output, an in/out, an
/// untyped input and an integer.
void register_examples(Registry& registry);

}  // namespace trellis::test
