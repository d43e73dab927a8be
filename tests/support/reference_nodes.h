// The parts of a reference tree that have files of their own: private to support/reference_*.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/reference_tree.h"

#include <memory>

namespace trellis::test {

/// Thrown where BehaviorTree.CPP throws.
struct ReferenceStop {};

/// The node without its children; null if it is of another group.
std::unique_ptr<ReferenceNode> reference_control(const TreeSpec& spec, ReferenceWorld& world);
std::unique_ptr<ReferenceNode> reference_decorator(const TreeSpec& spec, ReferenceWorld& world);

}  // namespace trellis::test
