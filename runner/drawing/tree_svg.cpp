// Nodes as cards in the shapes that the literature gives them, joined by elbows.
// SPDX-License-Identifier: MIT
#include "runner/drawing/canvas.h"
#include "runner/drawing/highlights.h"
#include "runner/drawing/tidy_layout.h"
#include "runner/drawing/tree_drawing.h"

#include <algorithm>
#include <cmath>

namespace trellis::drawing {
namespace {

constexpr std::size_t most_letters = 38;  // of a line
constexpr std::size_t most_ports = 5;
constexpr double padding_x = 13, padding_y = 8;  // inside a card
constexpr double symbol_gap = 7;
constexpr double least_width = 56;
constexpr double cut = 9;              // of a decorator's corners
constexpr double double_border = 3.5;  // between the two of a SubTree
constexpr double tree_gap = 44;        // between separate trees

/// The words of a node and the box they need.
struct Card {
    std::string symbol;
    std::string title;
    std::vector<TextLine> kind;   // below the title, in the middle like it
    std::vector<TextLine> lines;  // below that, beginning at one edge
    bool cut = false;             // something is missing
    Size text;
    Size size;

    double title_width() const {
        const double name = text_width(title, Lettering::title);
        return symbol.empty() ? name : name + symbol_gap + text_width(symbol, Lettering::symbol);
    }
    double title_height() const {
        return line_height(symbol.empty() ? Lettering::title : Lettering::symbol);
    }
};

/// Adds `text` in at most `most_lines` lines.
void add_text(Card& card, std::string_view text, std::size_t most_lines, Lettering lettering) {
    for (std::string& line : wrapped(text, most_letters, most_lines)) {
        card.cut = card.cut || line.ends_with("…");
        card.lines.push_back({std::move(line), lettering});
    }
}

void add_words(Card& card, const DrawnNode& node, const Highlight& highlight) {
    const auto [title, kind] = title_of(node);
    card.symbol = node.symbol;
    card.title = shortened(title, most_letters);
    if (!kind.empty()) card.kind.push_back({shortened(kind, most_letters), Lettering::kind});
    card.cut = card.title != title || (!kind.empty() && card.kind.front().text != kind);
    if (!node.code.empty()) add_text(card, node.code, 3, Lettering::detail);
    const std::size_t shown = node.ports.size() > most_ports + 1 ? most_ports : node.ports.size();
    for (std::size_t i = 0; i < shown; ++i)
        add_text(card, node.ports[i], 1, Lettering::detail);
    if (shown < node.ports.size())
        add_text(card, std::to_string(node.ports.size() - shown) + " more …", 1, Lettering::detail);
    for (const std::string& tag : node.tags)
        add_text(card, tag, 2, Lettering::tag);
    if (!highlight.note.empty()) add_text(card, visible_line(highlight.note), 2, Lettering::tag);
}

Card card_of(const DrawnNode& node, const Highlight& highlight) {
    Card card;
    add_words(card, node, highlight);
    const Size kind = size_of(card.kind), lines = size_of(card.lines);
    card.text = {std::max({card.title_width(), kind.width, lines.width}),
                 card.title_height() + kind.height + lines.height};
    card.size = {std::max(card.text.width + 2 * padding_x, least_width),
                 card.text.height + 2 * padding_y};
    if (node.shape == NodeShape::condition) {
        // the ellipse through the corners of the text that is 1.55 times as high as it
        constexpr double stretch = 1.55;
        card.size = {(card.text.width + 6) / std::sqrt(1 - 1 / (stretch * stretch)) + 6,
                     card.text.height * stretch + 4};
    }
    if (node.shape == NodeShape::decorator) card.size.width += cut;
    if (node.shape == NodeShape::subtree) card.size.width += 2 * double_border;
    return card;
}

std::string tooltip_of(const Document& document, const DrawnNode& node, const Card& card) {
    std::string tooltip;
    if (card.cut) {
        const auto [title, kind] = title_of(node);
        tooltip = title + (kind.empty() ? "" : "\n" + kind);
        if (!node.code.empty()) tooltip += "\n" + node.code;
        for (const std::vector<std::string>* lines : {&node.ports, &node.tags})
            for (const std::string& line : *lines)
                tooltip += "\n" + line;
    }
    if (const std::string_view doc = document.doc(node.element); !doc.empty())
        tooltip += (tooltip.empty() ? "" : "\n\n") + std::string(doc);
    return tooltip;
}

void draw_shape(Canvas& canvas, NodeShape shape, const Box& box, const std::string& status) {
    switch (shape) {
    case NodeShape::control: canvas.box(box, 4, "shape control" + status); break;
    case NodeShape::decorator: canvas.octagon(box, cut, "shape decorator" + status); break;
    case NodeShape::condition: canvas.ellipse(box, "shape condition" + status); break;
    case NodeShape::action: canvas.box(box, 4, "shape action" + status); break;
    case NodeShape::subtree:
        canvas.box(box, 5, "shape subtree" + status);
        canvas.box(box.grown(-double_border), 3, "shape subtree" + status);
        break;
    }
}

void draw_node(Canvas& canvas, const DrawnNode& node, const Card& card, const Box& box,
               const Highlight& highlight, const std::string& tooltip) {
    const std::string_view status = status_class(highlight.status);
    canvas.open("", tooltip);
    draw_shape(canvas, node.shape, box, status.empty() ? "" : " " + std::string(status));
    double y = box.centre() - card.text.height / 2;
    double x = box.middle() - card.title_width() / 2;
    if (!card.symbol.empty()) {
        canvas.lines(x, y, {{card.symbol, Lettering::symbol}});
        x += text_width(card.symbol, Lettering::symbol) + symbol_gap;
    }
    const double inset = (card.title_height() - line_height(Lettering::title)) / 2;
    canvas.lines(x, y + inset, {{card.title, Lettering::title}});
    y = canvas.lines(box.middle(), y + card.title_height(), card.kind, Anchor::middle);
    if (node.shape == NodeShape::condition)
        canvas.lines(box.middle(), y, card.lines, Anchor::middle);
    else
        canvas.lines(box.middle() - size_of(card.lines).width / 2, y, card.lines);
    canvas.close();
}

/// From the parent's side to the child's, over a corner in the middle between them.
std::string elbow(Point from, Point to, bool sideways) {
    const auto turned = [&](double along, double across) {
        return coordinates(sideways ? Point{along, across} : Point{across, along});
    };
    const double from_along = sideways ? from.x : from.y, from_across = sideways ? from.y : from.x;
    const double to_along = sideways ? to.x : to.y, to_across = sideways ? to.y : to.x;
    const double middle = (from_along + to_along) / 2;
    const double width = to_across - from_across;
    std::string data = "M" + coordinates(from);
    if (std::abs(width) >= 1) {
        const double radius = std::min({8.0, std::abs(width) / 2, (to_along - from_along) / 2});
        const double side = width < 0 ? -radius : radius;
        data += "L" + turned(middle - radius, from_across) + "Q" + turned(middle, from_across) +
                " " + turned(middle, from_across + side) + "L" + turned(middle, to_across - side) +
                "Q" + turned(middle, to_across) + " " + turned(middle + radius, to_across);
        return data + "L" + coordinates(to);
    }
    return data + "L" + turned(to_along, from_across);
}

/// One tree and the place for it.
class TreePicture {
public:
    TreePicture(const Document& document, const TreeModel& model, const DrawnTree& tree,
                const DrawingOptions& options, const Highlights& highlights)
        : document_(document), model_(model), tree_(tree), sideways_(options.sideways),
          highlights_(highlights) {
        std::vector<TidyNode> nodes;
        nodes.reserve(tree.end - tree.begin);
        cards_.reserve(tree.end - tree.begin);
        for (std::uint32_t i = tree.begin; i < tree.end; ++i) {
            const DrawnNode& node = model.nodes[i];
            const Card& card = cards_.emplace_back(card_of(node, highlights.of(node.element)));
            const Size size = turned(card.size);
            nodes.push_back({node.parent ? node.parent.index - tree.begin : TidyNode::no_parent,
                             node.end - tree.begin, size.width, size.height, node.opened});
        }
        layout_ = tidy_layout(nodes, sideways_ ? TidyGaps{14, 52, 10} : TidyGaps{20, 38, 11});
    }

