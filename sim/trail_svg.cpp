// Lays the picture out: title, room with trail, marks and robot, scale and legend. Inside the room
// one unit is 1 cm, the lab's pixel.
// SPDX-License-Identifier: MIT
#include "sim/trail_svg.h"

#include "sim/svg.h"
#include "sim/trail_lines.h"
#include "sim/world_svg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace trellis {
namespace {

using svg::number;

// layout, in pixels
constexpr double margin = 32.0;        // left and right of the room
constexpr double header = 76.0;        // above the room
constexpr double footer = 32.0;        // from the room to the first row of the legend
constexpr double row_height = 22.0;    // of the legend
constexpr double legend_left = 192.0;  // where the legend begins, right of the scale bar
constexpr double narrowest = 544.0;    // of the picture: title and legend need some width
constexpr double title_size = 18.0;    // of the font
constexpr double text_size = 12.0;     // of the font
constexpr double name_width = 200.0;   // at most, of a leaf in the legend

constexpr const char* ink = "#262626";

/// ` name="value"`; the value is a number or a text that needs no escaping.
std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string attribute(std::string_view name, double value) {
    return attribute(name, number(value));
}

std::string path(std::string_view attributes, std::string_view data) {
    return "<path" + std::string(attributes) + attribute("d", data) + "/>\n";
}

std::string text(double x, double y, std::string_view attributes, std::string_view words) {
    return "<text" + attribute("x", x) + attribute("y", y) + std::string(attributes) + ">" +
           svg::escaped(words) + "</text>\n";
}

std::string moved_to(double x, double y, std::string_view content) {
    return "<g" + attribute("transform", "translate(" + number(x) + " " + number(y) + ")") + ">\n" +
           std::string(content) + "</g>\n";
}

/// Floor, a line every metre, and walls outside the floor.
std::string room(const LabWorld& world) {
    const double width = world.width * 100.0;
    const double height = world.height * 100.0;
    std::string grid;
    for (double x = 100.0; x < width; x += 100.0)
        grid += "M" + number(x) + " 0v" + number(height);
    for (double y = 100.0; y < height; y += 100.0)
        grid += "M0 " + number(y) + "h" + number(width);

    std::string out = "<rect" + attribute("width", width) + attribute("height", height) +
                      attribute("fill", "#fbfaf6") + "/>\n";
    if (!grid.empty()) out += path(attribute("stroke", "#e8e5da"), grid);
    return out + "<rect" + attribute("x", -1.5) + attribute("y", -1.5) +
           attribute("width", width + 3.0) + attribute("height", height + 3.0) +
           attribute("fill", "none") + attribute("stroke", ink) + attribute("stroke-width", 3.0) +
           "/>\n";
}

/// Lines and dots of every leaf, the farthest driven below: short ways stay visible.
std::string lines(std::vector<LeafLines> leaves, TrailLook look) {
    const bool lab = look == TrailLook::lab;
    std::stable_sort(leaves.begin(), leaves.end(),
                     [](const LeafLines& a, const LeafLines& b) { return a.length > b.length; });
    std::string out = "<g" + attribute("fill", "none") + attribute("stroke-linejoin", "round") +
                      attribute("stroke-linecap", "round") +
                      attribute("stroke-width", lab ? 4.0 : 1.8) + ">\n";
    for (const LeafLines& leaf : leaves) {
        const std::string stroke = attribute("stroke", leaf.colour);
        const std::string dash = leaf.dash.empty() ? "" : attribute("stroke-dasharray", leaf.dash);
        if (!leaf.lines.empty()) out += path(stroke + dash, leaf.lines);
        if (!leaf.dots.empty() && !lab)
            out += path(stroke + attribute("stroke-width", 4.8), leaf.dots);
    }
    return out + "</g>\n";
}

/// Where walls were touched, in whole pixels, and how many ticks had their bumper pressed.
struct Bumps {
    std::string marks;  // path data: a short line from the wall inwards, each place once
    std::size_t ticks = 0;
};

Bumps bumps_of(const LabWorld& world, std::span<const TrailPoint> trail) {
    Bumps bumps;
    std::vector<std::string> marks;
    const auto at = [](double x, double y) {
        return "M" + number(std::round(x * 100.0)) + " " + number(std::round(y * 100.0));
    };
    for (const TrailPoint& point : trail) {
        const Contacts wall = contacts(world, point.x, point.y);
        if (wall.left) marks.push_back(at(0.0, point.y) + "h8");
        if (wall.right) marks.push_back(at(world.width, point.y) + "h-8");
        if (wall.top) marks.push_back(at(point.x, 0.0) + "v8");
        if (wall.bottom) marks.push_back(at(point.x, world.height) + "v-8");
        if (wall.any()) ++bumps.ticks;
    }
    std::sort(marks.begin(), marks.end());
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
    for (const std::string& mark : marks)
        bumps.marks += mark;
    return bumps;
}

Bumps bumps_of(const WalledWorld& world, std::span<const TrailPoint> trail) {
    TouchMarks marks = touch_marks(world, trail);
    return {.marks = std::move(marks.path), .ticks = marks.points};
}

/// The robot from above: its disc, the bumper in front, and where it looks.
std::string robot_disc(double metres, const Roomba& robot) {
    const double radius = metres * 100.0;
    const double bumper = std::numbers::pi / 3.0;  // to each side of the heading
    const auto spot = [&](double angle, double distance) {
        return number(distance * std::cos(angle)) + " " + number(distance * std::sin(angle));
    };
    const double rim = radius - 2.0;
    std::string disc = "<circle" + attribute("r", radius) + attribute("fill", "#ffffff") +
                       attribute("fill-opacity", "0.92") + attribute("stroke", ink) +
                       attribute("stroke-width", 1.5) + "/>\n";
    const std::string line =
        attribute("fill", "none") + attribute("stroke", ink) + attribute("stroke-linecap", "round");
    disc += path(line + attribute("stroke-width", 3.5),
                 "M" + spot(robot.rotation - bumper, rim) + "A" + number(rim) + " " + number(rim) +
                     " 0 0 1 " + spot(robot.rotation + bumper, rim));
    disc += path(line + attribute("stroke-width", 2.5), "M0 0L" + spot(robot.rotation, rim - 4.0));
    return moved_to(robot.x * 100.0, robot.y * 100.0, disc);
}

std::string start_ring() {
    return "<circle" + attribute("r", 5.0) + attribute("fill", "#ffffff") +
           attribute("stroke", ink) + attribute("stroke-width", 2.0) + "/>\n";
}

std::string bump_stroke() {
    return attribute("stroke", ink) + attribute("stroke-width", 1.6);
}

/// One entry of the legend: a drawing 24 wide around y = 0, and its words.
struct Entry {
    std::string drawing;
    std::string words;
};

/// What the legend explains: the leaves that ran, with their share of the ticks, and the marks.
std::vector<Entry> entries_of(std::span<const LeafLines> leaves, const Bumps& bumps,
                              const TrailPicture& picture) {
    const std::size_t ticks =
        std::accumulate(leaves.begin(), leaves.end(), std::size_t{0},
                        [](std::size_t sum, const LeafLines& leaf) { return sum + leaf.ticks; });
    std::vector<Entry> entries;
    for (const LeafLines& leaf : leaves) {
        if (leaf.ticks == 0) continue;
        Entry entry;
        const std::string stroke = attribute("stroke", leaf.colour);
        if (leaf.lines.empty())
            entry.drawing =
                path(stroke + attribute("stroke-width", 7.0) + attribute("stroke-linecap", "round"),
                     "M12 0h0");
        else
            entry.drawing =
                path(stroke + attribute("stroke-width", 3.0) +
                         (leaf.dash.empty() ? "" : attribute("stroke-dasharray", leaf.dash)),
                     "M0 0h24");
        entry.words = svg::fitted(leaf.name, name_width, text_size);
        if (leaves.size() > 1)
            entry.words +=
                " " + number(100.0 * static_cast<double>(leaf.ticks) / static_cast<double>(ticks)) +
                " %";
        entries.push_back(std::move(entry));
    }
    entries.push_back({moved_to(12.0, 0.0, start_ring()), "start"});
    if (bumps.ticks != 0) entries.push_back({path(bump_stroke(), "M12 -4v8"), "bump"});
    if (picture.walled != nullptr) {
        const auto spot = [](const char* colour) {
            return "<circle" + attribute("cx", 12.0) + attribute("r", 6.0) +
                   attribute("fill", colour) + attribute("fill-opacity", "0.5") + "/>\n";
        };
        if (!picture.walled->plan.dirt.empty()) entries.push_back({spot("#8a6d3b"), "dirt"});
        if (!picture.walled->plan.docks.empty()) entries.push_back({spot("#4c8c5a"), "dock"});
    }
    if (picture.floor != nullptr) {
        const auto colours = heat_colours();
        for (std::size_t i = 0; i < colours.size(); ++i)
            entries.push_back({"<rect" + attribute("y", -6.0) + attribute("width", 24.0) +
                                   attribute("height", 12.0) + attribute("fill", colours[i]) +
                                   "/>\n",
                               std::to_string(i + 1) + (i + 1 < colours.size() ? "" : "+") + "×"});
    }
    return entries;
}

/// Scale bar and legend, in rows from y = 0 downwards.
struct Foot {
    std::string svg;
    double height = 0.0;
};

Foot foot(std::span<const Entry> entries, double width) {
    Foot result;
    result.svg =
        path(attribute("fill", "none") + attribute("stroke", ink) + attribute("stroke-width", 1.5),
             "M" + number(margin) + " -5v10m0 -5h100m0 -5v10");
    result.svg += text(margin + 108.0, 4.0, "", "1 m");

    double x = legend_left;
    double y = 0.0;
    for (const Entry& entry : entries) {
        const double entry_width = 32.0 + svg::text_width(entry.words, text_size);
        if (x + entry_width > width - margin && x > legend_left) {
            x = legend_left;
            y += row_height;
        }
        result.svg += moved_to(x, y, entry.drawing + text(32.0, 4.0, "", entry.words));
        x += entry_width + 18.0;
    }
    result.height = y + row_height;
    return result;
}

/// "seed 7 · 600 s · 41 bumps"; a trail that does not begin at the start says how much it shows.
std::string subtitle(std::span<const TrailPoint> trail, const TrailPicture& picture,
                     const Bumps& bumps) {
    std::string words = picture.run.empty() ? "" : std::string(picture.run) + " · ";
    words += number(picture.seconds) + " s";
    if (!trail.empty() && (trail[0].x != picture.start.x || trail[0].y != picture.start.y))
        words += " · last " + std::to_string(trail.size()) + " ticks";
    words += " · " + std::to_string(bumps.ticks);
    return words + (bumps.ticks == 1 ? " bump" : " bumps");
}

/// The room or rooms and everything in them; the lab's look has no marks.
std::string inside(const LabWorld& world, std::span<const TrailPoint> trail,
                   std::span<const LeafLines> leaves, const Bumps& bumps, const Roomba& end,
                   const TrailPicture& picture) {
    std::string out = picture.walled == nullptr ? room(world) : ground_svg(*picture.walled);
    if (picture.floor != nullptr) out += heat_svg(*picture.floor, trail);
    if (picture.walled != nullptr) out += walls_svg(*picture.walled);
    out += lines({leaves.begin(), leaves.end()}, picture.look);
    if (picture.look == TrailLook::leaves) {
        if (!bumps.marks.empty()) out += path(bump_stroke(), bumps.marks);
        out += moved_to(picture.start.x * 100.0, picture.start.y * 100.0, start_ring());
    }
    const double radius = picture.walled == nullptr ? world.radius : picture.walled->walls.radius();
    return out + robot_disc(radius, end);
}

/// What the room or rooms take of the floor.
Bounds extent(const LabWorld& world, const TrailPicture& picture) {
    if (picture.walled != nullptr) return picture.walled->walls.bounds();
    return {{0.0, 0.0}, {world.width, world.height}};
}

/// The document of a given size, its background, title and second line.
std::string head(double width, double height, std::string_view title, std::string_view below) {
    const double column = width - 2.0 * margin;
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
                      attribute("height", height) +
                      attribute("viewBox", "0 0 " + number(width) + " " + number(height)) +
                      attribute("role", "img") +
                      attribute("font-family", "Helvetica, Arial, sans-serif") +
                      attribute("font-size", text_size) + attribute("fill", ink) + ">\n";
    out += "<title>" + svg::escaped(title) + ": trail of the robot</title>\n";
    out += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    out += text(margin, 36.0, attribute("font-size", title_size) + attribute("font-weight", "bold"),
                svg::fitted(title, column / 1.1, title_size));  // bold is a tenth wider
    return out +
           text(margin, 57.0, attribute("fill", "#5a5a5a"), svg::fitted(below, column, text_size));
}

}  // namespace

