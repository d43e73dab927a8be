// What a drawing of behaviour trees shows, apart from where: nodes in the order of the text, with
// their symbols, names and lines of detail, and every SubTree opened at its first use. Covered by
// tests/drawing/tree_model_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"
#include "runner/drawing/drawing.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::drawing {

enum class NodeShape : std::uint8_t { control, decorator, condition, action, subtree };

/// A row number of TreeModel::nodes.
using NodeIndex = Id<struct DrawnNodeTag>;

struct DrawnNode {
    ElementId element;
    NodeIndex parent;       ///< none for the root of a tree; the SubTree for the root of its tree
    std::uint32_t end = 0;  ///< one past the last node below this one
    NodeShape shape = NodeShape::action;
    bool opened = false;      ///< a SubTree whose tree follows as its only child
    std::string_view symbol;  ///< of node_looks.def, which lives for ever; may be empty
    std::string_view ascii;   ///< the same in ASCII
    std::string type;         ///< "Sequence"; of a SubTree the ID of its tree
    std::string name;         ///< of the instance; empty if it is the type
    std::string code;  ///< value of the port that says what it does (node_looks.def), or empty
    std::vector<std::string> ports;  ///< the others: "speed = 0.5", whole, in written order
    std::vector<std::string> tags;   ///< "skip if x > 3", whole, in written order
};

/// One picture: a tree with all that is opened inside it.
struct DrawnTree {
    std::string id;  ///< of its <BehaviorTree>; may be empty
    std::uint32_t begin = 0;
    std::uint32_t end = 0;  ///< nodes [begin, end)
};

struct TreeModel {
    std::vector<DrawnNode> nodes;  ///< parents before children, siblings in order
    std::vector<DrawnTree> trees;  ///< the main tree first, then those that it does not reach
};

/// The model of a tree file. A tree is opened where it is first used, as long as its nodes then
/// stand less than 256 deep; all else that names it refers to that place.
TreeModel tree_model(const Document& document, const DrawingOptions& options);

}  // namespace trellis::drawing
