// Where the boxes of a graph stand and how its arrows run: layer below layer, so that most arrows
// point down. After Sugiyama, Tagawa and Toda (1981): turn some arrows round until there is no
// cycle, give each box a layer, order each layer so that few arrows cross, then choose places. No
// arrow crosses a box and no label another, by construction: in each layer that an arrow passes, it
// has a place of its own. Knows only sizes. Covered by tests/drawing/layered_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/geometry.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace trellis::drawing {

struct LayeredNode {
    enum class Place : std::uint8_t {
        anywhere,
        heading,  ///< leftmost in the first layer, and as far left as anything; has no edges
        first,    ///< in the first layer
        last,     ///< in the last layer
    };

    Place place = Place::anywhere;
    bool point = false;  ///< edges meet the middle of its sides, else anywhere along them
    double width = 0;
    double height = 0;
    double room = 0;          ///< kept free on its right
    std::uint32_t layer = 0;  ///< result of assign_layers()
    Point at;                 ///< result of arrange(): its upper left corner
};

struct LayeredEdge {
    std::uint32_t from = 0;  ///< rows of LayeredGraph::nodes, not equal
    std::uint32_t to = 0;
    std::uint32_t length = 2;  ///< layers it goes at least; with a label 2 or more
    Size label;                ///< nothing for none
    /// Where it must meet a box, from the box's left side; none where it likes.
    std::optional<double> from_x, to_x;
    bool upward = false;  ///< result of assign_layers(): `to` is above `from`
    /// Result of arrange(): from box to box; every part is either vertical, or to be drawn as a
    /// curve that begins and ends vertically.
    std::vector<Point> path;
    Point label_at;  ///< result of arrange(): the label's middle
};

struct LayeredGraph {
    std::vector<LayeredNode> nodes;
    std::vector<LayeredEdge> edges;
    bool regions = false;  ///< boxes without edges stand side by side, upper sides aligned
    Size size;             ///< result of arrange()
};

/// Sets the layers and which edges point upward. Uses neither sizes nor `from_x` and `to_x`, so
/// that it can tell beforehand on which side an edge will meet a box. Linear.
void assign_layers(LayeredGraph& graph);

/// How many layers the edges pass, all added up: what arrange() will take memory for.
std::size_t way_length(const LayeredGraph& graph);

/// Sets the places of the boxes, paths and labels, from 0 on. Time is linear in the nodes, edges
/// and way_length(), but for a factor of its logarithm.
void arrange(LayeredGraph& graph);

}  // namespace trellis::drawing
