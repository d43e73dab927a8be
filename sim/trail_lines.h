// A trail as lines: which way was whose, thinned out, as SVG path data in pixels of 1 cm. Not the
// picture around them (sim/trail_svg.h). Covered by tests/sim/trail_svg_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/trail.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// How one leaf is drawn and how much it did.
struct LeafLines {
    std::string name;
    std::string_view colour;  ///< "#0072b2"; of a constant
    std::string_view dash;    ///< stroke-dasharray of a constant; empty: a solid line
    std::string lines;        ///< path data of its ways
    std::string dots;         ///< path data of the places where it did not move
    std::size_t ticks = 0;    ///< how long it ran
    double length = 0.0;      ///< m, how far it drove
};

/// The trail's lines by leaf: one element per name, in their order, and a last one, "no leaf", for
/// ticks of none of them. The colours go by that order, not by use: equal lists, equal colours.
std::vector<LeafLines> leaf_lines(std::span<const TrailPoint> trail,
                                  std::span<const std::string> leaves);

/// The whole trail as one red line named "trail", whatever the leaves.
LeafLines red_line(std::span<const TrailPoint> trail);

}  // namespace trellis
