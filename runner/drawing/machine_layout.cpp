// One layered graph for each state that holds others. Layers are assigned from the outside in,
// because they tell on which side an arrow crosses a border; places from the inside out, because
// they need the sizes; then everything is moved to where it belongs.
// SPDX-License-Identifier: MIT
#include "runner/drawing/machine_layout.h"

#include "runner/drawing/layered.h"
#include "runner/drawing/machine_cards.h"

#include <algorithm>
#include <unordered_map>

namespace trellis::drawing {
namespace {

constexpr std::size_t most_links = 300'000;  // pieces of arrows in one picture
constexpr double dot_size = 15;
constexpr double circle_size = 26;  // of final states and histories
constexpr double name_gap = 7;      // from a circle to its name
constexpr double least_width = 84;  // of a state
constexpr double title_rule = 7;    // between a title and the lines below it
constexpr double loop_reach = 26;   // of a loop, to the right
constexpr double loop_height = 30;
constexpr double compound_padding = 18;

using Place = LayeredNode::Place;

/// The inside of one state.
struct Group {
    StateIndex state;
    LayeredGraph graph;
    std::vector<StateIndex> children;  // states of the first nodes; then heading and ports
};

/// A part of an arrow inside one group.
struct Part {
    std::uint32_t group;
    std::uint32_t edge;
};

/// Where an arrow crosses the border of a group's state: a node inside and an edge outside.
struct Port {
    Part outside;
    std::uint32_t node;
    bool at_source;  // of the edge outside
};

class Builder {
public:
    Builder(const MachineModel& model, const Highlights& highlights)
        : model_(model), highlights_(highlights), group_of_(model.states.size()),
          node_of_(model.states.size()), loops_(model.states.size()) {
        layout_.boxes.resize(model.states.size());
        layout_.routes.resize(model.transitions.size());
        parts_.resize(model.transitions.size());
        for (const DrawnState& state : model.states)
            layout_.cards.push_back(card_of(state, highlights.of(state.element)));
    }

    std::optional<MachineLayout> run() {
        make_groups();
        for (std::uint32_t t = 0; t < model_.transitions.size(); ++t)
            add_transition(t);
        for (std::uint32_t g = 0; g < groups_.size(); ++g)
            if (!layer(g)) return std::nullopt;
        for (auto g = static_cast<std::uint32_t>(groups_.size()); g-- > 0;)
            arrange_group(g);
        for (std::uint32_t g = 0; g < groups_.size(); ++g)
            place_group(groups_[g]);
        for (std::uint32_t t = 0; t < model_.transitions.size(); ++t)
            route(t);
        return std::move(layout_);
    }

private:
    const DrawnState& state(StateIndex s) const { return model_.states[s.index]; }
    StateIndex parent(StateIndex s) const { return state(s).parent; }
    bool is_inside(StateIndex s, StateIndex around) const {
        return around < s && s.index < state(around).end;
    }
    /// The child of `around` that is or holds `s`.
    StateIndex child_towards(StateIndex s, StateIndex around) const {
        while (parent(s) != around)
            s = parent(s);
        return s;
    }

    void make_groups() {
        for (std::uint32_t i = 0; i < model_.states.size(); ++i) {
            const StateIndex s{i};
            if (!is_compound(model_, s) && i != 0) continue;
            group_of_[i] = static_cast<std::uint32_t>(groups_.size());
            Group& group = groups_.emplace_back();
            group.state = s;
            group.graph.regions = state(s).shape == StateShape::parallel;
            for (StateIndex c{i + 1}; c.index < state(s).end; c = {state(c).end}) {
                node_of_[c.index] = static_cast<std::uint32_t>(group.children.size());
                group.children.push_back(c);
                LayeredNode& node = group.graph.nodes.emplace_back();
                if (state(c).shape == StateShape::initial) node.place = Place::first;
            }
            LayeredNode& heading = group.graph.nodes.emplace_back();
            heading.place = Place::heading;
        }
        ports_.resize(groups_.size());
    }

    /// Adds the part of transition `t` in the innermost state around both ends; those inside
    /// follow when that state's layers are known.
    void add_transition(std::uint32_t t) {
        const auto& [source, target] = ends(t);
        Route& route = layout_.routes[t];
        route.words =
            label_of(model_.transitions[t], highlights_.of(model_.transitions[t].element));
        const Size words = size_of(route.words);
        if (!route.words.empty()) route.label = {0, 0, words.width + 8, words.height + 4};
        if (source == target) {
            route.loop = true;
            loops_[source.index].push_back(t);
            return;
        }
        StateIndex around = source;
        while (!is_inside(target, around) && !(around == target))
            around = parent(around);
        const std::uint32_t g = group_of_[around.index];
        LayeredEdge edge;
        edge.from = around == source ? add_node(g, Place::first)
                                     : node_of_[child_towards(source, around).index];
        edge.to = around == target ? add_node(g, Place::last)
                                   : node_of_[child_towards(target, around).index];
        edge.label = {route.label.width, route.label.height};
        edge.length = state(source).shape == StateShape::initial && route.words.empty() ? 1 : 2;
        add_edge(t, g, edge);
    }