std::string trail_svg(const LabWorld& world, std::span<const TrailPoint> trail, const Roomba& end,
                      const TrailPicture& picture) {
    const bool lab = picture.look == TrailLook::lab;
    std::vector<TrailPoint> way(trail.begin(), trail.end());
    way.push_back({.x = end.x, .y = end.y});
    const std::vector<LeafLines> leaves = lab || picture.leaves.empty()
                                              ? std::vector<LeafLines>{red_line(way)}
                                              : leaf_lines(way, picture.leaves);
    const Bumps bumps =
        picture.walled == nullptr ? bumps_of(world, trail) : bumps_of(*picture.walled, trail);

    const Bounds bounds = extent(world, picture);
    const double room_width = (bounds.most.x - bounds.least.x) * 100.0;
    const double width = std::max(room_width + 2.0 * margin, narrowest);
    const double foot_top = header + (bounds.most.y - bounds.least.y) * 100.0 + footer;
    const Foot below = foot(lab ? std::vector<Entry>{} : entries_of(leaves, bumps, picture), width);
    return head(width, foot_top + below.height, picture.title, subtitle(trail, picture, bumps)) +
           moved_to((width - room_width) / 2.0 - bounds.least.x * 100.0,
                    header - bounds.least.y * 100.0,
                    inside(world, trail, leaves, bumps, end, picture)) +
           moved_to(0.0, foot_top, below.svg) + "</svg>\n";
}

}  // namespace trellis
