// Drawing a world from above.
// SPDX-License-Identifier: MIT
#include "sim/world_svg.h"

#include "sim/svg.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trellis {
namespace {

using svg::number;

/// From pale to strong: one hue, so that more is darker for every eye.
constexpr std::array<const char*, 5> heat{"#dcecf2", "#bcdbe7", "#94c4d8", "#68a9c4", "#3d8bab"};

constexpr const char* ink = "#262626";

/// A length in m as a coordinate.
std::string cm(double metres) {
    return number(metres * 100.0);
}

std::string outline(const Polygon& polygon) {
    std::string data;
    for (const Point& corner : polygon.corners)
        data += (data.empty() ? "M" : "L") + cm(corner.x) + " " + cm(corner.y);
    return data + "z";
}

std::string filled(const std::string& data, const char* colour) {
    return data.empty() ? "" : "<path fill=\"" + std::string(colour) + "\" d=\"" + data + "\"/>\n";
}

std::string circle(Point centre, double radius, const std::string& attributes) {
    return "<circle cx=\"" + cm(centre.x) + "\" cy=\"" + cm(centre.y) + "\" r=\"" + cm(radius) +
           "\"" + attributes + "/>\n";
}

}  // namespace

std::string ground_svg(const WalledWorld& world) {
    std::string rooms;
    for (const Polygon& room : world.plan.rooms)
        rooms += outline(room);
    std::string furniture;
    for (const Polygon& piece : world.plan.furniture)
        furniture += outline(piece);
    return filled(rooms, "#fbfaf6") + filled(furniture, "#d9d4c7");
}

std::string walls_svg(const WalledWorld& world) {
    std::string out;
    for (const Dirt& spot : world.plan.dirt)
        out += circle(spot.centre, spot.radius,
                      " fill=\"#8a6d3b\" fill-opacity=\"0.35\" stroke=\"#8a6d3b\" "
                      "stroke-dasharray=\"2 2\"");
    for (const Dock& dock : world.plan.docks)
        out += "<rect x=\"" + cm(dock.place.x - 0.12) + "\" y=\"" + cm(dock.place.y - 0.12) +
               "\" width=\"24\" height=\"24\" rx=\"4\" fill=\"#4c8c5a\" fill-opacity=\"0.5\" "
               "stroke=\"#2f6b3c\"/>\n";
    std::string data;
    for (const Segment& wall : world.walls.segments())
        data += "M" + cm(wall.from.x) + " " + cm(wall.from.y) + "L" + cm(wall.to.x) + " " +
                cm(wall.to.y);
    return out + "<path fill=\"none\" stroke=\"" + ink +
           "\" stroke-width=\"3\" stroke-linecap=\"round\" d=\"" + data + "\"/>\n";
}

std::span<const char* const> heat_colours() {
    return heat;
}

std::vector<int> passes(const Floor& floor, std::span<const TrailPoint> trail) {
    const CellGrid& grid = floor.grid();
    std::vector<int> count(grid.count());
    std::vector<std::size_t> last(grid.count());  // one past the point that last covered the cell
    const double squared = floor.radius() * floor.radius();
    for (std::size_t i = 0; i < trail.size(); ++i) {
        const double x = floor.allowed_x(trail[i].x);
        const double y = floor.allowed_y(trail[i].y);
        if (!std::isfinite(x) || !std::isfinite(y)) continue;
        const auto cells = [&](double value, double least, int most) {
            return std::clamp(static_cast<int>(std::floor((value - least) / grid.cell)), 0, most);
        };
        const int last_row = cells(y + floor.radius(), grid.top, grid.rows - 1);
        const int last_column = cells(x + floor.radius(), grid.left, grid.columns - 1);
        for (int row = cells(y - floor.radius(), grid.top, grid.rows - 1); row <= last_row; ++row) {
            for (int column = cells(x - floor.radius(), grid.left, grid.columns - 1);
                 column <= last_column; ++column) {
                const double dx = grid.centre_x(column) - x;
                const double dy = grid.centre_y(row) - y;
                if (dx * dx + dy * dy > squared || !floor.reachable().contains(column, row))
                    continue;
                const std::size_t cell =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                    static_cast<std::size_t>(column);
                if (last[cell] == 0 || last[cell] != i) ++count[cell];
                last[cell] = i + 1;
            }
        }
    }
    return count;
}

std::string heat_svg(const Floor& floor, std::span<const TrailPoint> trail) {
    const CellGrid& grid = floor.grid();
    const std::vector<int> count = passes(floor, trail);
    std::array<std::string, heat.size()> data;
    for (int row = 0; row < grid.rows; ++row) {
        const auto level = [&](int column) {
            const std::size_t cell =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                static_cast<std::size_t>(column);
            return std::min(count[cell], static_cast<int>(heat.size()));
        };
        for (int column = 0; column < grid.columns;) {
            const int begin = column;
            const int passed = level(column);
            while (column < grid.columns && level(column) == passed)
                ++column;
            if (passed == 0) continue;
            data[static_cast<std::size_t>(passed - 1)] +=
                "M" + cm(grid.left + begin * grid.cell) + " " + cm(grid.top + row * grid.cell) +
                "h" + cm((column - begin) * grid.cell) + "v" + cm(grid.cell) + "h-" +
                cm((column - begin) * grid.cell) + "z";
        }
    }
    std::string out = "<g shape-rendering=\"crispEdges\">\n";
    for (std::size_t i = 0; i < heat.size(); ++i)
        out += filled(data[i], heat[i]);
    return out + "</g>\n";
}

TouchMarks touch_marks(const WalledWorld& world, std::span<const TrailPoint> trail) {
    constexpr double touching = 1e-6;  // m
    TouchMarks marks;
    std::vector<std::string> lines;
    for (const TrailPoint& point : trail) {
        const Nearest wall = world.walls.nearest({point.x, point.y});
        if (wall.distance > world.walls.radius() + touching || wall.distance == 0.0) continue;
        ++marks.points;
        const double inwards = 0.08 / wall.distance;  // m
        lines.push_back("M" + number(std::round(wall.place.x * 100.0)) + " " +
                        number(std::round(wall.place.y * 100.0)) + "l" +
                        cm((point.x - wall.place.x) * inwards) + " " +
                        cm((point.y - wall.place.y) * inwards));
    }
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    for (const std::string& line : lines)
        marks.path += line;
    return marks;
}

}  // namespace trellis
