// From elements to drawn nodes: what each is called, looks like and says.
// SPDX-License-Identifier: MIT
#include "runner/drawing/tree_model.h"

#include "core/leaf.h"
#include "runner/drawing/lettering.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace trellis::drawing {
namespace {

constexpr std::uint32_t deepest = 256;  // nodes below each other, opened trees included

struct Look {
    std::string_view element;
    NodeShape shape;
    std::string_view symbol;
    std::string_view ascii;
    std::string_view main_port;
};

#define LOOK(element, shape, symbol, ascii, main_port)                                             \
    Look{element, NodeShape::shape, symbol, ascii, main_port},
constexpr std::array looks{
#include "runner/drawing/node_looks.def"
};

struct Tag {
    std::string_view attribute;
    std::string_view words;
};

constexpr std::array tags{
    Tag{"_failureIf", "fail if"},    Tag{"_successIf", "succeed if"},
    Tag{"_skipIf", "skip if"},       Tag{"_while", "while"},
    Tag{"_onSuccess", "on success"}, Tag{"_onFailure", "on failure"},
    Tag{"_onHalted", "when halted"}, Tag{"_post", "at the end"},
};

// said elsewhere in the picture, or for editors only
constexpr std::array<std::string_view, 6> unshown{"name", "ID",        "_description",
                                                  "_uid", "_fullpath", "_favorite"};

template <class Table, class Member>
auto find_in(const Table& table, Member member, std::string_view name)
    -> decltype(&*table.begin()) {
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const auto& row) { return row.*member == name; });
    return found == table.end() ? nullptr : &*found;
}

class ModelBuilder {
public:
    ModelBuilder(const Document& document, const DrawingOptions& options)
        : document_(document), options_(options) {
        for (const ElementId e : document.children(document.root())) {
            if (document.name(e) == "BehaviorTree") trees_.emplace(document.value(e, "ID"), e);
            if (document.name(e) == "TreeNodesModel") read_palette(e);
        }
    }

    TreeModel build() {
        std::string_view main = options_.main_tree;
        if (main.empty()) main = document_.value(document_.root(), "main_tree_to_execute");
        if (const auto found = trees_.find(main); found != trees_.end()) draw_tree(found->second);
        // the roots among the others before those that only others use, each in written order
        std::set<std::string_view> used;
        for (std::uint32_t i = 0; i < document_.elements.size(); ++i)
            if (document_.name({i}) == "SubTree") used.insert(document_.value({i}, "ID"));
        for (const bool reached : {false, true}) {
            for (const ElementId e : document_.children(document_.root())) {
                if (document_.name(e) != "BehaviorTree" || drawn_.contains(e.index)) continue;
                if (used.contains(document_.value(e, "ID")) == reached) draw_tree(e);
            }
        }
        return std::move(model_);
    }

private:
    void read_palette(ElementId models) {
        for (const ElementId e : document_.children(models))
            if (document_.name(e) == "Condition") conditions_.insert(document_.value(e, "ID"));
    }

    void draw_tree(ElementId tree) {
        DrawnTree& drawn = model_.trees.emplace_back();
        drawn.id = visible_line(document_.value(tree, "ID"));
        drawn.begin = size();
        drawn_.insert(tree.index);
        add_children(tree);
        drawn.end = size();
    }

    std::uint32_t size() const { return static_cast<std::uint32_t>(model_.nodes.size()); }

    /// A part of the document whose nodes are being added: [next, end) of its elements.
    struct Level {
        ElementId next;
        ElementId end;
        NodeIndex parent;  ///< of its nodes
    };

    /// All nodes inside a <BehaviorTree>, and those of the trees that open there. A stack instead
    /// of recursion: trees that open inside trees nest deeper than elements do.
    void add_children(ElementId tree) {
        std::vector<Level> stack{{{tree.index + 1}, document_.at(tree).end, {}}};
        while (!stack.empty()) {
            Level& level = stack.back();
            if (level.next == level.end) {
                if (level.parent) model_.nodes[level.parent.index].end = size();
                stack.pop_back();
                continue;
            }
            const ElementId e = level.next;
            level.next = document_.at(e).end;
            const NodeIndex node{size()};
            model_.nodes.push_back(node_of(e, level.parent));
            const ElementId opened = stack.size() < deepest ? opened_by(e) : ElementId{};
            model_.nodes.back().opened = static_cast<bool>(opened);
            const ElementId inside = opened ? opened : e;
            stack.push_back({{inside.index + 1}, document_.at(inside).end, node});
        }
    }

    /// The tree that the SubTree `e` shows, if it has not been drawn yet; from now on it has.
    ElementId opened_by(ElementId e) {
        if (document_.name(e) != "SubTree") return {};
        const auto found = trees_.find(document_.value(e, "ID"));
        if (found == trees_.end() || !drawn_.insert(found->second.index).second) return {};
        return found->second;
    }

    DrawnNode node_of(ElementId e, NodeIndex parent) const {
        const std::string_view element = document_.name(e);
        const bool long_form = element == "Action" || element == "Condition" ||
                               element == "Control" || element == "Decorator";
        const std::string_view type =
            long_form || element == "SubTree" ? document_.value(e, "ID") : element;
        const Look* look = find_in(looks, &Look::element, element == "SubTree" ? element : type);

        DrawnNode node;
        node.element = e;
        node.parent = parent;
        node.shape = look ? look->shape : shape_of(e, element, type);
        if (look) node.symbol = look->symbol;
        if (look) node.ascii = look->ascii;
        node.type = visible_line(type);
        node.name = visible_line(document_.value(e, "name"));
        if (node.name == node.type) node.name.clear();
        for (const Attribute& a : document_.attributes_of(e))
            add_attribute(node, a, look ? look->main_port : "");
        return node;
    }

    NodeShape shape_of(ElementId e, std::string_view element, std::string_view type) const {
        if (element == "Condition") return NodeShape::condition;
        if (element == "Control") return NodeShape::control;
        if (element == "Decorator") return NodeShape::decorator;
        const std::size_t children = document_.child_count(e);
        if (children > 0) return children == 1 ? NodeShape::decorator : NodeShape::control;
        const LeafType* leaf = options_.registry ? options_.registry->find(type) : nullptr;
        const bool condition = leaf ? leaf->condition : conditions_.contains(type);
        return condition ? NodeShape::condition : NodeShape::action;
    }

    void add_attribute(DrawnNode& node, const Attribute& a, std::string_view main_port) const {
        const std::string_view name = document_.string(a.name);
        const std::string value = visible_line(document_.string(a.value));
        if (const Tag* tag = find_in(tags, &Tag::attribute, name)) {
            node.tags.push_back(std::string(tag->words) + " " + value);
        } else if (name == main_port) {
            node.code = value;
        } else if (std::find(unshown.begin(), unshown.end(), name) == unshown.end()) {
            node.ports.push_back(visible_line(name) + " = " + value);
        }
    }

    const Document& document_;
    const DrawingOptions& options_;
    std::map<std::string_view, ElementId> trees_;  // by ID, the first of each
    std::set<std::string_view> conditions_;        // of the palette
    std::set<std::uint32_t> drawn_;                // <BehaviorTree> elements
    TreeModel model_;
};

}  // namespace

TreeModel tree_model(const Document& document, const DrawingOptions& options) {
    return ModelBuilder(document, options).build();
}

}  // namespace trellis::drawing