    struct Ends {
        StateIndex source, target;
    };
    Ends ends(std::uint32_t t) const {
        return {model_.transitions[t].source, model_.transitions[t].target};
    }

    std::uint32_t add_node(std::uint32_t g, Place place) {
        LayeredNode& node = groups_[g].graph.nodes.emplace_back();
        node.place = place;
        node.point = true;
        node.width = 1;
        return static_cast<std::uint32_t>(groups_[g].graph.nodes.size() - 1);
    }

    void add_edge(std::uint32_t t, std::uint32_t g, const LayeredEdge& edge) {
        auto& edges = groups_[g].graph.edges;
        parts_[t].push_back({g, static_cast<std::uint32_t>(edges.size())});
        transitions_of_.resize(groups_.size());
        transitions_of_[g].push_back(t);
        edges.push_back(edge);
    }

    /// Assigns the layers of a group and continues its edges inside its children; false if there is
    /// too much to draw.
    bool layer(std::uint32_t g) {
        assign_layers(groups_[g].graph);
        links_ += way_length(groups_[g].graph);
        if (links_ > most_links) return false;
        transitions_of_.resize(groups_.size());
        for (std::uint32_t e = 0; e < groups_[g].graph.edges.size(); ++e) {
            const auto [source, target] = ends(transitions_of_[g][e]);
            const LayeredEdge edge = groups_[g].graph.edges[e];
            continue_inside({g, e}, edge.from, source, true, edge.upward);
            continue_inside({g, e}, edge.to, target, false, !edge.upward);
        }
        return true;
    }

    /// The part inside the child at `node`, if the end of the arrow lies inside it. `above`: the
    /// edge outside meets the child's upper side.
    void continue_inside(Part outside, std::uint32_t node, StateIndex end, bool at_source,
                         bool above) {
        const Group& group = groups_[outside.group];
        if (node >= group.children.size() || group.children[node] == end) return;
        const std::uint32_t inner = group_of_[group.children[node].index];
        const std::uint32_t port = add_node(inner, above ? Place::first : Place::last);
        const std::uint32_t next = node_of_[child_towards(end, group.children[node]).index];
        LayeredEdge edge;
        edge.from = at_source ? next : port;
        edge.to = at_source ? port : next;
        edge.length = 1;
        ports_[inner].push_back({outside, port, at_source});
        add_edge(transitions_of_[outside.group][outside.edge], inner, edge);
    }

    void arrange_group(std::uint32_t g) {
        Group& group = groups_[g];
        for (std::size_t n = 0; n < group.children.size(); ++n)
            set_size(group.graph.nodes[n], group.children[n]);
        LayeredNode& heading = group.graph.nodes[group.children.size()];
        const StateCard& card = layout_.cards[group.state.index];
        heading.width = card.size.width;
        heading.height = card.size.height;
        arrange(group.graph);
        Size& size = sizes_[group.state.index];
        size = {group.graph.size.width + 2 * compound_padding,
                group.graph.size.height + state_padding + compound_padding};
        for (const Port& port : ports_[g]) {
            LayeredEdge& edge = groups_[port.outside.group].graph.edges[port.outside.edge];
            const double x = group.graph.nodes[port.node].at.x + 0.5 + compound_padding;
            (port.at_source ? edge.from_x : edge.to_x) = x;
        }
    }

    /// The box of a state, with room for its loops.
    void set_size(LayeredNode& node, StateIndex s) const {
        const StateCard& card = layout_.cards[s.index];
        const double name =
            card.title.empty() ? 0 : name_gap + text_width(card.title, Lettering::title);
        switch (state(s).shape) {
        case StateShape::initial: node.width = node.height = dot_size; break;
        case StateShape::final_state:
        case StateShape::shallow_history:
        case StateShape::deep_history:
            node.width = node.height = circle_size;
            node.room = std::max(name, card.lines.empty() ? 0 : name_gap + card.size.width);
            break;
        case StateShape::machine:
        case StateShape::state:
        case StateShape::parallel:
            if (const auto size = sizes_.find(s.index); size != sizes_.end()) {
                node.width = size->second.width;
                node.height = size->second.height;
            } else {
                node.width = std::max(least_width, card.size.width + 2 * state_padding);
                node.height = card.size.height + 2 * state_padding -
                              (card.lines.empty() ? 4 : 6 - title_rule);
            }
        }
        node.point = node.width == node.height && node.width <= circle_size;
        double height = 0;
        for (const std::uint32_t t : loops_[s.index]) {
            const Box& label = layout_.routes[t].label;
            node.room = std::max(node.room, loop_reach + 6 + label.width);
            height += std::max(loop_height, label.height + 6);
        }
        node.height = std::max(node.height, height + (height > 0 ? 8 : 0));
    }

