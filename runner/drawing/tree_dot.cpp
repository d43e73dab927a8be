// Trees as Graphviz graphs: Graphviz places the nodes, ordering=out keeps siblings in order.
// SPDX-License-Identifier: MIT
#include "runner/drawing/dot.h"
#include "runner/drawing/highlights.h"
#include "runner/drawing/lettering.h"
#include "runner/drawing/tree_drawing.h"

namespace trellis::drawing {
namespace {

constexpr std::size_t most_letters = 60;  // of a line

std::string_view look_of(NodeShape shape) {
    switch (shape) {
    case NodeShape::control: return "shape=box, fillcolor=\"#e8f0fe\", color=\"#3b6fd4\"";
    case NodeShape::decorator: return "shape=octagon, fillcolor=\"#f3e9fd\", color=\"#8b4fc6\"";
    case NodeShape::condition: return "shape=ellipse, fillcolor=\"#fff5d9\", color=\"#b98900\"";
    case NodeShape::action: return "shape=box, fillcolor=\"#e7f6ed\", color=\"#2e8b57\"";
    case NodeShape::subtree:
        return "shape=box, peripheries=2, fillcolor=\"#eef1f5\", color=\"#556270\"";
    }
    return {};
}

std::string label_of(const DrawnNode& node, const Highlight& highlight) {
    const auto [title, kind] = title_of(node);
    std::vector<std::string> lines{shortened(
        (node.symbol.empty() ? "" : std::string(node.symbol) + " ") + title, most_letters)};
    if (!kind.empty()) lines.push_back(shortened(kind, most_letters));
    if (!node.code.empty()) lines.push_back(shortened(node.code, most_letters));
    for (const std::vector<std::string>* more : {&node.ports, &node.tags})
        for (const std::string& line : *more)
            lines.push_back(shortened(line, most_letters));
    if (!highlight.note.empty())
        lines.push_back(shortened(visible_line(highlight.note), most_letters));
    return dot_label(lines, 1);
}

std::string indent(std::size_t depth) {
    return std::string(2 * depth, ' ');
}

}  // namespace

std::string tree_dot(const TreeModel& model, const DrawingOptions& options) {
    const Highlights highlights(options.highlights);
    const std::string name = model.trees.empty() ? "" : model.trees.front().id;
    std::string dot = dot_opening(name, std::string("  ordering=out;\n  rankdir=") +
                                            (options.sideways ? "LR" : "TB") + ";\n");
    dot += "  edge [arrowhead=none];\n";
    std::string edges;
    for (std::size_t t = 0; t < model.trees.size(); ++t) {
        const DrawnTree& tree = model.trees[t];
        dot += "  subgraph cluster_t" + std::to_string(t) + " {\n    label=" + dot_string(tree.id) +
               "; color=none;\n";
        std::vector<std::uint32_t> open;  // ends of the clusters around the node
        for (std::uint32_t i = tree.begin; i < tree.end; ++i) {
            const DrawnNode& node = model.nodes[i];
            for (; !open.empty() && open.back() == i; open.pop_back())
                dot += indent(open.size() + 1) + "}\n";
            if (node.opened) {
                open.push_back(node.end);
                dot += indent(open.size() + 1) + "subgraph cluster_n" + std::to_string(i) + " {\n" +
                       indent(open.size() + 2) +
                       "style=\"rounded,dashed\"; color=\"#9aa8ba\"; bgcolor=\"#f3f5f8\"; "
                       "label=\"\";\n";
            }
            const Highlight& highlight = highlights.of(node.element);
            dot += indent(open.size() + 2) + "n" + std::to_string(i) + " [" +
                   std::string(look_of(node.shape)) + ", label=" + label_of(node, highlight) +
                   dot_status(highlight.status) + "];\n";
            if (node.parent)
                edges +=
                    "  n" + std::to_string(node.parent.index) + " -> n" + std::to_string(i) + ";\n";
        }
        for (; !open.empty(); open.pop_back())
            dot += indent(open.size() + 1) + "}\n";
        dot += "  }\n";
    }
    return dot + edges + "}\n";
}

}  // namespace trellis::drawing
