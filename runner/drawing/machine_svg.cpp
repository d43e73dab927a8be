// States as rounded boxes, arrows as curves, labels on them.
// SPDX-License-Identifier: MIT
#include "runner/drawing/canvas.h"
#include "runner/drawing/highlights.h"
#include "runner/drawing/machine_drawing.h"
#include "runner/drawing/machine_layout.h"

namespace trellis::drawing {
namespace {

constexpr double radius = 10;  // of a state's corners

std::string with_status(std::string_view classes, const Highlight& highlight) {
    const std::string_view status = status_class(highlight.status);
    return std::string(classes) + (status.empty() ? "" : " ") + std::string(status);
}

class MachinePicture {
public:
    MachinePicture(const Document& document, const MachineModel& model, const MachineLayout& layout,
                   const Highlights& highlights)
        : document_(document), model_(model), layout_(layout), highlights_(highlights) {}

    std::string draw() {
        for (std::uint32_t s = 0; s < model_.states.size(); ++s)
            if (is_compound(model_, {s}) || s == 0) draw_compound({s});
        for (std::size_t i = 0; i < layout_.separators.size(); ++i)
            draw_separator(layout_.separators[i], layout_.separated[i]);
        for (std::uint32_t s = 1; s < model_.states.size(); ++s)
            if (!is_compound(model_, {s})) draw_state({s});
        for (std::size_t t = 0; t < model_.transitions.size(); ++t)
            draw_arrow(t);
        // above all arrows, so that each covers only its own
        for (std::size_t t = 0; t < model_.transitions.size(); ++t)
            draw_label(layout_.routes[t]);
        const DrawnState& machine = model_.states.front();
        const Box& whole = layout_.boxes.front();
        return canvas_.finish({whole.width, whole.height},
                              machine.id.empty() ? "statechart" : "statechart " + machine.id,
                              std::to_string(count_states()) + " states, " +
                                  std::to_string(model_.transitions.size()) + " arrows");
    }

private:
    std::size_t count_states() const {
        std::size_t count = 0;
        for (const DrawnState& state : model_.states)
            count += state.shape != StateShape::initial && state.shape != StateShape::machine;
        return count;
    }

    const Highlight& highlight(const DrawnState& state) const {
        return highlights_.of(state.element);
    }

    /// All that the card leaves out, and what the author says of the state.
    std::string tooltip(StateIndex s) const {
        const DrawnState& state = model_.states[s.index];
        std::string text;
        if (layout_.cards[s.index].cut) {
            text = state.id;
            for (std::size_t i = 0; i < state.lines.size(); ++i)
                text += (state.inside[i] ? "\n    " : "\n") + state.lines[i];
        }
        const std::string_view doc = state.element ? document_.doc(state.element) : "";
        if (!doc.empty()) text += (text.empty() ? "" : "\n\n") + std::string(doc);
        return text;
    }

    /// Whether lines separate this region from its neighbours, so that it needs no border.
    bool is_separated(StateIndex s) const {
        const StateIndex parent = model_.states[s.index].parent;
        if (!parent) return false;
        for (const StateIndex separated : layout_.separated)
            if (separated == parent) return true;
        return false;
    }

    void draw_compound(StateIndex s) {
        const DrawnState& state = model_.states[s.index];
        const Box& box = layout_.boxes[s.index];
        const StateCard& card = layout_.cards[s.index];
        canvas_.open("", tooltip(s));
        const bool marked = highlight(state).status != DrawingStatus::none;
        if (s.index != 0 && (marked || !is_separated(s)))
            canvas_.box(box, radius, with_status("shape compound", highlight(state)));
        const bool machine = s.index == 0;
        const double x = machine ? box.x : box.x + state_padding;
        double y = machine ? box.y - state_padding : box.y + 8;
        if (!card.title.empty()) y = canvas_.lines(x, y, {{card.title, card.lettering}});
        canvas_.lines(x, y, card.lines);
        canvas_.close();
    }

    void draw_separator(double x, StateIndex parallel) {
        const Box& box = layout_.boxes[parallel.index];
        const double top = box.y + 8 + layout_.cards[parallel.index].size.height + 6;
        canvas_.path("M" + coordinates({x, top}) + "L" + coordinates({x, box.bottom()}), "region");
    }

