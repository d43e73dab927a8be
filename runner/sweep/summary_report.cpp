// The same numbers twice: rounded for people, in full for programs.
// SPDX-License-Identifier: MIT
#include "runner/sweep/summary_report.h"

#include "runner/json_writer.h"
#include "runner/table.h"

#include <algorithm>

namespace trellis {
namespace {

using Table = std::vector<std::vector<std::string>>;

/// Which milestone the tables show.
constexpr std::size_t shown_milestone = 2;

/// Of one seed there is neither a spread nor an interval.
std::string deviation(const Distribution& of) {
    return of.count < 2 ? "-" : fixed(of.deviation, 1);
}
std::string interval(const Distribution& of) {
    if (of.count < 2) return "-";
    return fixed(of.mean - of.half_width, 1) + " to " + fixed(of.mean + of.half_width, 1);
}

std::string ending_words(const CaseSummary& summary) {
    std::string words;
    for (const auto& [ending, count] : summary.endings) {
        if (ending == Ending::time) continue;
        words += (words.empty() ? "" : ", ") + std::to_string(count) + ' ' +
                 std::string(name_of(ending));
    }
    return words;
}

Table case_table(const SweepPlan& plan, const SweepSummary& summary, std::size_t time) {
    Table rows{{"covered, %", "mean", "sd", "95 % interval"}};
    for (const int percent : percentiles)
        rows[0].push_back(std::to_string(percent) + " %");
    rows[0].push_back(std::to_string(milestones[shown_milestone]) + " % reached");
    rows[0].emplace_back("ended by");
    for (const CaseSummary& one : summary.cases) {
        if (one.time != time) continue;
        const Distribution& covered = one.measures.front().over_seeds;
        std::vector<std::string> row{case_words(plan, plan.cases()[one.number]),
                                     fixed(covered.mean, 1), deviation(covered), interval(covered)};
        for (const double value : covered.percentile)
            row.push_back(fixed(value, 1));
        const std::vector<double>& reached = one.reached[shown_milestone];
        row.push_back(reached.empty() ? "-"
                                      : std::to_string(reached.size()) + ", median " +
                                            fixed(percentile(reached, 50.0), 0) + " s");
        row.push_back(ending_words(one));
        rows.push_back(std::move(row));
    }
    return rows;
}

Table pair_table(const SweepPlan& plan, const SweepSummary& summary, std::size_t time) {
    Table rows{
        {"equal seeds, %", "difference", "sd", "95 % interval", "more", "less", "equal", ""}};
    for (const PairSummary& pair : summary.pairs) {
        if (pair.time != time) continue;
        const Distribution& d = pair.difference;
        const int sign = pair.sign();
        rows.push_back({case_words(plan, plan.cases()[pair.number]),
                        (d.mean > 0.0 ? "+" : "") + fixed(d.mean, 1), deviation(d), interval(d),
                        std::to_string(pair.more), std::to_string(pair.less),
                        std::to_string(pair.equal),
                        sign > 0   ? "covers more"
                        : sign < 0 ? "covers less"
                                   : "open"});
    }
    return rows;
}

void add(JsonWriter& json, std::string_view key, const Distribution& of) {
    json.begin_object(key).count("count", of.count).number("mean", of.mean);
    json.number("deviation", of.deviation).begin_array("interval_95");
    json.number({}, of.mean - of.half_width).number({}, of.mean + of.half_width).end_array();
    json.begin_object("percentiles");
    for (std::size_t i = 0; i < percentiles.size(); ++i)
        json.number(std::to_string(percentiles[i]), of.percentile[i]);
    json.end_object().end_object();
}

void add_case(JsonWriter& json, const SweepPlan& plan, std::size_t number, std::size_t time) {
    const SweepSpec& spec = plan.spec();
    const SweepCase& one = plan.cases()[number];
    json.text("behaviour", spec.behaviours[one.behaviour].name);
    json.text("world", spec.worlds[one.world].text).begin_object("parameters");
    for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
        if (!one.values[i].empty()) json.text(spec.parameters[i].name.text, one.values[i]);
    }
    json.end_object().number("time", spec.times[time]);
}

}  // namespace

std::string summary_text(const SweepPlan& plan, const SweepSummary& summary) {
    const SweepSpec& spec = plan.spec();
    std::string out;
    for (std::size_t time = 0; time < spec.times.size(); ++time) {
        out += out.empty() ? "" : "\n";
        out += "after " + brief(spec.times[time]) + " s, seeds " + std::to_string(spec.first_seed) +
               " to " +
               std::to_string(spec.first_seed + static_cast<std::int64_t>(spec.seeds) - 1) + "\n\n";
        out += aligned(case_table(plan, summary, time));
        const Table pairs = pair_table(plan, summary, time);
        if (pairs.size() > 1) out += '\n' + aligned(pairs);
    }
    return out;
}

std::string summary_json(const SweepPlan& plan, const SweepSummary& summary) {
    JsonWriter json;
    json.begin_object().text("name", plan.spec().name).count("seeds", plan.spec().seeds);
    json.begin_array("cases");
    for (const CaseSummary& one : summary.cases) {
        json.begin_object();
        add_case(json, plan, one.number, one.time);
        for (const MeasureSummary& measure : one.measures)
            add(json, measure.name, measure.over_seeds);
        json.begin_object("reached");
        for (std::size_t i = 0; i < milestones.size(); ++i)
            add(json, std::to_string(milestones[i]), distribution(one.reached[i]));
        json.end_object().begin_object("ended");
        for (const auto& [ending, count] : one.endings)
            json.count(name_of(ending), count);
        json.end_object().end_object();
    }
    json.end_array().begin_array("differences");
    for (const PairSummary& pair : summary.pairs) {
        json.begin_object();
        add_case(json, plan, pair.number, pair.time);
        json.text("against", case_words(plan, plan.cases()[pair.baseline]));
        add(json, "covered", pair.difference);
        json.count("more", pair.more).count("less", pair.less).count("equal", pair.equal);
        json.integer("sign", pair.sign()).end_object();
    }
    json.end_array().end_object();
    return std::move(json).finish();
}

}  // namespace trellis
