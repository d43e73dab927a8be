// Second half of the layered layout: from layers to places and paths.
// SPDX-License-Identifier: MIT
#include "runner/drawing/layered.h"

#include "runner/drawing/layered_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trellis::drawing {
namespace {

constexpr double layer_gap = 24;
constexpr double most_extra_gap = 56;  // where lines run far to the side
constexpr double end_gap = 22;         // between two arrows on one side of a box
constexpr double corner = 12;          // of a box, where no arrow ends

class Arrangement {
public:
    explicit Arrangement(LayeredGraph& graph) : graph_(graph), mesh_(mesh_of(graph)) {}

    void run() {
        order_layers(mesh_);
        spread_layers(mesh_);
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) {
            meet(n, mesh_.above.of(n), &Link::upper, &Link::lower_x);
            meet(n, mesh_.below.of(n), &Link::lower, &Link::upper_x);
        }
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e)
            aim(e);
        move_to_origin();
        stack_layers();
        for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
            LayeredNode& node = graph_.nodes[n];
            node.at = {mesh_.vertices[n].x - node.width / 2, top_of(n)};
        }
        for (std::size_t e = 0; e < graph_.edges.size(); ++e)
            route(e);
    }

private:
    void move_to_origin() {
        double least = 0, most = 0;
        bool any = false;
        for (const Vertex& vertex : mesh_.vertices) {
            least = any ? std::min(least, vertex.x - vertex.left) : vertex.x - vertex.left;
            most = any ? std::max(most, vertex.x + vertex.right) : vertex.x + vertex.right;
            any = true;
        }
        for (Vertex& vertex : mesh_.vertices)
            vertex.x -= least;
        graph_.size.width = most - least;
    }

    /// Chooses where the links on one side of node `n` meet it: straight on if possible, apart,
    /// and where their edges say if they say.
    void meet(std::uint32_t n, LinkLists::Range links, std::uint32_t Link::*other,
              double Link::*end) {
        const LayeredNode& node = graph_.nodes[n];
        if (links.empty() || node.point) return;
        const double half = node.width / 2;
        const double reach = std::max(0.0, half - corner);
        struct End {
            std::uint32_t link;
            double x;  // where it would like to meet, from the middle
            bool fixed;
        };
        std::vector<End> ends;
        for (const std::uint32_t i : links) {
            Link& link = mesh_.links[i];
            const bool fixed = is_fixed(i, n);
            const double there = mesh_.vertices[link.*other].x - mesh_.vertices[n].x;
            ends.push_back({i, fixed ? link.*end : there, fixed});
        }
        std::stable_sort(ends.begin(), ends.end(),
                         [](const End& a, const End& b) { return a.x < b.x; });
        const double gap = std::min(
            end_gap, ends.size() > 1 ? 2 * reach / static_cast<double>(ends.size() - 1) : end_gap);
        std::vector<Wish> wishes;
        for (const End& e : ends) {
            const double x = e.fixed ? e.x : std::clamp(e.x, -reach, reach);
            wishes.push_back({x, wishes.empty() ? 0 : gap, e.fixed ? 1e6 : 1});
        }
        const std::vector<double> places = granted(wishes, -reach, reach);
        for (std::size_t i = 0; i < ends.size(); ++i)
            mesh_.links[ends[i].link].*end = ends[i].fixed ? ends[i].x : places[i];
    }

    /// Whether the edge of the link says where it meets node `n`.
    bool is_fixed(std::uint32_t link, std::uint32_t n) const {
        const auto edge = std::upper_bound(mesh_.first_link.begin(), mesh_.first_link.end(), link) -
                          mesh_.first_link.begin() - 1;
        const LayeredEdge& e = graph_.edges[static_cast<std::size_t>(edge)];
        return (e.from == n ? e.from_x : e.to_x).has_value();
    }

    /// Moves a vertical edge by the little that makes it meet one of its boxes without a bend.
    void aim(std::uint32_t e) {
        constexpr double little = 14;
        const std::uint32_t first = mesh_.first_link[e], last = mesh_.first_link[e + 1] - 1;
        if (first == last) return;
        Room room{-std::numeric_limits<double>::infinity(),
                  std::numeric_limits<double>::infinity()};
        const double x = mesh_.vertices[mesh_.links[first].lower].x;
        for (std::uint32_t i = first; i < last; ++i) {
            const std::uint32_t v = mesh_.links[i].lower;
            if (mesh_.vertices[v].x != x) return;
            const Room own = room_of(mesh_, v);
            room = {std::max(room.least, own.least), std::min(room.most, own.most)};
        }
        for (const double end : {x_of(mesh_.links[first].upper, mesh_.links[first].upper_x),
                                 x_of(mesh_.links[last].lower, mesh_.links[last].lower_x)}) {
            if (std::abs(end - x) > little || end < room.least || end > room.most) continue;
            for (std::uint32_t i = first; i < last; ++i)
                mesh_.vertices[mesh_.links[i].lower].x = end;
            return;
        }
    }

    /// Heights of the layers and of the gaps between them: more where lines run far sideways.
    void stack_layers() {
        std::vector<double> sideways(mesh_.layers.size());
        for (const Link& link : mesh_.links) {
            double& most = sideways[mesh_.vertices[link.upper].layer];
            most = std::max(
                most, std::abs(x_of(link.upper, link.upper_x) - x_of(link.lower, link.lower_x)));
        }
        double y = 0;
        for (std::size_t i = 0; i < mesh_.layers.size(); ++i) {
            double height = 0;
            for (const std::uint32_t v : mesh_.layers[i])
                height = std::max(height, mesh_.vertices[v].height);
            tops_.push_back(y);
            heights_.push_back(height);
            y += height;
            if (i + 1 < mesh_.layers.size())
                y += layer_gap * (height > 0 ? 1 : 0.5) +
                     std::min(most_extra_gap, sideways[i] * 0.09);
        }
        graph_.size.height = y;
    }

    double x_of(std::uint32_t vertex, double shift) const {
        return mesh_.vertices[vertex].x + shift;
    }

    double top_of(std::size_t n) const {
        const LayeredNode& node = graph_.nodes[n];
        const double top = tops_[node.layer];
        const bool high =
            graph_.regions || node.height == 0 || node.place == LayeredNode::Place::heading;
        return high ? top : top + (heights_[node.layer] - node.height) / 2;
    }

    /// The path of edge `e`, from its upper end down, then turned round if it points up.
    void route(std::size_t e) {
        LayeredEdge& edge = graph_.edges[e];
        const std::uint32_t first = mesh_.first_link[e], last = mesh_.first_link[e + 1] - 1;
        const std::uint32_t upper = mesh_.links[first].upper, lower = mesh_.links[last].lower;
        std::vector<Point> path;
        const auto add = [&](double x, double y) {
            // a point inside a vertical piece says nothing
            const std::size_t n = path.size();
            if (n > 1 && path[n - 1].x == x && path[n - 2].x == x) path.pop_back();
            path.push_back({x, y});
        };
        add(x_of(upper, mesh_.links[first].upper_x), top_of(upper) + graph_.nodes[upper].height);
        const std::uint32_t label_layer =
            (graph_.nodes[upper].layer + graph_.nodes[lower].layer) / 2;
        for (std::uint32_t i = first; i <= last; ++i) {
            const Link& link = mesh_.links[i];
            const std::uint32_t layer = mesh_.vertices[link.upper].layer;
            add(x_of(link.upper, link.upper_x), tops_[layer] + heights_[layer]);
            add(x_of(link.lower, link.lower_x), tops_[layer + 1]);
            if (layer + 1 == label_layer)
                edge.label_at = {x_of(link.lower, 0), tops_[layer + 1] + heights_[layer + 1] / 2};
        }
        add(x_of(lower, mesh_.links[last].lower_x), top_of(lower));
        if (edge.upward) std::reverse(path.begin(), path.end());
        edge.path = std::move(path);
    }

    LayeredGraph& graph_;
    Mesh mesh_;
    std::vector<double> tops_, heights_;  // of the layers
};

}  // namespace

void arrange(LayeredGraph& graph) {
    Arrangement(graph).run();
}

}  // namespace trellis::drawing
