// Contours as linked lists that children hand over to their parent. Comparing two costs the depth
// of the shallower one, which is then hidden for ever: that is why the whole is linear.
// SPDX-License-Identifier: MIT
#include "runner/drawing/tidy_layout.h"

#include <algorithm>
#include <limits>

namespace trellis::drawing {
namespace {

constexpr std::uint32_t nothing = 0xFFFFFFFF;

/// A piece of a subtree's left or right border, from the end of the piece before it down to
/// `bottom`. Its x is relative to that piece, the first one's to the middle of the subtree's root:
/// moving a contour changes one number.
struct Segment {
    double x = 0;
    double bottom = 0;
    std::uint32_t next = nothing;
};

/// The first and last segment of a border, and the last one's x from the middle of the root.
struct Contour {
    std::uint32_t first = nothing;
    std::uint32_t last = nothing;
    double last_x = 0;
};

/// A place on a contour: a segment and its x from a fixed origin.
struct Cursor {
    std::uint32_t segment;
    double x;
};

class Tidy {
public:
    Tidy(const std::vector<TidyNode>& nodes, const TidyGaps& gaps)
        : nodes_(nodes), gaps_(gaps), tops_(nodes.size()), offsets_(nodes.size()),
          left_(nodes.size()), right_(nodes.size()), frames_(nodes.size()) {
        segments_.reserve(2 * nodes.size());
    }

    TidyLayout run() {
        for (std::size_t n = 0; n < nodes_.size(); ++n)
            tops_[n] = nodes_[n].parent == TidyNode::no_parent
                           ? 0
                           : tops_[nodes_[n].parent] + nodes_[nodes_[n].parent].along + gaps_.along;
        for (auto n = static_cast<std::uint32_t>(nodes_.size()); n-- > 0;) {
            place_children(n);
            if (nodes_[n].framed) frame(n);
        }
        return positions();
    }

private:
    /// Sets the children of `n` side by side and makes n's contours. Descendants are done.
    void place_children(std::uint32_t n) {
        const TidyNode& node = nodes_[n];
        left_[n] = right_[n] = {};
        if (n + 1 < node.end) {
            join_children(n);
            const double middle = (offsets_[children_.front()] + offsets_[children_.back()]) / 2;
            for (const std::uint32_t child : children_)
                offsets_[child] -= middle;
            left_[n].last_x -= middle;
            right_[n].last_x -= middle;
            segments_[left_[n].first].x -= middle;
            segments_[right_[n].first].x -= middle;
        }
        put_on_top(left_[n], -node.across / 2, tops_[n] + node.along);
        put_on_top(right_[n], node.across / 2, tops_[n] + node.along);
    }

    void put_on_top(Contour& contour, double x, double bottom) {
        const std::uint32_t top = add({x, bottom, contour.first});
        if (contour.first == nothing) {
            contour.last = top;
            contour.last_x = x;
        } else {
            segments_[contour.first].x -= x;
        }
        contour.first = top;
    }

    /// Packs the children of `n` from left to right; offsets are from the first child's middle.
    void join_children(std::uint32_t n) {
        children_.clear();
        visible_.clear();
        shift_.clear();
        for (std::uint32_t c = n + 1; c < nodes_[n].end; c = nodes_[c].end) {
            const auto i = static_cast<std::uint32_t>(children_.size());
            children_.push_back(c);
            shift_.push_back({});
            offsets_[c] = i == 0 ? 0 : separate(i, right_[n]);
            add_to_left(left_[n], c);
            add_to_right(right_[n], c, i);
        }
        // those between two that push each other apart share the room
        double speed = 0, moved = 0;
        for (std::size_t i = 0; i < children_.size(); ++i) {
            speed += shift_[i].speed;
            moved += speed + shift_[i].jump;
            offsets_[children_[i]] += moved;
        }
    }

    /// How far child `i` stands from the first one, so that it clears everything left of it.
    double separate(std::uint32_t i, const Contour& others) {
        const Contour& own = left_[children_[i]];
        Cursor theirs{others.first, segments_[others.first].x};
        Cursor ours{own.first, segments_[own.first].x};
        double offset = std::numeric_limits<double>::lowest();
        std::size_t owner = visible_.size();
        while (theirs.segment != nothing && ours.segment != nothing) {
            const double bottom = segments_[theirs.segment].bottom;
            const double needed = theirs.x + gaps_.across - ours.x;
            if (needed > offset) {
                // whose border it is: the latest sibling that reaches so deep
                while (visible_[owner - 1].bottom < bottom)
                    --owner;
                if (offset > std::numeric_limits<double>::lowest())
                    share(visible_[owner - 1].child, i, needed - offset);
                offset = needed;
            }
            const double own_bottom = segments_[ours.segment].bottom;
            if (bottom <= own_bottom) advance(theirs);
            if (own_bottom <= bottom) advance(ours);
        }
        return offset;
    }