    /// Moves the children of a group to their places in the whole picture; the group's own box is
    /// known.
    void place_group(const Group& group) {
        Box& around = layout_.boxes[group.state.index];
        if (group.state.index == 0) {
            const Size size = sizes_.at(0);
            around = {0, 0, size.width, size.height};
        }
        const Point origin = origin_of(group);
        std::uint32_t layers = 0;
        for (std::size_t n = 0; n < group.children.size(); ++n) {
            const LayeredNode& node = group.graph.nodes[n];
            layout_.boxes[group.children[n].index] = {origin.x + node.at.x, origin.y + node.at.y,
                                                      node.width, node.height};
            place_loops(group.children[n]);
            layers = std::max(layers, node.layer);
        }
        if (group.graph.regions) separate_regions(group);
    }

    Point origin_of(const Group& group) const {
        const Box& box = layout_.boxes[group.state.index];
        return {box.x + compound_padding, box.y + state_padding};
    }

    /// Lines between regions that stand in one row, which they do unless arrows join them.
    void separate_regions(const Group& group) {
        std::vector<Box> boxes;
        for (std::size_t n = 0; n < group.children.size(); ++n) {
            if (group.graph.nodes[n].layer != group.graph.nodes[0].layer) return;
            Box box = layout_.boxes[group.children[n].index];
            box.width += group.graph.nodes[n].room;
            boxes.push_back(box);
        }
        std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.x < b.x; });
        for (std::size_t i = 1; i < boxes.size(); ++i) {
            layout_.separators.push_back((boxes[i - 1].right() + boxes[i].x) / 2);
            layout_.separated.push_back(group.state);
        }
    }

    void place_loops(StateIndex s) {
        const Box& box = layout_.boxes[s.index];
        double height = 0;
        for (const std::uint32_t t : loops_[s.index])
            height += std::max(loop_height, layout_.routes[t].label.height + 6);
        double y = box.centre() - height / 2;
        for (const std::uint32_t t : loops_[s.index]) {
            Route& route = layout_.routes[t];
            const double own = std::max(loop_height, route.label.height + 6);
            const double middle = y + own / 2;
            route.path = {{box.right(), middle - 8}, {box.right(), middle + 8}};
            route.label.x = box.right() + loop_reach;
            route.label.y = middle - route.label.height / 2;
            y += own;
        }
    }

    /// Joins the parts of an arrow from its source to its target. The first part is the outermost;
    /// those inside the source follow inwards, then those inside the target.
    void route(std::uint32_t t) {
        Route& route = layout_.routes[t];
        if (route.loop) return;
        std::vector<Part> inwards, outwards;
        const auto add = [&](Point p) {
            if (route.path.empty() || route.path.back().x != p.x || route.path.back().y != p.y)
                route.path.push_back(p);
        };
        for (const Part& part : parts_[t])
            (is_in_source(part, t) ? inwards : outwards).push_back(part);
        std::reverse(inwards.begin(), inwards.end());
        for (const std::vector<Part>* parts : {&inwards, &outwards}) {
            for (const Part& part : *parts) {
                const Group& group = groups_[part.group];
                const LayeredEdge& edge = group.graph.edges[part.edge];
                const Point origin = origin_of(group);
                if (const auto port = port_at(group, edge.from)) add(*port);
                for (const Point& p : edge.path)
                    add({origin.x + p.x, origin.y + p.y});
                if (const auto port = port_at(group, edge.to)) add(*port);
                if (part.group != parts_[t].front().group) continue;
                route.back = edge.upward;
                route.label.x = origin.x + edge.label_at.x - route.label.width / 2;
                route.label.y = origin.y + edge.label_at.y - route.label.height / 2;
            }
        }
    }

    bool is_in_source(const Part& part, std::uint32_t t) const {
        const StateIndex around = groups_[part.group].state;
        const auto [source, target] = ends(t);
        return part.group != parts_[t].front().group && is_inside(source, around) &&
               !is_inside(target, around);
    }

    /// Where a node that is a port crosses the border of the group's state.
    std::optional<Point> port_at(const Group& group, std::uint32_t n) const {
        if (n <= group.children.size()) return std::nullopt;
        const Box& box = layout_.boxes[group.state.index];
        const LayeredNode& node = group.graph.nodes[n];
        return Point{origin_of(group).x + node.at.x + 0.5,
                     node.place == Place::first ? box.y : box.bottom()};
    }

    const MachineModel& model_;
    const Highlights& highlights_;
    MachineLayout layout_;
    std::vector<Group> groups_;                               // parents before children
    std::vector<std::uint32_t> group_of_;                     // of compound states
    std::vector<std::uint32_t> node_of_;                      // of states in their parent's group
    std::vector<std::vector<std::uint32_t>> loops_;           // of each state
    std::vector<std::vector<Part>> parts_;                    // of each transition
    std::vector<std::vector<std::uint32_t>> transitions_of_;  // of each group's edges
    std::vector<std::vector<Port>> ports_;                    // of each group
    std::unordered_map<std::uint32_t, Size> sizes_;           // of compound states
    std::size_t links_ = 0;
};

}  // namespace

bool is_compound(const MachineModel& model, StateIndex state) {
    return state.index + 1 < model.states[state.index].end;
}

std::optional<MachineLayout> machine_layout(const MachineModel& model,
                                            const Highlights& highlights) {
    return Builder(model, highlights).run();
}

}  // namespace trellis::drawing
