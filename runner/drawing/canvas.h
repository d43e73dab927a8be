// An SVG picture under construction: shapes with a class each, the style sheet that gives the
// classes their colours on light and dark ground, and the frame around it all. Knows nothing of
// trees and machines. Covered by tests/drawing/canvas_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/drawing.h"
#include "runner/drawing/geometry.h"
#include "runner/drawing/lettering.h"

#include <string>
#include <string_view>
#include <vector>

namespace trellis::drawing {

/// The class of a status, its CSS name; empty for none.
std::string_view status_class(DrawingStatus status);
/// The colours of a status on light ground, for formats without style sheets.
struct StatusColours {
    std::string_view fill;
    std::string_view stroke;
};
StatusColours status_colours(DrawingStatus status);

/// Where a text stands from its point.
enum class Anchor : std::uint8_t { start, middle };

/// Collects shapes in the order in which they are painted. `classes` are CSS classes of the style
/// sheet, blank-separated.
class Canvas {
public:
    /// Everything until close() belongs together; `tooltip` is what a viewer shows over it.
    void open(std::string_view classes, std::string_view tooltip = {});
    void close();

    void box(const Box& box, double radius, std::string_view classes);
    void ellipse(const Box& box, std::string_view classes);
    /// A box with corners cut by `cut`.
    void octagon(const Box& box, double cut, std::string_view classes);
    /// SVG path data, of path_to() and its friends.
    void path(std::string_view data, std::string_view classes);
    /// One line of text whose baseline is at y.
    void text(double x, double baseline, const TextLine& line, Anchor anchor = Anchor::start);
    /// Lines below each other, the first one's upper side at y; returns the last one's lower side.
    double lines(double x, double y, const std::vector<TextLine>& lines,
                 Anchor anchor = Anchor::start);

    /// The whole document, `size` large with a margin around it.
    std::string finish(Size size, std::string_view title, std::string_view description) const;

private:
    std::string body_;
};

/// A point as path data has it: "12.3 4".
std::string coordinates(Point point);

/// A path through `points` that leaves and meets each of them vertically: straight where two are
/// above each other, else a smooth curve.
std::string vertical_curve(const std::vector<Point>& points);

/// The triangle of an arrow that ends at `tip` and points in the direction (dx, dy), one of which
/// is 0 and the other 1 or -1.
std::string arrow_head(Point tip, int dx, int dy);

}  // namespace trellis::drawing
