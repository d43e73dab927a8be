// Points, sizes and boxes of a drawing, in SVG's user units (1 unit = 1 pixel at normal size), y
// downwards. Covered by every test in tests/drawing.
// SPDX-License-Identifier: MIT
#pragma once

namespace trellis::drawing {

struct Point {
    double x = 0;
    double y = 0;
};

struct Size {
    double width = 0;
    double height = 0;
};

/// An upright rectangle.
struct Box {
    double x = 0;  ///< of its left side
    double y = 0;  ///< of its upper side
    double width = 0;
    double height = 0;

    double right() const { return x + width; }
    double bottom() const { return y + height; }
    double middle() const { return x + width / 2; }
    double centre() const { return y + height / 2; }
    /// This box with `margin` more on each side.
    Box grown(double margin) const {
        return {x - margin, y - margin, width + 2 * margin, height + 2 * margin};
    }
    /// Whether the two share an area.
    bool overlaps(const Box& other) const {
        return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom();
    }
};

}  // namespace trellis::drawing
