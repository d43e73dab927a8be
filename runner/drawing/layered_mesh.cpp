// Cutting edges into links, and the order of the layers.
// SPDX-License-Identifier: MIT
#include "runner/drawing/layered_mesh.h"

#include <algorithm>
#include <numeric>

namespace trellis::drawing {
namespace {

constexpr double line_room = 6;   // of an edge without label, on each side
constexpr double label_room = 6;  // around a label

LinkLists lists_of(const Mesh& mesh, std::uint32_t Link::*end) {
    LinkLists lists;
    lists.begins.resize(mesh.vertices.size() + 1);
    lists.links.resize(mesh.links.size());
    for (const Link& link : mesh.links)
        ++lists.begins[link.*end + 1];
    std::partial_sum(lists.begins.begin(), lists.begins.end(), lists.begins.begin());
    std::vector<std::uint32_t> next(lists.begins.begin(), lists.begins.end() - 1);
    for (std::uint32_t i = 0; i < mesh.links.size(); ++i)
        lists.links[next[mesh.links[i].*end]++] = i;
    return lists;
}

void add_edge(Mesh& mesh, const LayeredGraph& graph, const LayeredEdge& edge) {
    const std::uint32_t upper = edge.upward ? edge.to : edge.from;
    const std::uint32_t lower = edge.upward ? edge.from : edge.to;
    const auto shift = [&](std::uint32_t node, std::optional<double> x) {
        return x ? *x - graph.nodes[node].width / 2 : 0;
    };
    const std::uint32_t top = graph.nodes[upper].layer, bottom = graph.nodes[lower].layer;
    const std::uint32_t label = edge.label.width > 0 ? (top + bottom) / 2 : bottom;
    Link link{upper, lower, shift(upper, edge.upward ? edge.to_x : edge.from_x), 0};
    for (std::uint32_t layer = top + 1; layer < bottom; ++layer) {
        Vertex vertex;
        vertex.layer = layer;
        vertex.passing = true;
        const bool here = layer == label;
        vertex.left = vertex.right = here ? edge.label.width / 2 + label_room : line_room;
        vertex.height = here ? edge.label.height + 2 : 0;
        link.lower = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(vertex);
        mesh.links.push_back(link);
        link = {link.lower, lower, 0, 0};
    }
    link.lower_x = shift(lower, edge.upward ? edge.from_x : edge.to_x);
    mesh.links.push_back(link);
}

/// Puts the vertices into their layers in the order in which a walk down the links meets them.
void first_order(Mesh& mesh, std::size_t nodes) {
    std::vector<bool> met(mesh.vertices.size());
    std::vector<std::uint32_t> stack;
    for (std::uint32_t start = 0; start < nodes; ++start) {
        stack.push_back(start);
        while (!stack.empty()) {
            const std::uint32_t v = stack.back();
            stack.pop_back();
            if (met[v]) continue;
            met[v] = true;
            auto& layer = mesh.layers[mesh.vertices[v].layer];
            layer.insert(mesh.vertices[v].heading ? layer.begin() : layer.end(), v);
            const auto below = mesh.below.of(v);
            for (const std::uint32_t* i = below.end(); i != below.begin();)
                stack.push_back(mesh.links[*--i].lower);
        }
    }
    for (auto& layer : mesh.layers)
        for (std::uint32_t i = 0; i < layer.size(); ++i)
            mesh.vertices[layer[i]].order = i;
}

/// Where a link meets a vertex, counted in vertices of its layer.
double position(const Vertex& vertex, double x) {
    const double half = vertex.left + vertex.right;
    return vertex.order + (half > 0 ? x / half * 0.9 : 0);
}

/// Crossings of the links between a layer and the one below: an inversion count with a binary
/// indexed tree (Barth, Jünger and Mutzel, 2002).
std::uint64_t crossings(const Mesh& mesh, std::size_t layer) {
    struct Ends {
        double upper, lower;
    };
    std::vector<Ends> ends;
    for (const std::uint32_t v : mesh.layers[layer])
        for (const std::uint32_t i : mesh.below.of(v))
            ends.push_back({position(mesh.vertices[v], mesh.links[i].upper_x),
                            position(mesh.vertices[mesh.links[i].lower], mesh.links[i].lower_x)});
    std::sort(ends.begin(), ends.end(), [](const Ends& a, const Ends& b) {
        return a.upper != b.upper ? a.upper < b.upper : a.lower < b.lower;
    });
    std::vector<double> lowers;
    for (const Ends& e : ends)
        lowers.push_back(e.lower);
    std::sort(lowers.begin(), lowers.end());
    std::vector<std::uint32_t> tree(ends.size() + 1);
    std::uint64_t count = 0;
    for (std::size_t seen = 0; seen < ends.size(); ++seen) {
        const auto rank = static_cast<std::size_t>(
            std::upper_bound(lowers.begin(), lowers.end(), ends[seen].lower) - lowers.begin());
        count += seen;
        for (std::size_t i = rank; i > 0; i -= i & (~i + 1))
            count -= tree[i];
        for (std::size_t i = rank; i < tree.size(); i += i & (~i + 1))
            ++tree[i];
    }
    return count;
}

std::uint64_t crossings(const Mesh& mesh) {
    std::uint64_t count = 0;
    for (std::size_t layer = 0; layer + 1 < mesh.layers.size(); ++layer)
        count += crossings(mesh, layer);
    return count;
}

void set_orders(Mesh& mesh, const std::vector<std::uint32_t>& layer) {
    for (std::uint32_t i = 0; i < layer.size(); ++i)
        mesh.vertices[layer[i]].order = i;
}

/// Sorts a layer by the mean position of the neighbours on one side; vertices without any keep
/// their places.
void sort_layer(Mesh& mesh, std::vector<std::uint32_t>& layer, bool by_above) {
    struct Key {
        double mean;
        std::uint32_t vertex;
    };
    std::vector<Key> keys;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        double sum = 0;
        std::size_t count = 0;
        for (const std::uint32_t l : (by_above ? mesh.above : mesh.below).of(layer[i])) {
            const Link& link = mesh.links[l];
            sum += by_above
                       ? position(mesh.vertices[link.upper], link.upper_x) - link.lower_x / 1e6
                       : position(mesh.vertices[link.lower], link.lower_x) - link.upper_x / 1e6;
            ++count;
        }
        if (count == 0) continue;
        keys.push_back({sum / static_cast<double>(count), layer[i]});
        places.push_back(i);
    }
    std::stable_sort(keys.begin(), keys.end(),
                     [](const Key& a, const Key& b) { return a.mean < b.mean; });
    for (std::size_t i = 0; i < keys.size(); ++i)
        layer[places[i]] = keys[i].vertex;
    set_orders(mesh, layer);
}

/// Crossings between the links of two neighbours in a layer if `a` stands left of `b`.
std::size_t pair_crossings(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
    std::size_t count = 0;
    for (const std::uint32_t i : mesh.above.of(a))
        for (const std::uint32_t j : mesh.above.of(b))
            count += position(mesh.vertices[mesh.links[i].upper], mesh.links[i].upper_x) >
                     position(mesh.vertices[mesh.links[j].upper], mesh.links[j].upper_x);
    for (const std::uint32_t i : mesh.below.of(a))
        for (const std::uint32_t j : mesh.below.of(b))
            count += position(mesh.vertices[mesh.links[i].lower], mesh.links[i].lower_x) >
                     position(mesh.vertices[mesh.links[j].lower], mesh.links[j].lower_x);
    return count;
}

/// Exchanges neighbours in each layer while that helps, a bounded number of times.
void exchange(Mesh& mesh) {
    bool better = true;
    for (int pass = 0; better && pass < 8; ++pass) {
        better = false;
        for (auto& layer : mesh.layers) {
            for (std::size_t i = 0; i + 1 < layer.size(); ++i) {
                if (mesh.vertices[layer[i]].heading ||
                    pair_crossings(mesh, layer[i], layer[i + 1]) <=
                        pair_crossings(mesh, layer[i + 1], layer[i]))
                    continue;
                std::swap(layer[i], layer[i + 1]);
                std::swap(mesh.vertices[layer[i]].order, mesh.vertices[layer[i + 1]].order);
                better = true;
            }
        }
    }
}

}  // namespace

