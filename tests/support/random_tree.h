// Random trees with scripted leaves, and all small ones. Used by the tests that compare the
// interpreter with a reference or state a property. Covered by those tests.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/random.h"
#include "support/tree_table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace trellis::test {

/// A tree of `nodes` nodes, more or less; some nodes have pre-conditions if `conditions`.
TreeSpec random_tree(Random& random, int nodes, bool conditions = true);

/// Every tree of exactly `nodes` nodes whose leaves all have the empty script: controls of any
/// number of children, decorators, Repeat and RetryUntilSuccessful with the number 2.
std::vector<TreeSpec> all_shapes(int nodes);

/// The leaves of `tree`, in order.
std::vector<TreeSpec*> leaves_of(TreeSpec& tree);

}  // namespace trellis::test
