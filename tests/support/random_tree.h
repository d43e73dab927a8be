// Random trees with scripted leaves, and all small ones. Used by the tests that compare the
// interpreter with a reference or state a property. Covered by those tests.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/random.h"
#include "support/tree_table.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace trellis::test {

/// A tree of `nodes` nodes, more or less; some nodes have pre-conditions if `conditions`.
TreeSpec random_tree(Random& random, int nodes, bool conditions = true);

/// Visits every tree of exactly `nodes` nodes whose leaves all have the empty script, with every
/// control and decorator that needs no entry, each with one or two settings of its numbers. The
/// visitor may change scripts.
void for_each_shape(int nodes, const std::function<void(TreeSpec&)>& visit);

/// The leaves of `tree`, in order.
std::vector<TreeSpec*> leaves_of(TreeSpec& tree);

}  // namespace trellis::test
