// The columns, twice: their names for CSV, their values for both.
// SPDX-License-Identifier: MIT
#include "runner/sweep/rows.h"

#include "runner/json_writer.h"
#include "runner/table.h"

#include <algorithm>

namespace trellis {
namespace {

/// One row on its way into a text.
class Row {
public:
    virtual ~Row() = default;
    virtual void text(const std::string& name, const std::string& value) = 0;
    virtual void number(const std::string& name, std::optional<double> value) = 0;
    virtual void count(const std::string& name, std::int64_t value) = 0;
};

/// RFC 4180: quotes around what has a comma, a quote or a line feed.
std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

class CsvRow : public Row {
public:
    explicit CsvRow(bool names) : names_(names) {}
    void text(const std::string& name, const std::string& value) override {
        if (!line.empty()) line += ',';
        line += csv_field(names_ ? name : value);
    }
    void number(const std::string& name, std::optional<double> value) override {
        text(name, value ? brief(*value) : "");
    }

    void count(const std::string& name, std::int64_t value) override {
        text(name, std::to_string(value));
    }

    std::string line;

private:
    bool names_;
};

class JsonRow : public Row {
public:
    JsonRow() { json.begin_object(); }
    void text(const std::string& name, const std::string& value) override {
        json.text(name, value);
    }
    void number(const std::string& name, std::optional<double> value) override {
        if (value) {
            json.number(name, *value);
        } else {
            json.null(name);
        }
    }

    void count(const std::string& name, std::int64_t value) override { json.integer(name, value); }

    JsonWriter json{JsonWriter::Layout::one_line};
};

double seconds(const SweepPlan& plan, std::uint64_t tick) {
    return static_cast<double>(tick) * plan.spec().dt;
}

/// Cells as % of what can be reached.
double percent(const Floor& floor, std::uint64_t cells) {
    if (floor.reachable_count() == 0) return 0.0;
    return 100.0 * static_cast<double>(cells) / static_cast<double>(floor.reachable_count());
}

void put(Row& row, const SweepPlan& plan, std::uint64_t number, const MeasuredRun& run,
         std::size_t at) {
    const SweepSpec& spec = plan.spec();
    const SweepCase& one = plan.case_of(number);
    const Measures& stop = run.stops[at];
    const RowValues values = values_of(plan, number, stop);
    row.count("run", static_cast<std::int64_t>(number));
    row.text("behaviour", spec.behaviours[one.behaviour].name);
    row.text("world", spec.worlds[one.world].text);
    for (std::size_t i = 0; i < spec.parameters.size(); ++i)
        row.text(spec.parameters[i].name.text, one.values[i]);
    row.count("seed", plan.seed_of(number));
    row.number("time", spec.times[at]);
    row.number("covered", values.covered);
    const std::size_t first_mark = run.curve.size() - spec.marks.size();
    for (std::size_t i = 0; i < spec.marks.size(); ++i) {
        const bool is_over = plan.measuring().curve[first_mark + i] > stop.tick;
        row.number("covered_at_" + brief(spec.marks[i]),
                   is_over ? std::nullopt
                           : std::optional(percent(plan.floor(one), run.curve[first_mark + i])));
    }
    for (std::size_t i = 0; i < milestones.size(); ++i)
        row.number("to_" + std::to_string(milestones[i]), reached_by(plan, run, stop, i));
    row.number("path", values.path);
    row.number("overlap", values.overlap);
    row.count("turns", static_cast<std::int64_t>(stop.driven.turns));
    row.count("bumps", static_cast<std::int64_t>(stop.driven.bumps));
    row.number("largest_gap", values.largest_gap);
    row.number("dirt", values.dirt);
    row.text("ended", std::string(name_of(values.ending)));
    row.number("ended_at", values.ended);
}

}  // namespace

RowValues values_of(const SweepPlan& plan, std::uint64_t run, const Measures& stop) {
    const Floor& floor = plan.floor(plan.case_of(run));
    const double cell_area = floor.grid().cell * floor.grid().cell;
    return {.covered = percent(floor, stop.covered),
            .path = stop.driven.distance,
            .overlap =
                stop.driven.overlap(floor.radius(), static_cast<double>(stop.covered) * cell_area),
            .turns = static_cast<double>(stop.driven.turns),
            .bumps = static_cast<double>(stop.driven.bumps),
            .largest_gap = static_cast<double>(stop.largest_gap) * cell_area,
            .dirt = stop.dirt,
            .ended = seconds(plan, stop.ended),
            .ending = stop.ending};
}

std::optional<double> reached_by(const SweepPlan& plan, const MeasuredRun& run,
                                 const Measures& stop, std::size_t milestone) {
    const std::optional<std::uint64_t> tick = run.reached[milestone];
    if (!tick || *tick > stop.tick) return {};
    return seconds(plan, *tick);
}

std::string rows_header(const SweepPlan& plan, RowFormat format) {
    if (format == RowFormat::json_lines) return {};
    // the names do not depend on what a run came to
    MeasuredRun none;
    none.stops.resize(1);
    none.curve.resize(plan.measuring().curve.size());
    CsvRow row(true);
    put(row, plan, 0, none, 0);
    return row.line + '\n';
}

std::string rows_of(const SweepPlan& plan, std::uint64_t number, const MeasuredRun& run,
                    RowFormat format) {
    std::string text;
    for (std::size_t at = 0; at < run.stops.size(); ++at) {
        if (format == RowFormat::csv) {
            CsvRow row(false);
            put(row, plan, number, run, at);
            text += row.line + '\n';
        } else {
            JsonRow row;
            put(row, plan, number, run, at);
            row.json.end_object();
            text += std::move(row.json).finish();
        }
    }
    return text;
}

}  // namespace trellis