    Size size() const { return turned(layout_.size); }

    void draw(Canvas& canvas, double y) const {
        for (const Box& frame : layout_.frames)
            canvas.box(placed(frame, y), 10, "frame");
        for (std::uint32_t i = tree_.begin; i < tree_.end; ++i) {
            const DrawnNode& node = model_.nodes[i];
            if (node.parent) draw_edge(canvas, node, box_of(node.parent.index, y), box_of(i, y));
        }
        for (std::uint32_t i = tree_.begin; i < tree_.end; ++i) {
            const DrawnNode& node = model_.nodes[i];
            const Card& card = cards_[i - tree_.begin];
            draw_node(canvas, node, card, box_of(i, y), highlights_.of(node.element),
                      tooltip_of(document_, node, card));
        }
    }

private:
    Size turned(Size size) const { return sideways_ ? Size{size.height, size.width} : size; }

    Box placed(Box box, double y) const {
        if (sideways_) box = {box.y, box.x, box.height, box.width};
        box.y += y;
        return box;
    }

    Box box_of(std::uint32_t node, double y) const {
        return placed(layout_.boxes[node - tree_.begin], y);
    }

    void draw_edge(Canvas& canvas, const DrawnNode& child, const Box& from, const Box& to) const {
        const std::string_view status = status_class(highlights_.of(child.element).status);
        const Point start =
            sideways_ ? Point{from.right(), from.centre()} : Point{from.middle(), from.bottom()};
        const Point end = sideways_ ? Point{to.x, to.centre()} : Point{to.middle(), to.y};
        canvas.path(elbow(start, end, sideways_), "line " + std::string(status));
    }

