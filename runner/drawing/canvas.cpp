// Style sheet and spelling of SVG.
// SPDX-License-Identifier: MIT
#include "runner/drawing/canvas.h"

#include "sim/svg.h"

#include <array>
#include <cmath>

namespace trellis::drawing {
namespace {

/// A coordinate with one decimal. Unlike svg::number(double) it cuts nothing: the picture of a huge
/// tree is wider than any room.
std::string number(double value) {
    return svg::number(std::int64_t{std::llround(value * 10)});
}

constexpr double margin = 28;  // around the picture

struct Rule {
    std::string_view selector;
    std::string_view always;
    std::string_view light;
    std::string_view dark;
};

// later rules win over earlier ones: a status over the kind of a node
constexpr std::array rules{
    Rule{".ground", "", "fill:#ffffff", "fill:#14181f"},
    Rule{"text", "font-family:'Segoe UI','Helvetica Neue',Arial,'DejaVu Sans',sans-serif",
         "fill:#1f2933", "fill:#e6e9ee"},
    Rule{".heading", "font-size:17px;font-weight:bold", "", ""},
    Rule{".title", "font-size:13px;font-weight:bold", "", ""},
    Rule{".symbol", "font-size:17px;font-weight:bold", "", ""},
    Rule{".kind", "font-size:11.5px", "fill:#5b6775", "fill:#9da9b8"},
    Rule{".detail", "font-size:11.5px", "fill:#3a4653", "fill:#c3cbd6"},
    Rule{".tag", "font-size:11px;font-style:italic", "fill:#7a4a00", "fill:#e0b26a"},
    Rule{".label", "font-size:11.5px", "fill:#25303b", "fill:#d6dce5"},
    Rule{".shape", "stroke-width:1.5", "", ""},
    Rule{".line", "fill:none;stroke-width:1.5;stroke-linecap:round", "stroke:#64748b",
         "stroke:#8391a5"},
    Rule{".back", "", "stroke:#b4570a", "stroke:#e8a15c"},
    Rule{".head", "stroke:none", "fill:#64748b", "fill:#8391a5"},
    Rule{".back-head", "", "fill:#b4570a", "fill:#e8a15c"},
    Rule{".control", "", "fill:#e8f0fe;stroke:#3b6fd4", "fill:#1b2a47;stroke:#7aa5f7"},
    Rule{".decorator", "", "fill:#f3e9fd;stroke:#8b4fc6", "fill:#2f2142;stroke:#c293f0"},
    Rule{".condition", "", "fill:#fff5d9;stroke:#b98900", "fill:#38300f;stroke:#e3b84a"},
    Rule{".action", "", "fill:#e7f6ed;stroke:#2e8b57", "fill:#163325;stroke:#69c995"},
    Rule{".subtree", "", "fill:#eef1f5;stroke:#556270", "fill:#28303b;stroke:#a7b3c2"},
    Rule{".frame", "fill-opacity:0.06;stroke-width:1.2;stroke-dasharray:5 4",
         "fill:#334e7a;stroke:#9aa8ba", "fill:#a9c4ee;stroke:#566375"},
    Rule{".state", "", "fill:#eef4fd;stroke:#3b6fd4", "fill:#1b2a47;stroke:#7aa5f7"},
    Rule{".compound", "fill-opacity:0.05", "fill:#2b5aa8;stroke:#3b6fd4",
         "fill:#9dc0ff;stroke:#7aa5f7"},
    Rule{".history", "", "fill:#fff5d9;stroke:#b98900", "fill:#38300f;stroke:#e3b84a"},
    Rule{".ring", "fill:none;stroke-width:1.5", "stroke:#334155", "stroke:#cbd5e1"},
    Rule{".dot", "", "fill:#334155", "fill:#cbd5e1"},
    Rule{".rule", "fill:none;stroke-width:1", "stroke:#a9bbd9", "stroke:#4a5f86"},
    Rule{".region", "fill:none;stroke-width:1.2;stroke-dasharray:6 5", "stroke:#3b6fd4",
         "stroke:#7aa5f7"},
    Rule{".veil", "fill-opacity:0.9", "fill:#ffffff", "fill:#14181f"},
};

struct StatusLook {
    std::string_view name;
    std::string_view always;
    StatusColours light;
    StatusColours dark;
};

// in the order of DrawingStatus; these win over the rules above
constexpr std::array<StatusLook, 7> status_looks{{
    {"", "", {}, {}},
    {"idle", "", {"#f3f4f6", "#a3acb8"}, {"#22272f", "#69737f"}},
    {"running", "stroke-width:3", {"#ffe8ad", "#d48806"}, {"#4d3a08", "#ffc53d"}},
    {"success", "stroke-width:3", {"#c9f0d1", "#2b8a3e"}, {"#144020", "#51cf66"}},
    {"failure", "stroke-width:3", {"#ffd4d0", "#c92a2a"}, {"#4f1717", "#ff7b72"}},
    {"skipped", "stroke-dasharray:4 3", {"#f3f4f6", "#7b8794"}, {"#22272f", "#8b96a3"}},
    {"active", "stroke-width:3", {"#cde6ff", "#1769c2"}, {"#0f3a66", "#4dabf7"}},
}};

const StatusLook& look_of(DrawingStatus status) {
    return status_looks[static_cast<std::size_t>(status)];
}

std::string style_sheet() {
    std::string light, dark;
    const auto add = [&](std::string_view selector, std::string_view always, std::string_view day,
                         std::string_view night) {
        const std::string name(selector);
        const std::string_view separator = always.empty() || day.empty() ? "" : ";";
        light +=
            name + "{" + std::string(always) + std::string(separator) + std::string(day) + "}\n";
        if (!night.empty()) dark += name + "{" + std::string(night) + "}\n";
    };
    const auto colours = [](StatusColours c) {
        return "fill:" + std::string(c.fill) + ";stroke:" + std::string(c.stroke);
    };
    for (const Rule& rule : rules)
        add(rule.selector, rule.always, rule.light, rule.dark);
    for (const StatusLook& look : status_looks) {
        if (look.name.empty()) continue;
        const std::string name(look.name);
        add(".shape." + name, look.always, colours(look.light), colours(look.dark));
        // an arrow has a line and a head, but no area
        add(".line." + name, "stroke-width:3", "stroke:" + std::string(look.light.stroke),
            "stroke:" + std::string(look.dark.stroke));
        add(".head." + name, "", "fill:" + std::string(look.light.stroke),
            "fill:" + std::string(look.dark.stroke));
    }
    return "<style>\n" + light + "@media (prefers-color-scheme: dark) {\n" + dark + "}\n</style>\n";
}

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string attribute(std::string_view name, double value) {
    return attribute(name, number(value));
}

std::string_view lettering_class(Lettering lettering) {
    switch (lettering) {
    case Lettering::heading: return "heading";
    case Lettering::title: return "title";
    case Lettering::symbol: return "symbol";
    case Lettering::kind: return "kind";
    case Lettering::detail: return "detail";
    case Lettering::tag: return "tag";
    case Lettering::label: return "label";
    }
    return {};
}

}  // namespace

std::string_view status_class(DrawingStatus status) {
    return look_of(status).name;
}

StatusColours status_colours(DrawingStatus status) {
    return look_of(status).light;
}

void Canvas::open(std::string_view classes, std::string_view tooltip) {
    body_ += "<g" + (classes.empty() ? "" : attribute("class", classes)) + ">\n";
    if (!tooltip.empty()) body_ += "<title>" + svg::escaped(tooltip) + "</title>\n";
}

void Canvas::close() {
    body_ += "</g>\n";
}

void Canvas::box(const Box& box, double radius, std::string_view classes) {
    body_ += "<rect" + attribute("x", box.x) + attribute("y", box.y) +
             attribute("width", box.width) + attribute("height", box.height) +
             (radius > 0 ? attribute("rx", radius) : "") + attribute("class", classes) + "/>\n";
}

void Canvas::ellipse(const Box& box, std::string_view classes) {
    body_ += "<ellipse" + attribute("cx", box.middle()) + attribute("cy", box.centre()) +
             attribute("rx", box.width / 2) + attribute("ry", box.height / 2) +
             attribute("class", classes) + "/>\n";
}

void Canvas::octagon(const Box& box, double cut, std::string_view classes) {
    const auto relative = [](double dx, double dy) { return "l" + coordinates({dx, dy}); };
    path("M" + coordinates({box.x + cut, box.y}) + "h" + number(box.width - 2 * cut) +
             relative(cut, cut) + "v" + number(box.height - 2 * cut) + relative(-cut, cut) + "h" +
             number(2 * cut - box.width) + relative(-cut, -cut) + "v" +
             number(2 * cut - box.height) + "z",
         classes);
}

void Canvas::path(std::string_view data, std::string_view classes) {
    body_ += "<path" + attribute("d", data) + attribute("class", classes) + "/>\n";
}

void Canvas::text(double x, double baseline, const TextLine& line, Anchor anchor) {
    body_ += "<text" + attribute("x", x) + attribute("y", baseline) +
             (anchor == Anchor::middle ? attribute("text-anchor", "middle") : "") +
             attribute("class", lettering_class(line.lettering)) + ">" + svg::escaped(line.text) +
             "</text>\n";
}

double Canvas::lines(double x, double y, const std::vector<TextLine>& lines, Anchor anchor) {
    constexpr double baseline = 0.36;  // of the letter size, below the middle of the line
    for (const TextLine& line : lines) {
        const double height = line_height(line.lettering);
        text(x + line.indent, y + height / 2 + baseline * letter_size(line.lettering), line,
             anchor);
        y += height;
    }
    return y;
}

std::string Canvas::finish(Size size, std::string_view title, std::string_view description) const {
    const double width = std::ceil(size.width + 2 * margin);
    const double height = std::ceil(size.height + 2 * margin);
    const std::string box =
        number(-margin) + " " + number(-margin) + " " + number(width) + " " + number(height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
           attribute("height", height) + attribute("viewBox", box) + attribute("role", "img") +
           ">\n<title>" + svg::escaped(title) + "</title>\n<desc>" + svg::escaped(description) +
           "</desc>\n" + style_sheet() + "<rect" + attribute("x", -margin) +
           attribute("y", -margin) + attribute("width", width) + attribute("height", height) +
           attribute("class", "ground") + "/>\n" + body_ + "</svg>\n";
}

std::string coordinates(Point point) {
    return number(point.x) + " " + number(point.y);
}

std::string vertical_curve(const std::vector<Point>& points) {
    std::string data;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point to = points[i];
        if (i == 0) {
            data = "M" + coordinates(to);
            continue;
        }
        const Point from = points[i - 1];
        if (number(from.x) == number(to.x)) {
            data += "V" + number(to.y);
            continue;
        }
        const double middle = (from.y + to.y) / 2;
        data += "C" + coordinates({from.x, middle}) + " " + coordinates({to.x, middle}) + " " +
                coordinates(to);
    }
    return data;
}

std::string arrow_head(Point tip, int dx, int dy) {
    constexpr double length = 9, half = 4;
    const Point back{tip.x - dx * length, tip.y - dy * length};
    return "M" + coordinates(tip) + "L" + coordinates({back.x - dy * half, back.y - dx * half}) +
           "L" + coordinates({back.x + dy * half, back.y + dx * half}) + "z";
}

}  // namespace trellis::drawing