Mesh mesh_of(const LayeredGraph& graph) {
    Mesh mesh;
    std::uint32_t layers = 0;
    for (const LayeredNode& node : graph.nodes) {
        Vertex vertex;
        vertex.layer = node.layer;
        vertex.left = node.width / 2;
        vertex.right = node.width / 2 + node.room;
        vertex.height = node.height;
        vertex.heading = node.place == LayeredNode::Place::heading;
        mesh.vertices.push_back(vertex);
        layers = std::max(layers, node.layer + 1);
    }
    for (const LayeredEdge& edge : graph.edges) {
        mesh.first_link.push_back(static_cast<std::uint32_t>(mesh.links.size()));
        add_edge(mesh, graph, edge);
    }
    mesh.first_link.push_back(static_cast<std::uint32_t>(mesh.links.size()));
    mesh.above = lists_of(mesh, &Link::lower);
    mesh.below = lists_of(mesh, &Link::upper);
    mesh.layers.resize(layers);
    first_order(mesh, graph.nodes.size());
    return mesh;
}

void order_layers(Mesh& mesh) {
    // beyond this size exchanges cost more than they gain; the sweeps stay
    constexpr std::size_t small = 3000;
    const int sweeps = mesh.vertices.size() < 20 * small ? 12 : 3;
    auto best = mesh.layers;
    std::uint64_t fewest = crossings(mesh);
    for (int sweep = 0; sweep < 2 * sweeps && fewest > 0; ++sweep) {
        const bool down = sweep % 2 == 0;
        for (std::size_t i = 1; i < mesh.layers.size(); ++i)
            sort_layer(mesh, mesh.layers[down ? i : mesh.layers.size() - 1 - i], down);
        if (mesh.vertices.size() < small) exchange(mesh);
        if (const std::uint64_t count = crossings(mesh); count < fewest) {
            fewest = count;
            best = mesh.layers;
        }
    }
    mesh.layers = std::move(best);
    for (const auto& layer : mesh.layers)
        set_orders(mesh, layer);
}

}  // namespace trellis::drawing