    void draw_state(StateIndex s) {
        const DrawnState& state = model_.states[s.index];
        const Box& box = layout_.boxes[s.index];
        canvas_.open("", tooltip(s));
        switch (state.shape) {
        case StateShape::initial: canvas_.ellipse(box, "dot"); break;
        case StateShape::final_state:
            canvas_.ellipse(box, with_status("shape ground ring", highlight(state)));
            canvas_.ellipse(box.grown(-5.5), "dot");
            draw_beside(s);
            break;
        case StateShape::shallow_history:
        case StateShape::deep_history: {
            canvas_.ellipse(box, with_status("shape history", highlight(state)));
            const bool deep = state.shape == StateShape::deep_history;
            canvas_.lines(box.middle(), box.centre() - 9, {{deep ? "H*" : "H", Lettering::title}},
                          Anchor::middle);
            draw_beside(s);
            break;
        }
        case StateShape::machine:
        case StateShape::state:
        case StateShape::parallel: draw_box(s); break;
        }
        canvas_.close();
    }

    /// The words of a circle, on its right.
    void draw_beside(StateIndex s) {
        const Box& box = layout_.boxes[s.index];
        const StateCard& card = layout_.cards[s.index];
        std::vector<TextLine> lines;
        if (!card.title.empty()) lines.push_back({card.title, Lettering::title});
        lines.insert(lines.end(), card.lines.begin(), card.lines.end());
        canvas_.lines(box.right() + 7, box.centre() - size_of(lines).height / 2, lines);
    }

    void draw_box(StateIndex s) {
        const DrawnState& state = model_.states[s.index];
        const Box& box = layout_.boxes[s.index];
        const StateCard& card = layout_.cards[s.index];
        canvas_.box(box, radius, with_status("shape state", highlight(state)));
        const double title = card.title.empty() ? 0 : line_height(Lettering::title);
        if (card.lines.empty()) {
            canvas_.lines(box.middle(), box.centre() - title / 2, {{card.title, Lettering::title}},
                          Anchor::middle);
            return;
        }
        double y = canvas_.lines(box.middle(), box.y + 6, {{card.title, Lettering::title}},
                                 Anchor::middle) +
                   3;
        canvas_.path("M" + coordinates({box.x, y}) + "L" + coordinates({box.right(), y}), "rule");
        const Size lines = size_of(card.lines);
        y += (box.bottom() - y - lines.height) / 2;
        canvas_.lines(box.x + state_padding, y, card.lines);
    }

    void draw_arrow(std::size_t t) {
        const Route& route = layout_.routes[t];
        const ElementId element = model_.transitions[t].element;
        const Highlight& mark = highlights_.of(element);
        const std::string line = with_status(route.back ? "line back" : "line", mark);
        const std::string head = with_status(route.back ? "head back-head" : "head", mark);
        const Point tip = route.path.back();
        canvas_.open("", element ? document_.doc(element) : "");
        if (route.loop) {
            constexpr double reach = 30;
            const Point start = route.path.front();
            canvas_.path(
                "M" + coordinates(start) + "C" + coordinates({start.x + reach, start.y - 5}) + " " +
                    coordinates({tip.x + reach, tip.y + 5}) + " " + coordinates({tip.x + 6, tip.y}),
                line);
            canvas_.path(arrow_head(tip, -1, 0), head);
        } else {
            // the line ends inside the head, so that the tip stays sharp
            std::vector<Point> path = route.path;
            const bool down = path[path.size() - 2].y < tip.y;
            path.back().y += down ? -5 : 5;
            canvas_.path(vertical_curve(path), line);
            canvas_.path(arrow_head(tip, 0, down ? 1 : -1), head);
        }
        canvas_.close();
    }

    void draw_label(const Route& route) {
        if (route.words.empty()) return;
        canvas_.box(route.label, 4, "veil");
        if (route.loop)
            canvas_.lines(route.label.x + 4, route.label.y + 2, route.words);
        else
            canvas_.lines(route.label.middle(), route.label.y + 2, route.words, Anchor::middle);
    }

    const Document& document_;
    const MachineModel& model_;
    const MachineLayout& layout_;
    const Highlights& highlights_;
    Canvas canvas_;
};

}  // namespace

std::string machine_svg(const Document& document, const MachineModel& model,
                        const DrawingOptions& options) {
    const Highlights highlights(options.highlights);
    if (const auto layout = machine_layout(model, highlights))
        return MachinePicture(document, model, *layout, highlights).draw();
    MachineModel written = model;
    write_out_transitions(written);
    const auto layout = machine_layout(written, highlights);
    return layout ? MachinePicture(document, written, *layout, highlights).draw() : std::string();
}

}  // namespace trellis::drawing
