// The floor of a world as cells: which of them the robot's disc can reach, and which lie near a
// given position. What coverage is measured on. Never changes once it is made: the runs of one
// world share it. Who covered what is not here (sim/coverage.h). Covered by
// tests/sim/floor_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/lab_world.h"
#include "sim/walls.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trellis {

/// The width of a cell unless another one is asked for, m.
inline constexpr double default_cell = 0.05;
/// What widths of a cell make sense, m.
inline constexpr double finest_cell = 0.005;
inline constexpr double coarsest_cell = 1.0;

/// A grid of square cells over a rectangle, row by row. A cell stands for its centre.
struct CellGrid {
    double left = 0.0;           ///< m, of the first column's left side
    double top = 0.0;            ///< m, of the first row's upper side
    double cell = default_cell;  ///< m, width and height of a cell; above 0
    int columns = 0;
    int rows = 0;

    double centre_x(int column) const { return left + (column + 0.5) * cell; }
    double centre_y(int row) const { return top + (row + 0.5) * cell; }
    std::size_t count() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }

    friend bool operator==(const CellGrid&, const CellGrid&) = default;
};

/// The grid that covers a rectangle from its upper left corner on: the last column and row may
/// reach beyond it.
CellGrid grid_over(const Bounds& bounds, double cell);

/// A set of a grid's cells: one bit each, every row beginning with a word of its own.
class CellSet {
public:
    CellSet() = default;
    explicit CellSet(const CellGrid& grid)
        : words_per_row_((static_cast<std::size_t>(grid.columns) + 63) / 64),
          words_(words_per_row_ * static_cast<std::size_t>(grid.rows)) {}

    bool contains(int column, int row) const { return (word(column, row) >> (column & 63)) & 1U; }
    void insert(int column, int row) { word(column, row) |= std::uint64_t{1} << (column & 63); }
    void erase(int column, int row) { word(column, row) &= ~(std::uint64_t{1} << (column & 63)); }
    std::size_t size() const;

    /// The 64 cells of a row that the word number `i` holds, lowest bit first.
    std::uint64_t bits(int row, int i) const {
        return words_[static_cast<std::size_t>(row) * words_per_row_ + static_cast<std::size_t>(i)];
    }
    void erase_bits(int row, int i, std::uint64_t bits) {
        words_[static_cast<std::size_t>(row) * words_per_row_ + static_cast<std::size_t>(i)] &=
            ~bits;
    }

    friend bool operator==(const CellSet&, const CellSet&) = default;

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * words_per_row_ +
               static_cast<std::size_t>(column) / 64;
    }
    std::uint64_t word(int column, int row) const { return words_[index(column, row)]; }
    std::uint64_t& word(int column, int row) { return words_[index(column, row)]; }

    std::size_t words_per_row_ = 0;
    std::vector<std::uint64_t> words_;
};

/// Columns of one row of cells, relative to some column; none if last < first.
struct CellSpan {
    std::int16_t first = 0;
    std::int16_t last = -1;
};

/// The cells that a robot's disc can cover, and a table that finds those near a position.
class Floor {
public:
    /// `reachable` is of `grid`. The robot's centre stays between (x_least, y_least) and (x_most,
    /// y_most), in m.
    struct Parts {
        CellGrid grid;
        CellSet reachable;
        double radius = 0.0;  ///< m, of the robot
        double x_least = 0.0, x_most = 0.0;
        double y_least = 0.0, y_most = 0.0;
    };
    explicit Floor(Parts parts);

    const CellGrid& grid() const { return parts_.grid; }
    /// Cells of which the disc can come to cover the centre.
    const CellSet& reachable() const { return parts_.reachable; }
    std::size_t reachable_count() const { return reachable_count_; }
    double radius() const { return parts_.radius; }  ///< m
    /// Of all reachable cells, m².
    double area() const {
        return static_cast<double>(reachable_count_) * grid().cell * grid().cell;
    }

    /// The nearest place to x or y where the robot's centre can be, m; NaN stays NaN.
    double allowed_x(double x) const { return cut(x, parts_.x_least, parts_.x_most); }
    double allowed_y(double y) const { return cut(y, parts_.y_least, parts_.y_most); }

    /// How far outside the disc near() still looks, m: one cell.
    double margin() const { return grid().cell; }
    double per_cell() const { return per_cell_; }  ///< 1/m: cells in a metre
    /// The row offset of the first span that near() returns; the last one's is its negative.
    int first_offset() const { return -reach_; }
    /// All cells within radius() + margin() of a position, and a few beyond: a span for each row
    /// from first_offset() on, relative to the position's own cell. The position is given as its
    /// part of the cell in both directions, from 0 to below 1.
    std::span<const CellSpan> near(double part_x, double part_y) const;

private:
    static double cut(double value, double least, double most) {
        return value < least ? least : value > most ? most : value;
    }

    Parts parts_;
    std::size_t reachable_count_ = 0;
    double per_cell_ = 0.0;        // 1/m
    int reach_ = 0;                // cells
    std::vector<CellSpan> spans_;  // for each part of a cell, 2 reach_ + 1 of them
};

/// The floor of the lab's room: all but the corners' roundings can be reached.
Floor floor_of(const LabWorld& world, double cell = default_cell);

/// Places where the centre of the disc can be, and to which it can come from `start` without a
/// jump: at most `apart` m from each other, those beside walls touching them. Empty if the disc
/// does not fit at `start`.
std::vector<Point> places_of(const Walls& walls, Point start, double apart);

/// The floor among walls that the disc can come to from `start` without a jump. Places of its
/// centre are tried a quarter of its radius apart, or a cell if that is less: a passage that is
/// wider than the disc is found, one that is narrower by less than 1e-9 m too. Empty if the disc
/// does not fit at `start`.
Floor floor_of(const Walls& walls, Point start, double cell = default_cell);

}  // namespace trellis