    /// Children between `from` and `to`, which moved by `distance`, move by their share of it.
    /// None of them is on a border that a later comparison sees: `from` hides them on the left and
    /// `to` on the right.
    void share(std::uint32_t from, std::uint32_t to, double distance) {
        const std::uint32_t steps = to - from;
        if (steps < 2) return;
        const double part = distance / steps;
        shift_[from + 1].speed += part;
        shift_[to].speed -= part;
        shift_[to].jump -= distance - part;
    }

    void advance(Cursor& cursor) const {
        cursor.segment = segments_[cursor.segment].next;
        if (cursor.segment != nothing) cursor.x += segments_[cursor.segment].x;
    }

    /// The border of the joined children on the left: the old one, and below it what child `c`
    /// shows there.
    void add_to_left(Contour& joined, std::uint32_t c) {
        Contour own = left_[c];
        segments_[own.first].x += offsets_[c];
        own.last_x += offsets_[c];
        if (joined.first == nothing) {
            joined = own;
            return;
        }
        append_below(joined, own);
    }

    /// On the right: child `c`'s own, and below it the old one.
    void add_to_right(Contour& joined, std::uint32_t c, std::uint32_t i) {
        Contour own = right_[c];
        segments_[own.first].x += offsets_[c];
        own.last_x += offsets_[c];
        const double bottom = segments_[own.last].bottom;
        while (!visible_.empty() && visible_.back().bottom <= bottom)
            visible_.pop_back();
        visible_.push_back({bottom, i});
        if (joined.first != nothing) append_below(own, joined);
        joined = own;
    }

    /// Lengthens `upper` by the part of `lower` that reaches below it.
    void append_below(Contour& upper, const Contour& lower) {
        const double bottom = segments_[upper.last].bottom;
        if (segments_[lower.last].bottom <= bottom) return;
        Cursor cursor{lower.first, segments_[lower.first].x};
        while (segments_[cursor.segment].bottom <= bottom)
            advance(cursor);
        segments_[cursor.segment].x = cursor.x - upper.last_x;
        segments_[upper.last].next = cursor.segment;
        upper.last = lower.last;
        upper.last_x = lower.last_x;
    }

    /// Replaces the contours of `n` by those of a frame around all of it.
    void frame(std::uint32_t n) {
        double least = 0, most = 0, bottom = 0, x = 0;
        for (std::uint32_t s = left_[n].first; s != nothing; s = segments_[s].next) {
            x += segments_[s].x;
            least = std::min(least, x);
            bottom = segments_[s].bottom;
        }
        x = 0;
        for (std::uint32_t s = right_[n].first; s != nothing; s = segments_[s].next) {
            x += segments_[s].x;
            most = std::max(most, x);
        }
        frames_[n] = Box{least, tops_[n], most - least, bottom - tops_[n]}.grown(gaps_.frame);
        left_[n] = right_[n] = {};
        put_on_top(left_[n], frames_[n].x, frames_[n].bottom());
        put_on_top(right_[n], frames_[n].right(), frames_[n].bottom());
    }

    std::uint32_t add(Segment segment) {
        segments_.push_back(segment);
        return static_cast<std::uint32_t>(segments_.size() - 1);
    }

    TidyLayout positions() {
        TidyLayout layout;
        double least = 0, top = 0;
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            if (nodes_[n].parent != TidyNode::no_parent) offsets_[n] += offsets_[nodes_[n].parent];
            layout.boxes.push_back(
                {offsets_[n] - nodes_[n].across / 2, tops_[n], nodes_[n].across, nodes_[n].along});
            if (nodes_[n].framed) {
                Box frame = frames_[n];
                frame.x += offsets_[n];
                layout.frames.push_back(frame);
                least = std::min(least, frame.x);
                top = std::min(top, frame.y);
            }
            least = std::min(least, layout.boxes.back().x);
        }
        for (std::vector<Box>* boxes : {&layout.boxes, &layout.frames}) {
            for (Box& box : *boxes) {
                box.x -= least;
                box.y -= top;
                layout.size.width = std::max(layout.size.width, box.right());
                layout.size.height = std::max(layout.size.height, box.bottom());
            }
        }
        return layout;
    }

    struct Visible {
        double bottom;
        std::uint32_t child;
    };
    struct Shift {
        double speed = 0;  ///< from this child on, each moves by this much more than the one before
        double jump = 0;   ///< from this child on, all move by this much
    };

    const std::vector<TidyNode>& nodes_;
    TidyGaps gaps_;
    std::vector<double> tops_;
    std::vector<double> offsets_;  // of a middle from the parent's; at the end from the root's
    std::vector<Contour> left_, right_;
    std::vector<Box> frames_;  // of framed nodes, x from their middle
    std::vector<Segment> segments_;
    // of the children of one node
    std::vector<std::uint32_t> children_;  // rows
    std::vector<Visible> visible_;         // from the right: deepest first, each less deep
    std::vector<Shift> shift_;
};

}  // namespace

TidyLayout tidy_layout(const std::vector<TidyNode>& nodes, const TidyGaps& gaps) {
    return Tidy(nodes, gaps).run();
}

}  // namespace trellis::drawing
