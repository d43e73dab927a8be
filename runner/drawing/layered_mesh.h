// The layered graph in the form in which layers are ordered and places chosen: every edge cut into
// links from one layer to the next, with a vertex of its own in each layer that it passes. For the
// layered layout only. Covered by tests/drawing/layered_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/layered.h"

namespace trellis::drawing {

/// A box, or the place where an edge passes a layer.
struct Vertex {
    std::uint32_t layer = 0;
    std::uint32_t order = 0;  ///< in its layer, from the left
    double left = 0;          ///< what it takes on each side of its middle
    double right = 0;
    double height = 0;
    double x = 0;          ///< of its middle
    bool passing = false;  ///< an edge passes here
    bool heading = false;
};

struct Link {
    std::uint32_t upper = 0;
    std::uint32_t lower = 0;
    double upper_x = 0;  ///< where it meets the vertex, from its middle
    double lower_x = 0;
};

/// Rows of links at each vertex.
struct LinkLists {
    std::vector<std::uint32_t> begins;  ///< of each vertex in `links`, and one end
    std::vector<std::uint32_t> links;

    struct Range {
        const std::uint32_t* first;
        const std::uint32_t* last;
        const std::uint32_t* begin() const { return first; }
        const std::uint32_t* end() const { return last; }
        bool empty() const { return first == last; }
    };
    Range of(std::uint32_t vertex) const {
        return {links.data() + begins[vertex], links.data() + begins[vertex + 1]};
    }
};

struct Mesh {
    std::vector<Vertex> vertices;           ///< those of the nodes first, in their order
    std::vector<Link> links;                ///< those of one edge are neighbours, from the top down
    std::vector<std::uint32_t> first_link;  ///< of each edge, and one end
    std::vector<std::vector<std::uint32_t>> layers;  ///< vertices from left to right
    LinkLists above, below;                          ///< links to the layer above and below
};

Mesh mesh_of(const LayeredGraph& graph);

/// Orders the layers so that few links cross.
void order_layers(Mesh& mesh);

/// Chooses the middles: vertices in order and apart, links as straight as that allows.
void spread_layers(Mesh& mesh);

/// Where the middle of a vertex may move without its neighbours in the layer; infinite at the ends.
struct Room {
    double least;
    double most;
};
Room room_of(const Mesh& mesh, std::uint32_t vertex);

/// Something that would like to stand at `at` and keeps `gap` from the one before it.
struct Wish {
    double at = 0;
    double gap = 0;
    double weight = 1;
};

/// Places in the order of the wishes, all at least the gaps apart, and inside [least, most] if
/// there is room for all: those with the least sum of weighted squares of distances from the
/// wishes.
std::vector<double> granted(const std::vector<Wish>& wishes, double least, double most);

}  // namespace trellis::drawing
