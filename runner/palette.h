// What behaviour files can name: the built-in nodes of trees, the leaves and sensors of a host. One
// list, and its three spellings. Covered by tests/runner/nodes_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "load/document.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

struct PalettePort {
    std::string name;
    std::string_view direction;  ///< "input", "output", "inout"
    std::string_view type;       ///< as BehaviorTree.CPP spells it; empty: any
    std::string unit;            ///< empty: none
    std::string initial;         ///< what holds when it is not given; empty: nothing
    bool required = false;
    std::string doc;
};

struct PaletteNode {
    std::string_view kind;  ///< "Control", "Decorator", "Action", "Condition" or "SubTree"
    std::string name;
    std::string doc;
    bool built_in = false;  ///< else a leaf of the host
    std::vector<PalettePort> ports;
};

/// The built-in nodes in the order of the manual, then the leaves in the order of registration.
std::vector<PaletteNode> palette(const Registry& registry);

/// For people: a line per node, port and sensor.
std::string palette_text(const Registry& registry);
/// For programs: {"nodes": […], "sensors": […]}.
std::string palette_json(const Registry& registry);
/// For Groot2 and other editors: a tree file that has only a <TreeNodesModel> of the leaves, as
/// BehaviorTree.CPP writes it. Built-in nodes are not in it: editors know them.
std::string palette_xml(const Registry& registry);
/// Adds that <TreeNodesModel> to a tree file that is being written.
void add_models(Document& document, ElementId root, const Registry& registry);

}  // namespace trellis
