// Reachable cells and the table of the cells near a position.
// SPDX-License-Identifier: MIT
#include "sim/floor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

namespace trellis {
namespace {

/// A cell is divided into this many parts each way; all positions in a part share their spans.
constexpr int parts_per_cell = 4;

/// How many cells of `cell` m it takes to cover `size` m; a rounding error is no further cell.
int cells_over(double size, double cell) {
    return static_cast<int>(std::ceil(size / cell - 1e-6));
}

/// The spans of one part of a cell: cells whose centre is within `radius` cells of the part's
/// middle (x, y), which is measured from the cell's corner.
void add_spans(std::vector<CellSpan>& spans, int reach, double radius, double x, double y) {
    for (int row = -reach; row <= reach; ++row) {
        const double dy = row + 0.5 - y;
        CellSpan span;
        if (std::fabs(dy) <= radius) {
            const double half = std::sqrt(radius * radius - dy * dy);
            span.first = static_cast<std::int16_t>(std::ceil(x - half - 0.5));
            span.last = static_cast<std::int16_t>(std::floor(x + half - 0.5));
        }
        spans.push_back(span);
    }
}

/// Where the disc's centre can be, found by spreading from a start over a grid of places.
class Spread {
public:
    Spread(const Walls& walls, const CellGrid& places) : walls_(walls), places_(places) {}

    /// The nearest place to `wanted` where the disc fits, if it is at most a cell away: places
    /// beside walls are moved until they touch them, so that none is lost to the grid.
    std::optional<Point> fitting(Point wanted) const {
        constexpr int most_pushes = 16;
        constexpr double rounding = 1e-9;  // m
        Point place = wanted;
        for (int i = 0; i < most_pushes; ++i) {
            const Nearest wall = walls_.nearest(place);
            if (wall.distance >= walls_.radius() - rounding) {
                const double moved = std::hypot(place.x - wanted.x, place.y - wanted.y);
                if (moved > places_.cell) return {};
                return place;
            }
            if (wall.distance < walls_.radius() - 2.0 * places_.cell) return {};
            const double stretch = walls_.radius() / wall.distance;
            place = {wall.place.x + (place.x - wall.place.x) * stretch,
                     wall.place.y + (place.y - wall.place.y) * stretch};
        }
        return {};
    }

