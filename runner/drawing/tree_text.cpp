// Trees for a terminal, with box-drawing characters or in ASCII.
// SPDX-License-Identifier: MIT
#include "runner/drawing/canvas.h"
#include "runner/drawing/highlights.h"
#include "runner/drawing/lettering.h"
#include "runner/drawing/tree_drawing.h"

namespace trellis::drawing {
namespace {

constexpr std::size_t most_letters = 60;  // of a port or tag

/// What stands before a node's line: whether more siblings follow, and the same for those below.
struct Branch {
    std::string_view more_self, more_below;
    std::string_view last_self, last_below;
};
constexpr Branch unicode_branch{"├─ ", "│  ", "└─ ", "   "};
constexpr Branch ascii_branch{"|- ", "|  ", "`- ", "   "};

std::string_view mark_of(const DrawnNode& node, bool ascii) {
    if (!node.symbol.empty()) return ascii ? node.ascii : node.symbol;
    switch (node.shape) {
    case NodeShape::control: return ascii ? "*" : "◆";
    case NodeShape::decorator: return ascii ? "<>" : "◇";
    case NodeShape::condition: return ascii ? "()" : "○";
    case NodeShape::action: return ascii ? "[]" : "□";
    case NodeShape::subtree: return ascii ? "[[]]" : "▣";
    }
    return {};
}

std::string line_of(const DrawnNode& node, const Highlight& highlight, bool ascii) {
    const auto [title, kind] = title_of(node);
    std::string line = std::string(mark_of(node, ascii)) + " " + title;
    if (!kind.empty()) line += " (" + kind + ")";
    if (!node.code.empty()) line += "  " + shortened(node.code, most_letters);
    std::string_view separator = "  ";
    for (const std::string& port : node.ports) {
        line += std::string(separator) + shortened(port, most_letters);
        separator = ", ";
    }
    for (const std::string& tag : node.tags)
        line += "  {" + shortened(tag, most_letters) + "}";
    if (const std::string_view status = status_class(highlight.status); !status.empty())
        line += "  [" + std::string(status) + "]";
    if (!highlight.note.empty()) line += "  " + visible_line(highlight.note);
    return ascii ? ascii_only(line) : line;
}

}  // namespace

std::string tree_text(const TreeModel& model, const DrawingOptions& options) {
    const Highlights highlights(options.highlights);
    const Branch& branch = options.ascii ? ascii_branch : unicode_branch;
    std::string text;
    for (const DrawnTree& tree : model.trees) {
        if (!text.empty()) text += "\n";
        if (!tree.id.empty()) text += (options.ascii ? ascii_only(tree.id) : tree.id) + "\n";
        // ends of the subtrees around the node, and how long the prefix was before each
        struct Around {
            std::uint32_t end;
            std::size_t prefix;
        };
        std::vector<Around> around;
        std::string prefix;
        for (std::uint32_t i = tree.begin; i < tree.end; ++i) {
            const DrawnNode& node = model.nodes[i];
            while (!around.empty() && around.back().end == i) {
                prefix.resize(around.back().prefix);
                around.pop_back();
            }
            const std::size_t before = prefix.size();
            text += prefix;
            if (node.parent) {
                const bool last = node.end == model.nodes[node.parent.index].end;
                text += last ? branch.last_self : branch.more_self;
                prefix += last ? branch.last_below : branch.more_below;
            }
            around.push_back({node.end, before});
            text += line_of(node, highlights.of(node.element), options.ascii) + "\n";
        }
    }
    return text;
}

}  // namespace trellis::drawing
