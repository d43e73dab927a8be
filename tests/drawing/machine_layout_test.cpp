// What must hold of every machine's picture: boxes, names and labels keep apart, and arrows run
// around boxes. Tried on the samples and on random machines.
// SPDX-License-Identifier: MIT
#include "runner/drawing/machine_layout.h"

#include "drawing/samples.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace trellis;
using namespace trellis::drawing;
using namespace trellis::test;

namespace {

struct Named {
    std::string name;
    Box box;
};

bool is_inside(const MachineModel& model, std::uint32_t state, std::uint32_t around) {
    return around <= state && state < model.states[around].end;
}

/// Points along a route as it is drawn.
std::vector<Point> points_of(const Route& route) {
    std::vector<Point> points;
    for (std::size_t i = 1; i < route.path.size(); ++i) {
        const Point a = route.path[i - 1], b = route.path[i];
        const double middle = (a.y + b.y) / 2;
        for (int k = 0; k <= 16; ++k) {
            const double t = k / 16.0, s = 1 - t;
            points.push_back({a.x * (s * s * s + 3 * s * s * t) + b.x * (3 * s * t * t + t * t * t),
                              a.y * s * s * s + middle * 3 * s * t + b.y * t * t * t});
        }
    }
    return points;
}

void check_apart(const std::vector<Named>& boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            INFO(boxes[i].name, " and ", boxes[k].name);
            CHECK_FALSE(boxes[i].box.grown(-0.5).overlaps(boxes[k].box.grown(-0.5)));
        }
}

void check_arrows(const MachineModel& model, const MachineLayout& layout) {
    for (std::size_t t = 0; t < model.transitions.size(); ++t) {
        if (layout.routes[t].loop) continue;
        const std::uint32_t source = model.transitions[t].source.index;
        const std::uint32_t target = model.transitions[t].target.index;
        REQUIRE(layout.routes[t].path.size() >= 2);
        for (const Point p : points_of(layout.routes[t])) {
            CHECK(layout.boxes[0].grown(1).overlaps({p.x, p.y, 0.1, 0.1}));
            for (std::uint32_t s = 1; s < model.states.size(); ++s) {
                const bool end = s == source || s == target;
                if (!end && (is_inside(model, source, s) || is_inside(model, target, s))) continue;
                if (end && is_compound(model, {s})) continue;
                INFO(words_of(model.transitions[t]), " from ", model.states[source].id, " to ",
                     model.states[target].id, " through ", model.states[s].id);
                CHECK_FALSE(layout.boxes[s].grown(-1).overlaps({p.x, p.y, 0.01, 0.01}));
            }
        }
    }
}

void check_layout(const Document& document) {
    const MachineModel model = machine_model(document);
    const auto layout = machine_layout(model, Highlights({}));
    REQUIRE(layout);
    std::vector<Named> boxes;
    for (std::uint32_t s = 1; s < model.states.size(); ++s) {
        const DrawnState& state = model.states[s];
        const Box& box = layout->boxes[s];
        CHECK_FALSE(box.x < layout->boxes[state.parent.index].x);
        CHECK_FALSE(box.right() > layout->boxes[state.parent.index].right());
        CHECK_FALSE(box.bottom() > layout->boxes[state.parent.index].bottom());
        // of a compound state its words: the rest of it is there to be drawn on
        const StateCard& card = layout->cards[s];
        boxes.push_back({state.id, is_compound(model, {s}) ? Box{box.x + state_padding, box.y + 8,
                                                                 card.size.width, card.size.height}
                                                           : box});
        if (box.width < 30 && card.size.width > 0)
            boxes.push_back(
                {state.id + "'s name", {box.right() + 7, box.centre() - 8, card.size.width, 16}});
    }
    for (std::size_t t = 0; t < layout->routes.size(); ++t)
        if (!layout->routes[t].words.empty())
            boxes.push_back({words_of(model.transitions[t]), layout->routes[t].label});
    check_apart(boxes);
    check_arrows(model, *layout);
}

}  // namespace

TEST_CASE("machine_layout: nothing overlaps in the samples") {
    for (const char* name : {"roomba_machine.scxml", "compound.scxml", "parallel.scxml",
                             "twelve.scxml", "deep.scxml"}) {
        INFO(name);
        check_layout(sample(name));
    }
}

TEST_CASE("machine_layout: nothing overlaps in random machines") {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const std::string text = random_machine(seed, 4 + seed % 20);
        INFO(text);
        check_layout(document_of(text));
    }
}

TEST_CASE("machine_layout: arrows from a state to its own inside start at its border") {
    check_layout(document_of(R"(<scxml><state id="a"><transition event="in" target="c"/>
        <transition event="again" target="a"/>
        <state id="b"><state id="c"><transition event="out" target="a"/></state></state></state></scxml>)"));
}
