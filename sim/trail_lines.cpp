// Cuts a trail into ways of one leaf each and writes each as path data.
// SPDX-License-Identifier: MIT
#include "sim/trail_lines.h"

#include "sim/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace trellis {
namespace {

constexpr double tolerance = 0.0015;  // m, by which a thinned line may leave the trail

// Okabe and Ito (2008), distinguishable with every kind of colour vision; without its yellow, which
// is invisible on white. A second round is dashed, a third dotted.
constexpr std::array<std::string_view, 7> palette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                     "#e69f00", "#56b4e9", "#4d4d4d"};
constexpr std::array<std::string_view, 3> dashes = {"", "7 4", "1 4"};

/// Appends one way: a line, or a dot where all of it rounds to one tenth of a pixel.
void draw_way(std::span<const TrailPoint> way, LeafLines& leaf) {
    std::string start;
    std::string steps;
    std::int64_t x = 0;
    std::int64_t y = 0;
    for (const std::size_t i : simplified(way, tolerance)) {
        const std::int64_t next_x = svg::tenths(way[i].x * 100.0);
        const std::int64_t next_y = svg::tenths(way[i].y * 100.0);
        if (i == 0) {
            start = "M" + svg::number(next_x) + " " + svg::number(next_y);
        } else if (next_x != x || next_y != y) {
            steps += steps.empty() ? "l" : " ";
            steps += svg::number(next_x - x) + " " + svg::number(next_y - y);
        }
        x = next_x;
        y = next_y;
    }
    if (steps.empty())
        leaf.dots += start + "h0";
    else
        leaf.lines += start + steps;
}

/// Draws every way of `trail`; the last of `leaves` takes what is none of the others'.
void draw_ways(std::span<const TrailPoint> trail, std::span<LeafLines> leaves) {
    const auto index_of = [&](std::size_t i) {
        return std::min<std::size_t>(trail[i].leaf, leaves.size() - 1);
    };
    std::size_t begin = 0;
    for (std::size_t i = 0; i + 1 < trail.size(); ++i) {
        LeafLines& leaf = leaves[index_of(i)];
        ++leaf.ticks;
        leaf.length += std::hypot(trail[i + 1].x - trail[i].x, trail[i + 1].y - trail[i].y);
        const bool goes_on = i + 2 < trail.size() && index_of(i + 1) == index_of(i);
        if (goes_on) continue;
        draw_way(trail.subspan(begin, i + 2 - begin), leaf);
        begin = i + 1;
    }
}

}  // namespace

std::vector<LeafLines> leaf_lines(std::span<const TrailPoint> trail,
                                  std::span<const std::string> leaves) {
    std::vector<LeafLines> result(leaves.size() + 1);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        result[i].name = leaves[i];
        result[i].colour = palette[i % palette.size()];
        result[i].dash = dashes[i / palette.size() % dashes.size()];
    }
    result.back().name = "no leaf";
    result.back().colour = "#b0b0b0";
    draw_ways(trail, result);
    return result;
}

LeafLines red_line(std::span<const TrailPoint> trail) {
    LeafLines line;
    line.name = "trail";
    line.colour = "#e00000";
    draw_ways(trail, {&line, 1});
    return line;
}

}  // namespace trellis
