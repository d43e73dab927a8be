// The same measures twice: rounded for people, in full for programs.
// SPDX-License-Identifier: MIT
#include "runner/coverage_report.h"

#include "core/number.h"
#include "runner/table.h"
#include "sim/bridge/measured_run.h"

#include <optional>
#include <vector>

namespace trellis {

namespace {

/// The curve of coverage over time has so many steps.
constexpr std::uint64_t steps = 10;

double seconds(const CoverageReport& report, std::uint64_t tick) {
    return static_cast<double>(tick) * report.dt;
}

double overlap(const CoverageReport& report) {
    return report.tally.driven.overlap(report.coverage.floor().radius(), report.coverage.area());
}

std::optional<std::uint64_t> reached(const CoverageReport& report, int percent) {
    return report.coverage.tick_of(percent / 100.0);
}

std::string percent(double share) {
    return fixed(100.0 * share, 1) + " %";
}

std::string milestone_table(const CoverageReport& report) {
    std::vector<std::vector<std::string>> rows{{"part"}, {"after"}};
    for (const int part : milestones) {
        const std::optional<std::uint64_t> tick = reached(report, part);
        rows[0].push_back(std::to_string(part) + " %");
        rows[1].push_back(tick ? fixed(seconds(report, *tick), 1) + " s" : "-");
    }
    return aligned(rows);
}

std::string curve_table(const CoverageReport& report) {
    std::vector<std::vector<std::string>> rows{{"time"}, {"covered"}};
    for (std::uint64_t step = 1; step <= steps; ++step) {
        const std::uint64_t tick = report.ticks * step / steps;
        rows[0].push_back(fixed(seconds(report, tick), 1) + " s");
        rows[1].push_back(percent(report.coverage.share_at(tick)));
    }
    return aligned(rows);
}

}  // namespace

std::string coverage_text(const CoverageReport& report) {
    const Coverage& coverage = report.coverage;
    const Floor& floor = coverage.floor();
    std::string out = "covered   " + percent(coverage.share()) + " of " + fixed(floor.area(), 3) +
                      " m², cells of " + print_number(floor.grid().cell) + " m\n";
    out += "swept     " + fixed(overlap(report), 2) + " times over, " +
           std::to_string(report.tally.driven.turns) +
           (report.tally.driven.turns == 1 ? " turn" : " turns") + " on the spot\n";
    out += "gap       " + fixed(coverage.largest_gap(), 3) + " m², the largest\n\n";
    return out + milestone_table(report) + '\n' + curve_table(report);
}

void add_coverage(JsonWriter& json, const CoverageReport& report) {
    const Coverage& coverage = report.coverage;
    json.begin_object("coverage").number("cell", coverage.floor().grid().cell);
    json.number("reachable", coverage.floor().area()).number("covered", coverage.area());
    json.number("share", coverage.share()).number("overlap", overlap(report));
    json.count("turns", report.tally.driven.turns).number("largest_gap", coverage.largest_gap());
    json.begin_object("reached");
    for (const int part : milestones) {
        const std::optional<std::uint64_t> tick = reached(report, part);
        if (tick) {
            json.number(std::to_string(part), seconds(report, *tick));
        } else {
            json.null(std::to_string(part));
        }
    }
    json.end_object().begin_array("curve");
    for (std::uint64_t step = 1; step <= steps; ++step) {
        const std::uint64_t tick = report.ticks * step / steps;
        json.begin_object().number("time", seconds(report, tick));
        json.number("share", coverage.share_at(tick)).end_object();
    }
    json.end_array().end_object();
}

}  // namespace trellis