    const Document& document_;
    const TreeModel& model_;
    const DrawnTree& tree_;
    bool sideways_;
    const Highlights& highlights_;
    std::vector<Card> cards_;
    TidyLayout layout_;
};

}  // namespace

NodeTitle title_of(const DrawnNode& node) {
    if (node.shape != NodeShape::subtree)
        return node.name.empty() ? NodeTitle{node.type, ""} : NodeTitle{node.name, node.type};
    return node.name.empty() ? NodeTitle{node.type, "SubTree"}
                             : NodeTitle{node.name, "SubTree " + node.type};
}

std::string tree_svg(const Document& document, const TreeModel& model,
                     const DrawingOptions& options) {
    const Highlights highlights(options.highlights);
    Canvas canvas;
    Size whole;
    std::string description;
    for (const DrawnTree& tree : model.trees) {
        if (whole.height > 0) whole.height += tree_gap;
        if (!tree.id.empty()) {
            const std::vector<TextLine> heading{
                {shortened(tree.id, 2 * most_letters), Lettering::heading}};
            whole.width = std::max(whole.width, size_of(heading).width);
            whole.height = canvas.lines(0, whole.height, heading) + 10;
        }
        const TreePicture picture(document, model, tree, options, highlights);
        picture.draw(canvas, whole.height);
        whole.width = std::max(whole.width, picture.size().width);
        whole.height += picture.size().height;
        description += (description.empty() ? "" : "; ") + (tree.id.empty() ? "a tree" : tree.id) +
                       " of " + std::to_string(tree.end - tree.begin) + " nodes";
    }
    const std::string title = model.trees.empty() || model.trees.front().id.empty()
                                  ? "behaviour tree"
                                  : "behaviour tree " + model.trees.front().id;
    return canvas.finish(whole, title, description);
}

}  // namespace trellis::drawing
