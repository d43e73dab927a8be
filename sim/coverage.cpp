// Sweeping a disc over cells. Most ticks drive over ground that is covered already, so a sweep also
// finds out how far the robot can go before it could cover anything: until then add() is one
// comparison.
// SPDX-License-Identifier: MIT
#include "sim/coverage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace trellis {
namespace {

// A way is swept when it is so many cells long: the shortest, and the longest where no open cell is
// near. The longest leaves a tick's move to what Floor::near() looks ahead.
constexpr double least_step = 0.4;
constexpr double most_step = 0.75;

/// The bits of a word of 64 columns, beginning with column `begin`, that lie in [first, last].
std::uint64_t columns_in(int begin, int first, int last) {
    std::uint64_t bits = ~std::uint64_t{0};
    if (first > begin) bits &= bits << (first - begin);
    if (last < begin + 63) bits &= ~std::uint64_t{0} >> (begin + 63 - last);
    return bits;
}

/// The straight way that ends at (x, y).
struct Way {
    Way(double from_x, double from_y, double x, double y) : back_x(from_x - x), back_y(from_y - y) {
        const double squared = back_x * back_x + back_y * back_y;
        if (squared > 0.0) per_squared = 1.0 / squared;
    }

    /// Of a place from the way, m²; the place is given relative to the way's end.
    double squared_distance(double dx, double dy) const {
        const double part = std::clamp((dx * back_x + dy * back_y) * per_squared, 0.0, 1.0);
        const double off_x = dx - part * back_x;
        const double off_y = dy - part * back_y;
        return off_x * off_x + off_y * off_y;
    }

    double back_x, back_y;     // m
    double per_squared = 0.0;  // 1/m²
};

}  // namespace

Coverage::Coverage(const Floor& floor) : floor_(&floor), open_(floor.reachable()) {
    covered_at_.reserve(floor.reachable_count());
}

void Coverage::sweep_to(double x, double y, std::uint64_t tick) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    if (step_squared_ < 0.0) {  // the start
        checked_x_ = x;
        checked_y_ = y;
    }
    // near() looks one margin ahead: a longer way, of a fast robot, is taken in pieces
    const Place from{checked_x_, checked_y_};
    const double squared = (x - from.x) * (x - from.x) + (y - from.y) * (y - from.y);
    if (squared > floor_->margin() * floor_->margin()) {
        const double pieces = std::ceil(std::sqrt(squared) / floor_->margin());
        for (double i = 1.0; i < pieces; ++i) {
            const double part = i / pieces;
            sweep_piece({from.x + part * (x - from.x), from.y + part * (y - from.y)}, tick);
        }
    }
    sweep_piece({x, y}, tick);
}

void Coverage::sweep_piece(Place to, std::uint64_t tick) {
    const CellGrid& grid = floor_->grid();
    const double u = (to.x - grid.left) * floor_->per_cell();
    const double v = (to.y - grid.top) * floor_->per_cell();
    const int column = static_cast<int>(u);
    const int first_row = static_cast<int>(v) + floor_->first_offset();
    const std::span<const CellSpan> spans = floor_->near(u - column, v - static_cast<int>(v));

    const Way way(checked_x_, checked_y_, to.x, to.y);
    const double radius_squared = floor_->radius() * floor_->radius();
    const double farthest = floor_->radius() + most_step * grid.cell;
    double nearest_squared = farthest * farthest;  // of the open cells, from (x, y)

    const int begin = std::max(0, -first_row);
    const int end = std::min(static_cast<int>(spans.size()), grid.rows - first_row);
    for (int i = begin; i < end; ++i) {
        const int row = first_row + i;
        const int first = std::max(0, column + spans[static_cast<std::size_t>(i)].first);
        const int last =
            std::min(grid.columns - 1, column + spans[static_cast<std::size_t>(i)].last);
        if (last < first) continue;
        const double dy = grid.centre_y(row) - to.y;
        for (int word = first / 64; word <= last / 64; ++word) {
            std::uint64_t open = open_.bits(row, word) & columns_in(word * 64, first, last);
            std::uint64_t covered = 0;
            for (; open != 0; open &= open - 1) {
                const double dx = grid.centre_x(word * 64 + std::countr_zero(open)) - to.x;
                const bool inside = way.squared_distance(dx, dy) <= radius_squared;
                covered |= inside ? open & (~open + 1) : 0;
                nearest_squared =
                    std::min(nearest_squared, inside ? nearest_squared : dx * dx + dy * dy);
            }
            if (covered == 0) continue;
            open_.erase_bits(row, word, covered);
            for (; covered != 0; covered &= covered - 1)
                covered_at_.push_back(tick);
        }
    }

    checked_x_ = to.x;
    checked_y_ = to.y;
    const double step =
        std::max(std::sqrt(nearest_squared) - floor_->radius(), least_step * grid.cell);
    step_squared_ = step * step;
}

double Coverage::area() const {
    return static_cast<double>(covered_count()) * floor_->grid().cell * floor_->grid().cell;
}

double Coverage::share() const {
    if (floor_->reachable_count() == 0) return 0.0;
    return static_cast<double>(covered_count()) / static_cast<double>(floor_->reachable_count());
}

double Coverage::share_at(std::uint64_t tick) const {
    if (floor_->reachable_count() == 0) return 0.0;
    return static_cast<double>(count_at(tick)) / static_cast<double>(floor_->reachable_count());
}

std::size_t Coverage::count_at(std::uint64_t tick) const {
    const auto later = std::upper_bound(covered_at_.begin(), covered_at_.end(), tick);
    return static_cast<std::size_t>(later - covered_at_.begin());
}

std::optional<std::uint64_t> Coverage::tick_of(double share) const {
    const double cells = std::ceil(share * static_cast<double>(floor_->reachable_count()));
    const auto needed = static_cast<std::size_t>(std::max(1.0, cells));
    if (needed > covered_at_.size()) return {};
    return covered_at_[needed - 1];
}

double Coverage::largest_gap() const {
    const double cell = floor_->grid().cell;
    return static_cast<double>(largest_gap_count()) * cell * cell;
}

std::size_t Coverage::largest_gap_count() const {
    const CellGrid& grid = floor_->grid();
    CellSet rest = open_;
    std::size_t largest = 0;
    std::vector<std::pair<int, int>> found;
    const auto take = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) return;
        if (!rest.contains(column, row)) return;
        rest.erase(column, row);
        found.emplace_back(column, row);
    };
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            found.clear();
            take(column, row);
            for (std::size_t i = 0; i < found.size(); ++i) {
                const auto [x, y] = found[i];
                take(x - 1, y);
                take(x + 1, y);
                take(x, y - 1);
                take(x, y + 1);
            }
            largest = std::max(largest, found.size());
        }
    }
    return largest;
}

}  // namespace trellis
