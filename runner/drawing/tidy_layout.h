// Where the nodes of a tree stand: siblings side by side as close as their subtrees allow, parents
// over the middle of their children, no two boxes overlapping. After van der Ploeg, "Drawing
// Non-layered Tidy Trees in Linear Time" (2014), which is Reingold and Tilford's layout for nodes
// of different sizes. Knows only sizes. Covered by tests/drawing/tidy_layout_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/geometry.h"

#include <cstdint>
#include <vector>

namespace trellis::drawing {

/// A node to place. "Across" is the direction in which siblings follow each other, "along" the one
/// from parent to child.
struct TidyNode {
    static constexpr std::uint32_t no_parent = 0xFFFFFFFF;

    std::uint32_t parent = no_parent;  ///< row of the parent; no_parent for the first node only
    std::uint32_t end = 0;             ///< one past the last row below this node
    double across = 0;                 ///< size of its box
    double along = 0;
    bool framed = false;  ///< a frame surrounds it and all nodes below, and keeps others out
};

struct TidyGaps {
    double across = 20;  ///< between boxes side by side
    double along = 40;   ///< from a box to its children's; more than `frame`
    double frame = 12;   ///< from a frame to the boxes inside
};

/// Boxes with x across and y along, nothing left of 0 or above 0.
struct TidyLayout {
    std::vector<Box> boxes;   ///< of each node
    std::vector<Box> frames;  ///< of each framed node, in the order of the nodes
    Size size;
};

/// The layout of one tree, whose nodes are in depth-first order (a parent, then each child with all
/// below it). Time and memory are linear; nothing recurses.
TidyLayout tidy_layout(const std::vector<TidyNode>& nodes, const TidyGaps& gaps);

}  // namespace trellis::drawing