    /// All fitting places that hang together with `start`.
    std::vector<Point> from(Point start) const {
        CellSet tried(places_);
        std::vector<Point> found;
        std::vector<std::pair<int, int>> open;
        const auto visit = [&](int column, int row, Point wanted) {
            tried.insert(column, row);
            const std::optional<Point> place = fitting(wanted);
            if (!place) return;
            found.push_back(*place);
            open.emplace_back(column, row);
        };
        const auto cell_of = [](double value, double least, double cell, int count) {
            return std::clamp(static_cast<int>((value - least) / cell), 0, count - 1);
        };
        if (walls_.nearest(start).distance < walls_.radius() - 1e-9) return found;
        visit(cell_of(start.x, places_.left, places_.cell, places_.columns),
              cell_of(start.y, places_.top, places_.cell, places_.rows), start);
        for (std::size_t i = 0; i < open.size(); ++i) {
            const auto [column, row] = open[i];
            for (int y = std::max(0, row - 1); y <= std::min(places_.rows - 1, row + 1); ++y) {
                for (int x = std::max(0, column - 1);
                     x <= std::min(places_.columns - 1, column + 1); ++x) {
                    if (!tried.contains(x, y))
                        visit(x, y, {places_.centre_x(x), places_.centre_y(y)});
                }
            }
        }
        return found;
    }

private:
    const Walls& walls_;
    CellGrid places_;
};

/// Adds the cells whose centre the disc covers at a place.
void add_disc(CellSet& cells, const CellGrid& grid, Point place, double radius) {
    const auto row_of = [&](double y) {
        return static_cast<int>(std::floor((y - grid.top) / grid.cell));
    };
    const int last = std::min(grid.rows - 1, row_of(place.y + radius));
    for (int row = std::max(0, row_of(place.y - radius)); row <= last; ++row) {
        const double dy = grid.centre_y(row) - place.y;
        const double squared = radius * radius - dy * dy;
        if (squared < 0.0) continue;
        const double middle = (place.x - grid.left) / grid.cell - 0.5;
        const double half = std::sqrt(squared) / grid.cell;
        const int end = std::min(grid.columns - 1, static_cast<int>(std::floor(middle + half)));
        for (int column = std::max(0, static_cast<int>(std::ceil(middle - half))); column <= end;
             ++column)
            cells.insert(column, row);
    }
}

}  // namespace

CellGrid grid_over(const Bounds& bounds, double cell) {
    return {.left = bounds.least.x,
            .top = bounds.least.y,
            .cell = cell,
            .columns = std::max(1, cells_over(bounds.most.x - bounds.least.x, cell)),
            .rows = std::max(1, cells_over(bounds.most.y - bounds.least.y, cell))};
}

std::size_t CellSet::size() const {
    std::size_t size = 0;
    for (const std::uint64_t word : words_)
        size += static_cast<std::size_t>(std::popcount(word));
    return size;
}

Floor::Floor(Parts parts)
    : parts_(std::move(parts)), reachable_count_(parts_.reachable.size()),
      per_cell_(1.0 / parts_.grid.cell) {
    // no position of a part is farther from its middle than half its diagonal
    const double radius =
        (parts_.radius + margin()) / grid().cell + std::sqrt(0.5) / parts_per_cell;
    reach_ = static_cast<int>(std::ceil(radius));
    for (int y = 0; y < parts_per_cell; ++y)
        for (int x = 0; x < parts_per_cell; ++x)
            add_spans(spans_, reach_, radius, (x + 0.5) / parts_per_cell,
                      (y + 0.5) / parts_per_cell);
}

std::span<const CellSpan> Floor::near(double part_x, double part_y) const {
    const auto x = static_cast<std::size_t>(part_x * parts_per_cell);
    const auto y = static_cast<std::size_t>(part_y * parts_per_cell);
    const auto rows = static_cast<std::size_t>(2 * reach_ + 1);
    return {spans_.data() + (y * parts_per_cell + x) * rows, rows};
}

Floor floor_of(const LabWorld& world, double cell) {
    // where the lab's collision lets the centre be; in a room narrower than the robot, one line
    Floor::Parts parts{.grid = grid_over({{0.0, 0.0}, {world.width, world.height}}, cell),
                       .reachable = {},
                       .radius = world.radius,
                       .x_least = world.radius,
                       .x_most = std::max(world.radius, world.width - world.radius),
                       .y_least = world.radius,
                       .y_most = std::max(world.radius, world.height - world.radius)};
    parts.reachable = CellSet(parts.grid);
    for (int row = 0; row < parts.grid.rows; ++row) {
        const double y = parts.grid.centre_y(row);
        const double dy = y - std::clamp(y, parts.y_least, parts.y_most);
        for (int column = 0; column < parts.grid.columns; ++column) {
            const double x = parts.grid.centre_x(column);
            const double dx = x - std::clamp(x, parts.x_least, parts.x_most);
            const bool inside = x <= world.width && y <= world.height;
            if (inside && dx * dx + dy * dy <= world.radius * world.radius)
                parts.reachable.insert(column, row);
        }
    }
    return Floor(std::move(parts));
}

std::vector<Point> places_of(const Walls& walls, Point start, double apart) {
    return Spread(walls, grid_over(walls.bounds(), apart)).from(start);
}

Floor floor_of(const Walls& walls, Point start, double cell) {
    const Bounds& bounds = walls.bounds();
    Floor::Parts parts{.grid = grid_over(bounds, cell),
                       .reachable = {},
                       .radius = walls.radius(),
                       .x_least = bounds.least.x,
                       .x_most = bounds.most.x,
                       .y_least = bounds.least.y,
                       .y_most = bounds.most.y};
    parts.reachable = CellSet(parts.grid);
    const double apart = std::min(cell, walls.radius() / 4.0);
    for (const Point& place : places_of(walls, start, apart)) {
        // far from walls the places around cover what this one covers, but for its own cell
        const bool beside_wall = walls.nearest(place).distance < walls.radius() + 2.0 * apart;
        add_disc(parts.reachable, parts.grid, place, beside_wall ? walls.radius() : apart);
    }
    return Floor(std::move(parts));
}

}  // namespace trellis
