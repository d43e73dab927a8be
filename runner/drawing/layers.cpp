// First half of the layered layout: which arrows point up, and the layer of each box.
// SPDX-License-Identifier: MIT
#include "runner/drawing/layered.h"

#include <algorithm>
#include <cmath>

namespace trellis::drawing {
namespace {

using Place = LayeredNode::Place;

class Layers {
public:
    explicit Layers(LayeredGraph& graph)
        : graph_(graph), down_(graph.nodes.size()), up_(graph.nodes.size()) {}

    void run() {
        turn_edges();
        sort_nodes();
        drop_nodes();
        for (int i = 0; i < 4; ++i)
            tighten();
        close_gaps();
        if (!graph_.regions) fold_lonely();
        place_last();
    }

private:
    std::uint32_t size() const { return static_cast<std::uint32_t>(graph_.nodes.size()); }
    bool is_free(std::uint32_t n) const { return graph_.nodes[n].place == Place::anywhere; }
    std::uint32_t upper(const LayeredEdge& e) const { return e.upward ? e.to : e.from; }
    std::uint32_t lower(const LayeredEdge& e) const { return e.upward ? e.from : e.to; }

    /// Turns the edges that close a cycle when the graph is walked depth-first in the order of the
    /// nodes: the author's order tells best what is forward.
    void turn_edges() {
        std::vector<std::vector<std::uint32_t>> out(size());
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            LayeredEdge& edge = graph_.edges[e];
            edge.upward = graph_.nodes[edge.to].place == Place::first ||
                          graph_.nodes[edge.from].place == Place::last;
            if (!edge.upward) out[edge.from].push_back(e);
        }
        enum class Visit : std::uint8_t { not_yet, open, done };
        std::vector<Visit> visits(size(), Visit::not_yet);
        std::vector<std::size_t> next(size());
        std::vector<std::uint32_t> stack;
        for (std::uint32_t start = 0; start < size(); ++start) {
            if (visits[start] == Visit::not_yet) stack.push_back(start);
            while (!stack.empty()) {
                const std::uint32_t n = stack.back();
                visits[n] = Visit::open;
                if (next[n] == out[n].size()) {
                    visits[n] = Visit::done;
                    stack.pop_back();
                    continue;
                }
                LayeredEdge& edge = graph_.edges[out[n][next[n]++]];
                if (visits[edge.to] == Visit::open) edge.upward = true;
                if (visits[edge.to] == Visit::not_yet) stack.push_back(edge.to);
            }
        }
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            down_[upper(graph_.edges[e])].push_back(e);
            up_[lower(graph_.edges[e])].push_back(e);
        }
    }

    /// Uppers before lowers.
    void sort_nodes() {
        std::vector<std::size_t> waiting(size());
        for (std::uint32_t n = 0; n < size(); ++n) {
            waiting[n] = up_[n].size();
            if (waiting[n] == 0) sorted_.push_back(n);
        }
        for (std::size_t i = 0; i < sorted_.size(); ++i)
            for (const std::uint32_t e : down_[sorted_[i]])
                if (const std::uint32_t n = lower(graph_.edges[e]); --waiting[n] == 0)
                    sorted_.push_back(n);
    }

    /// Each node as far up as its edges allow.
    void drop_nodes() {
        const auto is_first = [](const LayeredNode& node) {
            return node.place == Place::first || node.place == Place::heading;
        };
        if (std::any_of(graph_.nodes.begin(), graph_.nodes.end(), is_first)) first_free_ = 1;
        for (const std::uint32_t n : sorted_)
            graph_.nodes[n].layer =
                is_first(graph_.nodes[n]) ? 0 : std::max(first_free_, highest(n));
    }

    std::uint32_t highest(std::uint32_t n) const {
        std::uint32_t layer = 0;
        for (const std::uint32_t e : up_[n])
            layer = std::max(layer,
                             graph_.nodes[upper(graph_.edges[e])].layer + graph_.edges[e].length);
        return layer;
    }

    /// Lets nodes with more edges downwards than upwards sink as far as those allow.
    void tighten() {
        for (auto n = sorted_.rbegin(); n != sorted_.rend(); ++n) {
            if (!is_free(*n) || down_[*n].size() <= up_[*n].size()) continue;
            std::uint32_t lowest = 0xFFFFFFFF;
            for (const std::uint32_t e : down_[*n]) {
                const LayeredEdge& edge = graph_.edges[e];
                if (is_free(lower(edge)))
                    lowest = std::min(lowest, graph_.nodes[lower(edge)].layer - edge.length);
            }
            if (lowest != 0xFFFFFFFF) graph_.nodes[*n].layer = lowest;
        }
    }

    /// Moves everything up as far as the edges from the first layer allow: all may have sunk.
    void close_gaps() {
        std::uint32_t gap = 0xFFFFFFFF;
        for (const LayeredNode& node : graph_.nodes)
            if (node.place == Place::anywhere) gap = std::min(gap, node.layer - first_free_);
        for (const LayeredEdge& edge : graph_.edges)
            if (!is_free(upper(edge)) && is_free(lower(edge)))
                gap = std::min(gap, graph_.nodes[lower(edge)].layer - edge.length);
        for (LayeredNode& node : graph_.nodes)
            if (node.place == Place::anywhere) node.layer -= gap;
    }

    /// Boxes without edges: more than a few stand in rows below the others.
    void fold_lonely() {
        std::vector<std::uint32_t> lonely;
        for (std::uint32_t n = 0; n < size(); ++n)
            if (is_free(n) && up_[n].empty() && down_[n].empty()) lonely.push_back(n);
        if (lonely.size() < 5) return;
        const auto row = static_cast<std::size_t>(
            std::ceil(std::sqrt(1.5 * static_cast<double>(lonely.size()))));
        const std::uint32_t first = lonely.size() == size() ? 0 : deepest() + 1;
        for (std::size_t i = 0; i < lonely.size(); ++i)
            graph_.nodes[lonely[i]].layer = first + static_cast<std::uint32_t>(i / row);
    }

    std::uint32_t deepest() const {
        std::uint32_t layer = 0;
        for (const LayeredNode& node : graph_.nodes)
            if (node.place != Place::last) layer = std::max(layer, node.layer);
        return layer;
    }

    /// The last layer lies below everything, far enough for the edges that end there.
    void place_last() {
        std::uint32_t bottom = deepest() + 1;
        for (std::uint32_t n = 0; n < size(); ++n)
            if (graph_.nodes[n].place == Place::last) bottom = std::max(bottom, highest(n));
        for (LayeredNode& node : graph_.nodes)
            if (node.place == Place::last) node.layer = bottom;
    }

    LayeredGraph& graph_;
    std::vector<std::vector<std::uint32_t>> down_, up_;  // edges of each node
    std::vector<std::uint32_t> sorted_;
    std::uint32_t first_free_ = 0;  // layer for boxes that may stand anywhere
};

}  // namespace

void assign_layers(LayeredGraph& graph) {
    Layers(graph).run();
}

std::size_t way_length(const LayeredGraph& graph) {
    std::size_t length = 0;
    for (const LayeredEdge& edge : graph.edges) {
        const std::uint32_t from = graph.nodes[edge.from].layer, to = graph.nodes[edge.to].layer;
        length += from < to ? to - from : from - to;
    }
    return length;
}

}  // namespace trellis::drawing
