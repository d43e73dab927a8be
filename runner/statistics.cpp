// Means and spreads.
// SPDX-License-Identifier: MIT
#include "runner/statistics.h"

#include <cmath>

namespace trellis {

namespace {

using Measure = double (*)(const Contestant&, LabelId);

double share(const Contestant& contestant, LabelId label) {
    const std::uint64_t ticks = contestant.episode().state().tick;
    if (ticks == 0) { return 0.0; }
    return 100.0 * static_cast<double>(contestant.tally().ticks[label.index]) /
           static_cast<double>(ticks);
}

double entries(const Contestant& contestant, LabelId label) {
    return static_cast<double>(contestant.tally().entered[label.index]);
}

double bumps(const Contestant& contestant, LabelId) {
    return static_cast<double>(contestant.tally().driven.bumps);
}

double distance(const Contestant& contestant, LabelId) {
    return contestant.tally().driven.distance;
}

Statistic over(const std::vector<Match>& matches, Measure measure, LabelId a, LabelId b) {
    Statistic statistic;
    std::vector<double> a_values;
    std::vector<double> b_values;
    for (const Match& match : matches) {
        if (a) { a_values.push_back(measure(match.a, a)); }
        if (b) { b_values.push_back(measure(match.b, b)); }
    }
    statistic.a = spread(a_values);
    statistic.b = spread(b_values);
    statistic.has_a = !a_values.empty();
    statistic.has_b = !b_values.empty();
    return statistic;
}

/// The names of both, those of `a` first.
std::vector<std::string> all_names(const Labels& a, const Labels& b) {
    std::vector<std::string> names = a.names();
    for (const std::string& name : b.names()) {
        if (!a.find(name)) { names.push_back(name); }
    }
    return names;
}

}  // namespace

Spread spread(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    if (values.empty()) { return {}; }
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    const double mean = sum / n;
    double squares = 0.0;
    for (const double value : values) {
        squares += (value - mean) * (value - mean);
    }
    return {mean, values.size() == 1 ? 0.0 : std::sqrt(squares / (n - 1.0))};
}

std::vector<Statistic> statistics(const std::vector<Match>& matches) {
    std::vector<Statistic> all;
    if (matches.empty()) { return all; }
    const auto add = [&](std::string name, std::string unit, Measure measure, LabelId a,
                         LabelId b) {
        all.push_back(over(matches, measure, a, b));
        all.back().name = std::move(name);
        all.back().unit = std::move(unit);
    };
    const Labels& a = matches.front().a.entrant().labels;
    const Labels& b = matches.front().b.entrant().labels;
    const std::vector<std::string> names = all_names(a, b);
    for (const std::string& name : names) {
        add("share of " + name, "%", share, a.find(name), b.find(name));
    }
    for (const std::string& name : names) {
        add("entered " + name, "", entries, a.find(name), b.find(name));
    }
    // of the whole run: any label will do
    const LabelId whole{0};
    add("bumps", "", bumps, whole, whole);
    add("driven", "m", distance, whole, whole);
    return all;
}

}  // namespace trellis
