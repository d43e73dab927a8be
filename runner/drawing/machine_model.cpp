// From SCXML's elements to drawn states, and executable content as a line of words.
// SPDX-License-Identifier: MIT
#include "runner/drawing/machine_model.h"

#include "load/text.h"
#include "runner/drawing/lettering.h"

#include <initializer_list>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace trellis::drawing {
namespace {

std::optional<StateShape> shape_of(const Document& document, ElementId e) {
    const std::string_view name = document.name(e);
    if (name == "state") return StateShape::state;
    if (name == "parallel") return StateShape::parallel;
    if (name == "final") return StateShape::final_state;
    if (name != "history") return std::nullopt;
    return document.value(e, "type") == "deep" ? StateShape::deep_history
                                               : StateShape::shallow_history;
}

/// The blank-separated words of an attribute.
std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> result;
    while (!(text = trimmed(text)).empty()) {
        const std::size_t end = text.find_first_of(" \t\n\r");
        result.push_back(text.substr(0, end));
        text.remove_prefix(result.back().size());
    }
    return result;
}

/// Executable content as a reader would say it aloud.
class Speaker {
public:
    explicit Speaker(const Document& document) : document_(document) {}

    /// What stands inside `parent`: "x = 1; raise e".
    std::string content(ElementId parent) const {
        std::string text;
        for (const ElementId e : document_.children(parent)) {
            const std::string_view name = document_.name(e);
            // the branches of an <if> lie side by side in it
            if (name == "else") {
                text += " else ";
                continue;
            }
            if (name == "elseif") {
                text += " else if " + value(e, "cond") + ": ";
                continue;
            }
            if (!text.empty() && !text.ends_with(" else ") && !text.ends_with(": ")) text += "; ";
            text += statement(e, name);
        }
        return text;
    }

    std::string value(ElementId e, std::string_view attribute) const {
        return visible_line(document_.value(e, attribute));
    }

private:
    std::string statement(ElementId e, std::string_view name) const {
        const std::string text = visible_line(document_.text(e));
        if (name == "assign") {
            const std::string expr = value(e, "expr");
            return value(e, "location") + " = " + (expr.empty() ? text : expr);
        }
        if (name == "script") return text;
        if (name == "raise") return "raise " + value(e, "event");
        if (name == "log") return joined("log", {value(e, "label"), value(e, "expr")});
        if (name == "cancel") return joined("cancel", {value(e, "sendid"), value(e, "sendidexpr")});
        if (name == "send") return send(e);
        if (name == "if") return "if " + value(e, "cond") + ": " + content(e);
        if (name == "foreach")
            return "for each " + value(e, "item") + " in " + value(e, "array") + ": " + content(e);
        return visible_line(name);
    }

    std::string send(ElementId e) const {
        std::string text = joined("send", {value(e, "event"), value(e, "eventexpr")});
        const std::string target = value(e, "target") + value(e, "targetexpr");
        if (!target.empty()) text += " to " + target;
        const std::string delay = value(e, "delay") + value(e, "delayexpr");
        if (!delay.empty()) text += " after " + delay;
        return text;
    }

    static std::string joined(std::string text, std::initializer_list<std::string> parts) {
        for (const std::string& part : parts)
            if (!part.empty()) text += " " + part;
        return text;
    }

    const Document& document_;
};

class ModelBuilder {
public:
    explicit ModelBuilder(const Document& document) : document_(document), say_(document) {}

    MachineModel build() {
        add_states();
        for (std::uint32_t i = 0; i < model_.states.size(); ++i)
            add_parts({i});
        for (const Arrow& arrow : arrows_)
            add_arrow(arrow);
        return std::move(model_);
    }

private:
    struct Arrow {
        ElementId element;
        StateIndex source;
        std::string_view targets;
        ElementId otherwise;  ///< the target if no name is given
    };

    /// States in document order, an initial dot before the children of each compound one.
    void add_states() {
        std::vector<StateIndex> around{};
        for (std::uint32_t i = 0; i < document_.elements.size(); ++i) {
            const ElementId e{i};
            const bool machine = e == document_.root();
            const auto shape = machine ? StateShape::machine : shape_of(document_, e);
            while (!around.empty() && document_.at(element_of(around.back())).end <= e) {
                model_.states[around.back().index].end = size();
                around.pop_back();
            }
            // a machine inside an <invoke> is another machine
            if (!shape || (!machine && document_.at(e).parent != element_of(around.back())))
                continue;
            const StateIndex state{size()};
            DrawnState& drawn = model_.states.emplace_back();
            drawn.element = e;
            drawn.parent = around.empty() ? StateIndex{} : around.back();
            drawn.shape = *shape;
            drawn.id = visible_line(document_.value(e, machine ? "name" : "id"));
            by_id_.emplace(document_.value(e, "id"), state);
            by_element_.emplace(e, state);
            around.push_back(state);
            if (*shape == StateShape::machine || *shape == StateShape::state) add_initial(state);
        }
        for (const StateIndex state : around)
            model_.states[state.index].end = size();
    }

