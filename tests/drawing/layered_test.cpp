// The parts of the layered layout that machine_layout_test.cpp does not show as a whole: layers,
// directions, order, and places granted to wishes.
// SPDX-License-Identifier: MIT
#include "runner/drawing/layered.h"

#include "runner/drawing/layered_mesh.h"

#include <doctest/doctest.h>

using namespace trellis::drawing;

namespace {

LayeredGraph graph_of(std::size_t nodes, const std::vector<std::pair<unsigned, unsigned>>& edges) {
    LayeredGraph graph;
    graph.nodes.resize(nodes);
    for (LayeredNode& node : graph.nodes)
        node.width = node.height = 40;
    for (const auto& [from, to] : edges) {
        LayeredEdge edge;
        edge.from = from;
        edge.to = to;
        edge.length = 1;
        graph.edges.push_back(edge);
    }
    return graph;
}

}  // namespace

TEST_CASE("layered: an edge that closes a cycle points up") {
    LayeredGraph graph = graph_of(3, {{0, 1}, {1, 2}, {2, 0}, {1, 0}});
    assign_layers(graph);
    CHECK(graph.nodes[0].layer == 0);
    CHECK(graph.nodes[1].layer == 1);
    CHECK(graph.nodes[2].layer == 2);
    CHECK_FALSE(graph.edges[0].upward);
    CHECK(graph.edges[2].upward);
    CHECK(graph.edges[3].upward);
    CHECK(way_length(graph) == 5);
}

TEST_CASE("layered: first and last stand where they must") {
    LayeredGraph graph = graph_of(4, {{2, 0}, {0, 1}, {1, 3}});
    graph.nodes[2].place = LayeredNode::Place::first;
    graph.nodes[3].place = LayeredNode::Place::last;
    assign_layers(graph);
    CHECK(graph.nodes[2].layer == 0);
    CHECK(graph.nodes[0].layer == 1);
    CHECK(graph.nodes[3].layer == 3);
}

TEST_CASE("layered: many boxes without edges fold into rows") {
    LayeredGraph graph = graph_of(24, {});
    assign_layers(graph);
    CHECK(graph.nodes[5].layer == 0);
    CHECK(graph.nodes[6].layer == 1);
    CHECK(graph.nodes[23].layer == 3);
}

TEST_CASE("layered: layers are ordered until nothing crosses") {
    LayeredGraph graph = graph_of(6, {{0, 3}, {0, 5}, {1, 4}, {2, 3}, {2, 5}, {1, 5}});
    for (int i = 0; i < 6; ++i)
        graph.nodes[static_cast<std::size_t>(i)].layer = i < 3 ? 0 : 1;
    Mesh mesh = mesh_of(graph);
    order_layers(mesh);
    // only 0-3, 0-5, 2-3 and 2-5 together force one crossing
    std::size_t crossings = 0;
    for (const Link& a : mesh.links)
        for (const Link& b : mesh.links)
            crossings += mesh.vertices[a.upper].order < mesh.vertices[b.upper].order &&
                         mesh.vertices[a.lower].order > mesh.vertices[b.lower].order;
    CHECK(crossings == 1);
}

TEST_CASE("layered: wishes are granted as far as gaps and bounds allow") {
    CHECK(granted({{0, 0, 1}, {20, 10, 1}}, -100, 100) == std::vector<double>{0, 20});
    CHECK(granted({{0, 0, 1}, {0, 10, 1}}, -100, 100) == std::vector<double>{-5, 5});
    CHECK(granted({{0, 0, 3}, {0, 8, 1}}, -100, 100) == std::vector<double>{-2, 6});
    CHECK(granted({{-50, 0, 1}, {50, 10, 1}}, 0, 30) == std::vector<double>{0, 30});
    CHECK(granted({}, 0, 1).empty());
}
