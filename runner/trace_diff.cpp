// trellis trace diff: whether two recorded runs are the same, and where they first are not.
// SPDX-License-Identifier: MIT
#include "core/number.h"
#include "runner/commands.h"
#include "runner/json_writer.h"
#include "runner/trace_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <utility>

namespace trellis {

namespace {

/// Columns that may differ by the tolerance; all others are compared as texts.
constexpr std::array<std::string_view, 6> measured{"t", "x", "y", "rotation", "v", "w"};

constexpr std::size_t shown_differences = 3;  // rows
constexpr std::size_t shown_before = 2;       // rows in front of the first

/// Whether two fields of a column are the same.
bool same_field(std::string_view column, const std::string& a, const std::string& b,
                double tolerance) {
    if (a == b) { return true; }
    if (std::find(measured.begin(), measured.end(), column) == measured.end()) { return false; }
    const ParsedNumber left = parse_whole_number(a);
    const ParsedNumber right = parse_whole_number(b);
    return left.length != 0 && right.length != 0 &&
           std::fabs(left.value - right.value) <= tolerance;
}

/// A comparison of two traces with the same columns.
class TraceDiff {
public:
    TraceDiff(const TraceTable& a, const TraceTable& b, double tolerance)
        : a_(a), b_(b), tolerance_(tolerance) {
        for (std::size_t row = 0; row < std::min(a.rows.size(), b.rows.size()); ++row) {
            if (!columns(row).empty()) { rows_.push_back(row); }
        }
    }

    bool equal() const { return rows_.empty() && a_.rows.size() == b_.rows.size(); }
    std::string text(const TraceDiffArguments& arguments) const;
    std::string json() const;

private:
    /// Of a row, the columns that differ.
    std::vector<std::size_t> columns(std::size_t row) const {
        std::vector<std::size_t> differing;
        for (std::size_t i = 0; i < a_.columns.size(); ++i) {
            if (!same_field(a_.columns[i], a_.rows[row][i], b_.rows[row][i], tolerance_)) {
                differing.push_back(i);
            }
        }
        return differing;
    }
    std::string names(std::size_t row) const {
        std::string out;
        for (const std::size_t column : columns(row)) {
            out += (out.empty() ? "" : ", ") + a_.columns[column];
        }
        return out;
    }
    std::string context() const;

    const TraceTable& a_;
    const TraceTable& b_;
    double tolerance_;
    std::vector<std::size_t> rows_;  // that differ
};

// The first rows that differ, each with what differs in it, and what came before.
std::string TraceDiff::context() const {
    std::string out;
    const std::size_t first = rows_.front();
    for (std::size_t row = first - std::min(first, shown_before); row < first; ++row) {
        out += "  " + std::string(a_.lines[row]) + '\n';
    }
    for (std::size_t i = 0; i < std::min(rows_.size(), shown_differences); ++i) {
        const std::size_t row = rows_[i];
        out += "- " + std::string(a_.lines[row]) + '\n';
        out += "+ " + std::string(b_.lines[row]) + "\n  (" + names(row) + ")\n";
    }
    return out;
}

std::string TraceDiff::text(const TraceDiffArguments& arguments) const {
    const std::size_t common = std::min(a_.rows.size(), b_.rows.size());
    std::string out;
    if (!rows_.empty()) { out += "--- " + arguments.a + "\n+++ " + arguments.b + '\n' + context(); }
    if (!equal()) {
        out += std::to_string(rows_.size()) + " of " + std::to_string(common) + " rows differ\n";
    } else {
        out += std::to_string(common) + (common == 1 ? " row is" : " rows are") + " the same\n";
    }
    if (a_.rows.size() != b_.rows.size()) {
        out += arguments.a + " has " + std::to_string(a_.rows.size()) + " rows, " + arguments.b +
               " has " + std::to_string(b_.rows.size()) + '\n';
    }
    return out;
}

std::string TraceDiff::json() const {
    JsonWriter json;
    json.begin_object().boolean("equal", equal()).number("tolerance", tolerance_);
    json.begin_array("rows").count({}, a_.rows.size()).count({}, b_.rows.size()).end_array();
    json.count("differing", rows_.size()).begin_array("first");
    for (std::size_t i = 0; i < std::min(rows_.size(), shown_differences); ++i) {
        json.begin_object().count("row", rows_[i]).begin_array("columns");
        for (const std::size_t column : columns(rows_[i])) {
            json.begin_object().text("name", a_.columns[column]);
            json.text("a", a_.rows[rows_[i]][column]).text("b", b_.rows[rows_[i]][column]);
            json.end_object();
        }
        json.end_array().end_object();
    }
    return std::move(json.end_array().end_object()).finish();
}

}  // namespace

void add_options(CLI::App& app, TraceDiffArguments& arguments) {
    app.add_option("A", arguments.a, "a trace, as trellis run --trace FILE.csv writes it, or -")
        ->required();
    app.add_option("B", arguments.b, "another")->required();
    app.add_option("--tolerance", arguments.tolerance,
                   "by how much times, poses and velocities may differ; 1e-9 if not given")
        ->type_name("N")
        ->check(CLI::NonNegativeNumber);
    add_format(app, arguments.format);
}

Exit execute(const TraceDiffArguments& arguments, Streams& streams) {
    const std::optional<std::string> a_text = read_text(arguments.a, streams);
    const std::optional<std::string> b_text = read_text(arguments.b, streams);
    if (!a_text || !b_text) { return Exit::file; }
    Diagnostics diagnostics;
    const auto a = read_trace(shown_name(arguments.a), *a_text, diagnostics);
    const auto b = read_trace(shown_name(arguments.b), *b_text, diagnostics);
    show(diagnostics, streams);
    if (!a || !b) { return Exit::file; }
    if (a->columns != b->columns) {
        return complain(streams, Exit::no,
                        "the columns of " + arguments.a + " and " + arguments.b + " differ");
    }
    const TraceDiff diff(*a, *b, arguments.tolerance);
    streams.out << (arguments.format == Format::json ? diff.json() : diff.text(arguments));
    return diff.equal() ? Exit::yes : Exit::no;
}

}  // namespace trellis
