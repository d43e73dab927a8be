// The tidy layout: parents over the middle, no overlaps, on random trees of random sizes.
// SPDX-License-Identifier: MIT
#include "runner/drawing/tidy_layout.h"

#include <doctest/doctest.h>

#include <random>
#include <string>

using namespace trellis::drawing;

namespace {

std::vector<TidyNode> random_tree(unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    const unsigned size = 1 + below(60);
    std::vector<TidyNode> nodes(size);
    // the parent is any node on the way from the root to the one before
    for (std::uint32_t n = 0; n < size; ++n) {
        if (n > 0) {
            std::uint32_t parent = n - 1;
            while (parent != 0 && below(2) == 0)
                parent = nodes[parent].parent;
            nodes[n].parent = parent;
        }
        nodes[n].across = 20 + below(100);
        nodes[n].along = 20 + below(60);
        nodes[n].framed = below(5) == 0;
        nodes[n].end = n + 1;
        for (std::uint32_t p = nodes[n].parent; p != TidyNode::no_parent; p = nodes[p].parent)
            nodes[p].end = n + 1;
    }
    return nodes;
}

}  // namespace

TEST_CASE("tidy_layout: a parent stands over the middle of its children") {
    const TidyLayout layout = tidy_layout(
        {{TidyNode::no_parent, 4, 30, 10}, {0, 2, 40, 10}, {0, 3, 60, 20}, {0, 4, 40, 10}},
        TidyGaps{10, 30, 5});
    CHECK(layout.boxes[1].x == 0);
    CHECK(layout.boxes[2].x == 50);
    CHECK(layout.boxes[3].x == 120);
    CHECK(layout.boxes[0].middle() == 80);
    CHECK(layout.boxes[1].y == 40);
    CHECK(layout.size.width == 160);
    CHECK(layout.size.height == 60);
}

TEST_CASE("tidy_layout: small subtrees between large ones share the room") {
    // two children with wide grandchildren, two leaves between them
    const TidyLayout layout = tidy_layout({{TidyNode::no_parent, 9, 10, 10},
                                           {0, 4, 10, 10},
                                           {1, 3, 90, 10},
                                           {1, 4, 90, 10},
                                           {0, 5, 10, 10},
                                           {0, 6, 10, 10},
                                           {0, 9, 10, 10},
                                           {6, 8, 90, 10},
                                           {6, 9, 90, 10}},
                                          TidyGaps{10, 30, 5});
    const double first = layout.boxes[1].x, last = layout.boxes[6].x;
    CHECK(last - first == 200);
    CHECK(layout.boxes[4].x - first == doctest::Approx(200.0 / 3));
    CHECK(layout.boxes[5].x - first == doctest::Approx(400.0 / 3));
}

TEST_CASE("tidy_layout: nothing overlaps, and frames hold what is theirs") {
    const TidyGaps gaps{10, 30, 8};
    for (unsigned seed = 0; seed < 300; ++seed) {
        INFO("seed ", seed);
        const auto nodes = random_tree(seed);
        const TidyLayout layout = tidy_layout(nodes, gaps);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                CHECK_FALSE(layout.boxes[i].grown(-0.01).overlaps(layout.boxes[k]));
        std::size_t frame = 0;
        for (std::uint32_t n = 0; n < nodes.size(); ++n) {
            if (!nodes[n].framed) continue;
            const Box& box = layout.frames[frame++];
            for (std::uint32_t i = 0; i < nodes.size(); ++i) {
                const Box& other = layout.boxes[i];
                if (i >= n && i < nodes[n].end) {
                    const Box inner = other.grown(gaps.frame - 0.01);
                    CHECK_FALSE(inner.x < box.x);
                    CHECK_FALSE(inner.right() > box.right());
                    CHECK_FALSE(inner.bottom() > box.bottom());
                } else {
                    CHECK_FALSE(box.grown(-0.01).overlaps(other));
                }
            }
        }
    }
}
