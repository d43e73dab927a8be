// Choosing lines and breaking them.
// SPDX-License-Identifier: MIT
#include "runner/drawing/machine_cards.h"

#include <algorithm>

namespace trellis::drawing {
namespace {

constexpr std::size_t state_letters = 42;  // of a line in a state
constexpr std::size_t state_lines = 10;
constexpr std::size_t label_letters = 30;  // of a line beside an arrow

}  // namespace

StateCard card_of(const DrawnState& state, const Highlight& highlight) {
    StateCard card;
    card.title = shortened(state.id, state_letters);
    card.cut = card.title != state.id;
    for (std::size_t i = 0; i < state.lines.size(); ++i) {
        if (i == state_lines && state.lines.size() > state_lines + 1) {
            card.lines.push_back(
                {std::to_string(state.lines.size() - i) + " more …", Lettering::detail});
            card.cut = true;
            break;
        }
        const double indent = state.inside[i] ? 14 : 0;
        for (std::string& line : wrapped(state.lines[i], state_letters, 2)) {
            card.cut = card.cut || line.ends_with("…");
            card.lines.push_back({std::move(line), Lettering::detail, indent});
        }
    }
    if (!highlight.note.empty())
        card.lines.push_back(
            {shortened(visible_line(highlight.note), state_letters), Lettering::tag});
    card.lettering = state.shape == StateShape::machine ? Lettering::heading : Lettering::title;
    const Size lines = size_of(card.lines);
    card.size = {std::max(text_width(card.title, card.lettering), lines.width),
                 (card.title.empty() ? 0 : line_height(card.lettering)) + lines.height};
    return card;
}

std::vector<TextLine> label_of(const DrawnTransition& transition, const Highlight& highlight) {
    std::vector<TextLine> lines;
    const auto add = [&](const std::string& text) {
        if (text.empty()) return;
        for (std::string& line : wrapped(text, label_letters, 2))
            lines.push_back({std::move(line), Lettering::label});
    };
    const std::string all = words_of(transition);
    if (shortened(all, label_letters) == all) {
        add(all);
    } else {
        add(transition.event);
        if (!transition.guard.empty()) add("[" + transition.guard + "]");
        if (!transition.action.empty()) add("/ " + transition.action);
    }
    if (!highlight.note.empty())
        lines.push_back({shortened(visible_line(highlight.note), label_letters), Lettering::tag});
    return lines;
}

}  // namespace trellis::drawing
