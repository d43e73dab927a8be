// Machines for a terminal.
// SPDX-License-Identifier: MIT
#include "runner/drawing/canvas.h"
#include "runner/drawing/highlights.h"
#include "runner/drawing/lettering.h"
#include "runner/drawing/machine_drawing.h"

namespace trellis::drawing {
namespace {

constexpr std::size_t most_letters = 90;  // of what a state does, and of a label

struct Marks {
    std::string_view state, parallel, final_state, history, deep_history, initial, arrow;
};
constexpr Marks unicode_marks{"□", "∥", "◉", "(H)", "(H*)", "●", "→"};
constexpr Marks ascii_marks{"[]", "||", "(o)", "(H)", "(H*)", "*", "->"};

std::string_view mark_of(StateShape shape, const Marks& marks) {
    switch (shape) {
    case StateShape::machine: return "";
    case StateShape::state: return marks.state;
    case StateShape::parallel: return marks.parallel;
    case StateShape::final_state: return marks.final_state;
    case StateShape::shallow_history: return marks.history;
    case StateShape::deep_history: return marks.deep_history;
    case StateShape::initial: return marks.initial;
    }
    return {};
}

class MachineText {
public:
    MachineText(const MachineModel& model, const DrawingOptions& options)
        : model_(model), highlights_(options.highlights), ascii_(options.ascii),
          marks_(options.ascii ? ascii_marks : unicode_marks), transitions_(model.states.size()) {
        for (std::uint32_t t = 0; t < model.transitions.size(); ++t)
            transitions_[model.transitions[t].source.index].push_back(t);
    }

    std::string write() {
        std::vector<std::uint32_t> ends;  // of the states around
        for (std::uint32_t s = 0; s < model_.states.size(); ++s) {
            while (!ends.empty() && ends.back() <= s)
                ends.pop_back();
            write_state({s}, std::string(2 * ends.size(), ' '));
            ends.push_back(model_.states[s].end);
        }
        return ascii_ ? ascii_only(text_) : std::move(text_);
    }

private:
    std::string status(ElementId element) const {
        const Highlight& highlight = highlights_.of(element);
        const std::string_view word = status_class(highlight.status);
        return (word.empty() ? "" : "  [" + std::string(word) + "]") +
               (highlight.note.empty() ? "" : "  " + visible_line(highlight.note));
    }

    void write_state(StateIndex s, const std::string& indent) {
        const DrawnState& state = model_.states[s.index];
        const std::string_view mark = mark_of(state.shape, marks_);
        text_ += indent + std::string(mark);
        if (!state.id.empty()) text_ += (mark.empty() ? "" : " ") + state.id;
        if (state.shape == StateShape::machine && state.id.empty()) text_ += "machine";
        if (state.shape == StateShape::initial) {
            for (const std::uint32_t t : transitions_[s.index])
                write_arrow(model_.transitions[t], " ");
            text_ += "\n";
            return;
        }
        text_ += status(state.element) + "\n";
        for (std::size_t i = 0; i < state.lines.size(); ++i)
            text_ += indent + (state.inside[i] ? "        " : "    ") +
                     shortened(state.lines[i], most_letters) + "\n";
        for (const std::uint32_t t : transitions_[s.index]) {
            write_arrow(model_.transitions[t], indent + "    ");
            text_ += "\n";
        }
    }

    void write_arrow(const DrawnTransition& transition, const std::string& before) {
        text_ +=
            before + std::string(marks_.arrow) + " " + model_.states[transition.target.index].id;
        const std::string words = words_of(transition);
        if (!words.empty()) text_ += "  " + shortened(words, most_letters);
        text_ += status(transition.element);
    }

    const MachineModel& model_;
    Highlights highlights_;
    bool ascii_;
    const Marks& marks_;
    std::vector<std::vector<std::uint32_t>> transitions_;  // of each state
    std::string text_;
};

}  // namespace

std::string machine_text(const MachineModel& model, const DrawingOptions& options) {
    return MachineText(model, options).write();
}

}  // namespace trellis::drawing
