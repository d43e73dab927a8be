// The three pictures of a tree model. What they show is decided in tree_model.h, where in
// tidy_layout.h. Covered by tests/drawing/tree_drawing_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/drawing.h"
#include "runner/drawing/tree_model.h"

#include <string>

namespace trellis::drawing {

/// An SVG with the trees below each other, opened ones in tinted frames. Of a node's ports the
/// first five are shown, cut to a line; a tooltip has all of them, and the node's doc.
std::string tree_svg(const Document& document, const TreeModel& model,
                     const DrawingOptions& options);

/// A Graphviz digraph with a cluster for each tree, those of opened SubTrees inside that of the
/// tree that uses them. The nodes are called n0, n1, …, in the order of the model.
std::string tree_dot(const TreeModel& model, const DrawingOptions& options);

/// The trees with a line for each node: symbol, name, type, ports, tags.
std::string tree_text(const TreeModel& model, const DrawingOptions& options);

/// What a node is called, and its type where that says more: "explore" and "Sequence".
struct NodeTitle {
    std::string title;
    std::string kind;  ///< empty if the title says it
};
NodeTitle title_of(const DrawnNode& node);

}  // namespace trellis::drawing