    std::uint32_t size() const { return static_cast<std::uint32_t>(model_.states.size()); }
    ElementId element_of(StateIndex state) const { return model_.states[state.index].element; }

    /// The dot of a state with children, and its arrow to where the state begins (SCXML 3.3.2).
    void add_initial(StateIndex state) {
        const ElementId e = element_of(state);
        ElementId initial, first;
        for (const ElementId child : document_.children(e)) {
            if (document_.name(child) == "initial") initial = child;
            const auto shape = shape_of(document_, child);
            const bool history =
                shape == StateShape::shallow_history || shape == StateShape::deep_history;
            if (shape && !history && !first) first = child;
        }
        if (!first) return;
        Arrow arrow{{}, {size()}, document_.value(e, "initial"), first};
        if (initial) {
            for (const ElementId child : document_.children(initial))
                if (document_.name(child) == "transition") arrow.element = child;
            if (arrow.element) arrow.targets = document_.value(arrow.element, "target");
        }
        DrawnState& dot = model_.states.emplace_back();
        dot.element = initial;
        dot.parent = state;
        dot.end = size();
        dot.shape = StateShape::initial;
        arrows_.push_back(arrow);
    }

    void add_line(StateIndex state, std::string line, bool inside = false) {
        model_.states[state.index].lines.push_back(std::move(line));
        model_.states[state.index].inside.push_back(inside);
    }

    /// What stands directly in a state besides its children.
    void add_parts(StateIndex state) {
        if (model_.states[state.index].shape == StateShape::initial) return;
        for (const ElementId e : document_.children(element_of(state))) {
            const std::string_view name = document_.name(e);
            if (name == "onentry") add_line(state, "entry / " + say_.content(e));
            if (name == "onexit") add_line(state, "exit / " + say_.content(e));
            if (name == "invoke") add_invoke(state, e);
            if (name == "transition")
                arrows_.push_back({e, state, document_.value(e, "target"), {}});
        }
    }

    void add_invoke(StateIndex state, ElementId e) {
        std::string what = say_.value(e, "src") + say_.value(e, "srcexpr");
        if (what.empty()) what = say_.value(e, "type");
        add_line(state, "do / " + (what.empty() ? "a machine" : what));
        for (const ElementId param : document_.children(e)) {
            if (document_.name(param) != "param") continue;
            add_line(state,
                     say_.value(param, "name") + " = " + say_.value(param, "expr") +
                         say_.value(param, "location"),
                     true);
        }
    }

    void add_arrow(const Arrow& arrow) {
        DrawnTransition drawn;
        drawn.element = arrow.element;
        drawn.source = arrow.source;
        if (arrow.element) {
            drawn.event = say_.value(arrow.element, "event");
            drawn.guard = say_.value(arrow.element, "cond");
            drawn.action = say_.content(arrow.element);
        }
        const auto targets = words(arrow.targets);
        if (targets.empty() && arrow.otherwise) {
            drawn.target = by_element_.at(arrow.otherwise);
            model_.transitions.push_back(drawn);
        } else if (targets.empty()) {
            add_line(arrow.source, words_of(drawn));
        }
        for (const std::string_view target : targets) {
            const auto found = by_id_.find(target);
            if (found == by_id_.end()) {
                add_line(arrow.source, words_of(drawn) + " → " + visible_line(target));
                continue;
            }
            drawn.target = found->second;
            model_.transitions.push_back(drawn);
            // said once, at the first of several targets
            drawn.event = drawn.guard = drawn.action = "";
        }
    }

    const Document& document_;
    Speaker say_;
    std::map<std::string_view, StateIndex> by_id_;  // the first of each
    std::map<ElementId, StateIndex> by_element_;
    std::vector<Arrow> arrows_;
    MachineModel model_;
};

}  // namespace

MachineModel machine_model(const Document& document) {
    return ModelBuilder(document).build();
}

std::string words_of(const DrawnTransition& transition) {
    std::string text = transition.event;
    if (!transition.guard.empty()) text += (text.empty() ? "[" : " [") + transition.guard + "]";
    if (!transition.action.empty()) text += (text.empty() ? "/ " : " / ") + transition.action;
    return text;
}

void write_out_transitions(MachineModel& model) {
    std::vector<DrawnTransition> kept;
    for (DrawnTransition& transition : model.transitions) {
        DrawnState& source = model.states[transition.source.index];
        if (source.shape == StateShape::initial) {
            while (model.states[transition.target.index].parent != source.parent)
                transition.target = model.states[transition.target.index].parent;
            kept.push_back(std::move(transition));
            continue;
        }
        source.lines.push_back(words_of(transition) + " → " +
                               model.states[transition.target.index].id);
        source.inside.push_back(false);
    }
    model.transitions = std::move(kept);
}

}  // namespace trellis::drawing
