// Tables, explanations and JSON.
// SPDX-License-Identifier: MIT
#include "runner/compare_report.h"

#include "core/number.h"
#include "runner/explanation.h"
#include "runner/json_writer.h"
#include "runner/statistics.h"
#include "runner/table.h"

#include <algorithm>
#include <utility>

namespace trellis {

namespace {

struct Field {
    std::string_view name;
    double Roomba::*number;
};
constexpr Field fields[] = {{"x", &Roomba::x},
                            {"y", &Roomba::y},
                            {"rotation", &Roomba::rotation},
                            {"v", &Roomba::v},
                            {"w", &Roomba::w}};

std::string joined(const std::vector<std::string_view>& words) {
    std::string out;
    for (const std::string_view word : words) {
        out += (out.empty() ? "" : ", ") + std::string(word);
    }
    return out;
}

/// Both runs at the tick in which they part, side by side.
std::string situation(const Parting& parting) {
    const Contestant& a = parting.a;
    const Contestant& b = parting.b;
    std::vector<std::vector<std::string>> rows{{"", a.entrant().file, b.entrant().file}};
    rows.push_back(
        {"leaf", std::string(a.episode().row().leaf), std::string(b.episode().row().leaf)});
    rows.push_back(
        {"its ticks", std::to_string(a.ticks_of(a.row())), std::to_string(b.ticks_of(b.row()))});
    for (const Field& field : fields) {
        rows.push_back({std::string(field.name), print_number(a.episode().robot().*field.number),
                        print_number(b.episode().robot().*field.number)});
    }
    rows.push_back(
        {"bumper", a.episode().robot().bumper ? "1" : "0", b.episode().robot().bumper ? "1" : "0"});
    return aligned(rows);
}

/// Everything about the way a match parts, without its name.
std::string parting_text(const Match& match) {
    if (!match.parting) {
        return "no difference in " + std::to_string(match.a.episode().state().tick) + " ticks\n";
    }
    const Parting& parting = *match.parting;
    std::string out = "they differ first in tick " +
                      std::to_string(parting.a.episode().state().tick) + " (" +
                      fixed(parting.a.episode().row().time, 3) + " s), in " +
                      joined(parting.columns) + "\n\n" + situation(parting) + '\n';
    for (const std::string& line : explain(parting.a, parting.b)) {
        out += line + '\n';
    }
    return out;
}

/// Counts of a single run are whole; lengths are told to the millimetre.
int digits(const Statistic& statistic, bool several) {
    if (statistic.unit == "m") { return 3; }
    return statistic.unit.empty() && !several ? 0 : 1;
}

std::string cell(const Statistic& statistic, bool has, const Spread& spread, bool several) {
    if (!has) { return "-"; }
    std::string out = fixed(spread.mean, digits(statistic, several));
    if (several) { out += " ± " + fixed(spread.deviation, digits(statistic, several)); }
    return statistic.unit.empty() ? out : out + ' ' + statistic.unit;
}

std::string statistics_text(const std::vector<Match>& matches) {
    const bool several = matches.size() > 1;
    const Match& first = matches.front();
    const std::string over =
        several ? "mean ± spread of " + std::to_string(matches.size()) + " runs" : "whole run";
    std::vector<std::vector<std::string>> rows{
        {over, first.a.entrant().file, first.b.entrant().file}};
    for (const Statistic& s : statistics(matches)) {
        rows.push_back({s.name, cell(s, s.has_a, s.a, several), cell(s, s.has_b, s.b, several)});
    }
    return aligned(rows);
}

std::string distance_text(const std::vector<Match>& matches) {
    const Match& widest =
        *std::max_element(matches.begin(), matches.end(),
                          [](const Match& a, const Match& b) { return a.distance < b.distance; });
    if (widest.distance == 0.0) { return "the robots are never apart\n"; }
    std::vector<double> distances;
    for (const Match& match : matches) {
        distances.push_back(match.distance);
    }
    std::string out = "the robots are at most " + fixed(widest.distance, 4) + " m apart (" +
                      widest.random + ", tick " + std::to_string(widest.distance_tick) + ")";
    if (matches.size() > 1) {
        const Spread all = spread(distances);
        out += "; mean of the runs " + fixed(all.mean, 4) + " ± " + fixed(all.deviation, 4) + " m";
    }
    return out + '\n';
}

void add_contestant(JsonWriter& json, std::string_view key, const Contestant& contestant) {
    json.begin_object(key).text("leaf", contestant.episode().row().leaf);
    json.count("leaf_ticks", contestant.ticks_of(contestant.row()));
    for (const Field& field : fields) {
        json.number(field.name, contestant.episode().robot().*field.number);
    }
    json.boolean("bumper", contestant.episode().robot().bumper);
    json.text("did", describe_tick(contestant)).end_object();
}

void add_match(JsonWriter& json, const Match& match) {
    json.begin_object().text("random", match.random).boolean("equal", !match.parting);
    json.count("ticks", match.a.episode().state().tick);
    json.number("distance", match.distance).count("distance_tick", match.distance_tick);
    if (match.parting) {
        json.begin_object("first").count("tick", match.parting->a.episode().state().tick);
        json.begin_array("columns");
        for (const std::string_view column : match.parting->columns) {
            json.element(column);
        }
        json.end_array();
        add_contestant(json, "a", match.parting->a);
        add_contestant(json, "b", match.parting->b);
        json.begin_array("explanation");
        for (const std::string& line : explain(match.parting->a, match.parting->b)) {
            json.element(line);
        }
        json.end_array().end_object();
    }
    json.end_object();
}

void add_spread(JsonWriter& json, std::string_view key, bool has, const Spread& spread) {
    if (!has) { return; }
    json.begin_object(key).number("mean", spread.mean).number("deviation", spread.deviation);
    json.end_object();
}

}  // namespace

std::string comparison_text(const std::vector<Match>& matches) {
    // matches that part alike are told once
    std::vector<std::pair<std::string, std::string>> groups;  // text, names
    for (const Match& match : matches) {
        const std::string text = parting_text(match);
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const auto& known) { return known.first == text; });
        if (group == groups.end()) {
            groups.emplace_back(text, match.random);
        } else {
            group->second += ", " + match.random;
        }
    }
    std::string out;
    for (const auto& [text, names] : groups) {
        out += names + ": " + text + '\n';
    }
    return out + statistics_text(matches) + '\n' + distance_text(matches);
}

std::string comparison_json(const std::vector<Match>& matches) {
    JsonWriter json;
    const Match& first = matches.front();
    const bool equal = std::none_of(matches.begin(), matches.end(),
                                    [](const Match& m) { return m.parting.has_value(); });
    json.begin_object().text("a", first.a.entrant().file).text("b", first.b.entrant().file);
    json.boolean("equal", equal).number("dt", first.a.episode().setup().dt).begin_array("runs");
    for (const Match& match : matches) {
        add_match(json, match);
    }
    json.end_array().begin_array("statistics");
    for (const Statistic& s : statistics(matches)) {
        json.begin_object().text("name", s.name).text("unit", s.unit);
        add_spread(json, "a", s.has_a, s.a);
        add_spread(json, "b", s.has_b, s.b);
        json.end_object();
    }
    return std::move(json.end_array().end_object()).finish();
}

}  // namespace trellis
