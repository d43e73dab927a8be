// Machines as Graphviz graphs: an arrow to a compound state ends at its cluster's border, which
// takes a node inside to aim at (lhead, ltail).
// SPDX-License-Identifier: MIT
#include "runner/drawing/canvas.h"
#include "runner/drawing/dot.h"
#include "runner/drawing/highlights.h"
#include "runner/drawing/lettering.h"
#include "runner/drawing/machine_drawing.h"

namespace trellis::drawing {
namespace {

constexpr std::size_t most_letters = 60;  // of a line

std::string node(std::uint32_t s) {
    return "s" + std::to_string(s);
}

class MachineDot {
public:
    MachineDot(const MachineModel& model, const DrawingOptions& options)
        : model_(model), highlights_(options.highlights) {}

    std::string write() {
        dot_ = dot_opening(model_.states.front().id, "  compound=true;\n");
        std::vector<std::uint32_t> ends;  // of the clusters around
        for (std::uint32_t s = 1; s < model_.states.size(); ++s) {
            for (; !ends.empty() && ends.back() <= s; ends.pop_back())
                dot_ += std::string(2 * ends.size(), ' ') + "}\n";
            const std::string indent(2 * ends.size() + 2, ' ');
            if (is_compound(s)) {
                open_cluster(s, indent);
                ends.push_back(model_.states[s].end);
            } else {
                write_node(s, indent);
            }
        }
        for (; !ends.empty(); ends.pop_back())
            dot_ += std::string(2 * ends.size(), ' ') + "}\n";
        for (const DrawnTransition& transition : model_.transitions)
            write_edge(transition);
        return dot_ + "}\n";
    }

private:
    bool is_compound(std::uint32_t s) const { return s + 1 < model_.states[s].end; }

    std::vector<std::string> words(std::uint32_t s) const {
        const DrawnState& state = model_.states[s];
        std::vector<std::string> lines{shortened(state.id, most_letters)};
        for (std::size_t i = 0; i < state.lines.size(); ++i)
            lines.push_back((state.inside[i] ? "    " : "") +
                            shortened(state.lines[i], most_letters));
        const std::string& note = highlights_.of(state.element).note;
        if (!note.empty()) lines.push_back(shortened(visible_line(note), most_letters));
        return lines;
    }

    void open_cluster(std::uint32_t s, const std::string& indent) {
        const DrawnState& state = model_.states[s];
        const bool region = model_.states[state.parent.index].shape == StateShape::parallel;
        dot_ += indent + "subgraph cluster_" + node(s) + " {\n" + indent +
                "  label=" + dot_label(words(s), 1) +
                "; style=" + (region ? "\"rounded,dashed\"" : "rounded") +
                "; color=\"#3b6fd4\"; bgcolor=\"#f6f9fe\"";
        const DrawingStatus status = highlights_.of(state.element).status;
        if (status != DrawingStatus::none) {
            const auto [fill, stroke] = status_colours(status);
            dot_ += "; color=" + dot_string(stroke) + "; bgcolor=" + dot_string(fill);
        }
        dot_ += ";\n";
    }

    void write_node(std::uint32_t s, const std::string& indent) {
        const DrawnState& state = model_.states[s];
        dot_ += indent + node(s) + " [";
        switch (state.shape) {
        case StateShape::initial:
            dot_ += "shape=circle, width=0.15, label=\"\", fillcolor=\"#334155\"";
            break;
        case StateShape::final_state:
            dot_ += "shape=doublecircle, width=0.2, label=\"\", fillcolor=\"#334155\", xlabel=" +
                    dot_label(words(s), 1);
            break;
        case StateShape::shallow_history:
        case StateShape::deep_history:
            dot_ += "shape=circle, fillcolor=\"#fff5d9\", color=\"#b98900\", label=";
            dot_ += state.shape == StateShape::deep_history ? "\"H*\"" : "\"H\"";
            break;
        case StateShape::machine:
        case StateShape::state:
        case StateShape::parallel:
            dot_ += "shape=box, style=\"rounded,filled\", fillcolor=\"#eef4fd\", "
                    "color=\"#3b6fd4\", label=" +
                    dot_label(words(s), 1);
            break;
        }
        dot_ += dot_status(highlights_.of(state.element).status) + "];\n";
    }

    /// The first state inside `s` that is a node, or `s` itself.
    std::uint32_t node_in(std::uint32_t s) const {
        while (is_compound(s))
            ++s;
        return s;
    }

    void write_edge(const DrawnTransition& transition) {
        const std::uint32_t source = transition.source.index, target = transition.target.index;
        dot_ += "  " + node(node_in(source)) + " -> " + node(node_in(target)) + " [";
        std::vector<std::string> lines{shortened(transition.event, most_letters)};
        if (!transition.guard.empty())
            lines.push_back("[" + shortened(transition.guard, most_letters) + "]");
        if (!transition.action.empty())
            lines.push_back("/ " + shortened(transition.action, most_letters));
        dot_ += "label=" + dot_label(lines, 0);
        // Graphviz takes a border only of a cluster that the other end is outside of
        const bool around_target = source <= target && target < model_.states[source].end;
        const bool around_source = target <= source && source < model_.states[target].end;
        if (is_compound(source) && !around_target) dot_ += ", ltail=cluster_" + node(source);
        if (is_compound(target) && !around_source) dot_ += ", lhead=cluster_" + node(target);
        const DrawingStatus status = highlights_.of(transition.element).status;
        if (status != DrawingStatus::none)
            dot_ += ", penwidth=3, color=" + dot_string(status_colours(status).stroke);
        dot_ += "];\n";
    }

    const MachineModel& model_;
    Highlights highlights_;
    std::string dot_;
};

}  // namespace

std::string machine_dot(const MachineModel& model, const DrawingOptions& options) {
    return MachineDot(model, options).write();
}

}  // namespace trellis::drawing
