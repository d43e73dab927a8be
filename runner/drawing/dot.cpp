// Quoting, labels and colours of DOT.
// SPDX-License-Identifier: MIT
#include "runner/drawing/dot.h"

#include "runner/drawing/canvas.h"
#include "sim/svg.h"

namespace trellis::drawing {

std::string dot_string(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        switch (c) {
        case '"': quoted += "\\\""; break;
        case '\\': quoted += "\\\\"; break;
        case '\n': quoted += "\\n"; break;
        default: quoted += c;
        }
    }
    return quoted + "\"";
}

std::string dot_label(const std::vector<std::string>& lines, std::size_t bold) {
    std::string label = "<";
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string line = svg::escaped(lines[i]);
        if (i > 0) label += "<br/>";
        // an empty <b> is a syntax error to Graphviz
        label += i < bold && !line.empty() ? "<b>" + line + "</b>" : line;
    }
    return label + ">";
}

std::string dot_status(DrawingStatus status) {
    if (status == DrawingStatus::none) return "";
    const auto [fill, stroke] = status_colours(status);
    return ", fillcolor=\"" + std::string(fill) + "\", color=\"" + std::string(stroke) +
           "\", penwidth=3";
}

std::string dot_opening(std::string_view name, std::string_view settings) {
    return "digraph " + dot_string(name) + " {\n" + std::string(settings) +
           "  node [fontname=\"Helvetica,Arial,sans-serif\", fontsize=11, style=filled, "
           "fillcolor=\"#ffffff\"];\n"
           "  edge [fontname=\"Helvetica,Arial,sans-serif\", fontsize=10, color=\"#64748b\"];\n";
}

}  // namespace trellis::drawing
