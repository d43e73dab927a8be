// Sums over seeds.
// SPDX-License-Identifier: MIT
#include "runner/sweep/summary.h"

#include "runner/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trellis {
namespace {

/// What is summarised of a row.
struct Column {
    const char* name;
    const char* unit;
    double RowValues::*value;
};
constexpr std::array columns{
    Column{"covered", "%", &RowValues::covered},
    Column{"path", "m", &RowValues::path},
    Column{"overlap", "", &RowValues::overlap},
    Column{"turns", "", &RowValues::turns},
    Column{"bumps", "", &RowValues::bumps},
    Column{"largest_gap", "m²", &RowValues::largest_gap},
    Column{"dirt", "", &RowValues::dirt},
};

/// The values of a case at one of the times, by seed.
std::vector<double> over_seeds(const SweepPlan& plan, const Results& results, std::size_t number,
                               std::size_t time, double RowValues::*value) {
    std::vector<double> values;
    for (std::uint64_t seed = 0; seed < plan.spec().seeds; ++seed) {
        const std::uint64_t run = number * plan.spec().seeds + seed;
        values.push_back(values_of(plan, run, results[run]->stops[time]).*value);
    }
    return values;
}

CaseSummary of_case(const SweepPlan& plan, const Results& results, std::size_t number,
                    std::size_t time) {
    CaseSummary summary{
        .number = number, .time = time, .measures = {}, .reached = {}, .endings = {}};
    for (const Column& column : columns)
        summary.measures.push_back(
            {column.name, column.unit,
             distribution(over_seeds(plan, results, number, time, column.value))});
    std::array<std::size_t, endings.size()> counts{};
    for (std::uint64_t seed = 0; seed < plan.spec().seeds; ++seed) {
        const MeasuredRun& run = *results[number * plan.spec().seeds + seed];
        const Measures& stop = run.stops[time];
        ++counts[static_cast<std::size_t>(stop.ending)];
        for (std::size_t i = 0; i < milestones.size(); ++i) {
            if (const std::optional<double> at = reached_by(plan, run, stop, i))
                summary.reached[i].push_back(*at);
        }
    }
    for (std::vector<double>& times : summary.reached)
        std::sort(times.begin(), times.end());
    for (const Ending ending : endings) {
        if (const std::size_t count = counts[static_cast<std::size_t>(ending)]; count != 0)
            summary.endings.emplace_back(ending, count);
    }
    return summary;
}

PairSummary of_pair(const SweepPlan& plan, const Results& results, std::size_t number,
                    std::size_t baseline, std::size_t time) {
    PairSummary pair{.number = number, .baseline = baseline, .time = time, .difference = {}};
    std::vector<double> differences = over_seeds(plan, results, number, time, &RowValues::covered);
    const std::vector<double> base = over_seeds(plan, results, baseline, time, &RowValues::covered);
    for (std::size_t i = 0; i < base.size(); ++i) {
        double& difference = differences[i] -= base[i];
        ++(difference > 0.0 ? pair.more : difference < 0.0 ? pair.less : pair.equal);
    }
    pair.difference = distribution(std::move(differences));
    return pair;
}

}  // namespace

// Cornish and Fisher's expansion around the normal quantile (Abramowitz and Stegun 26.7.5); for one
// and two degrees of freedom there are closed forms.
double student_95(std::size_t freedom) {
    constexpr double p = 0.975;
    if (freedom <= 1) return std::tan(std::numbers::pi * (p - 0.5));
    if (freedom == 2) return (2.0 * p - 1.0) * std::sqrt(2.0 / (4.0 * p * (1.0 - p)));
    constexpr double z = 1.959963984540054;  // the normal quantile of p
    const double n = static_cast<double>(freedom);
    const double z2 = z * z;
    return z + z * (z2 + 1.0) / (4.0 * n) + z * ((5.0 * z2 + 16.0) * z2 + 3.0) / (96.0 * n * n) +
           z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / (384.0 * n * n * n) +
           z * ((((79.0 * z2 + 776.0) * z2 + 1482.0) * z2 - 1920.0) * z2 - 945.0) /
               (92160.0 * n * n * n * n);
}

double percentile(const std::vector<double>& sorted, double percent) {
    const double at = percent / 100.0 * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    if (below + 1 == sorted.size()) return sorted.back();
    const double part = at - static_cast<double>(below);
    return sorted[below] + part * (sorted[below + 1] - sorted[below]);
}

Distribution distribution(std::vector<double> values) {
    Distribution all{.count = values.size()};
    if (values.empty()) return all;
    const Spread around = spread(values);
    all.mean = around.mean;
    all.deviation = around.deviation;
    if (values.size() > 1)
        all.half_width = student_95(values.size() - 1) * around.deviation /
                         std::sqrt(static_cast<double>(values.size()));
    std::sort(values.begin(), values.end());
    for (std::size_t i = 0; i < percentiles.size(); ++i)
        all.percentile[i] = percentile(values, percentiles[i]);
    return all;
}

int PairSummary::sign() const {
    if (difference.count < 2) return 0;
    if (difference.mean - difference.half_width > 0.0) return 1;
    return difference.mean + difference.half_width < 0.0 ? -1 : 0;
}

SweepSummary summarised(const SweepPlan& plan, const Results& results) {
    SweepSummary summary;
    const std::vector<SweepCase>& cases = plan.cases();
    for (std::size_t time = 0; time < plan.spec().times.size(); ++time) {
        std::vector<std::optional<std::size_t>> baselines(plan.spec().worlds.size());
        for (std::size_t number = 0; number < cases.size(); ++number) {
            summary.cases.push_back(of_case(plan, results, number, time));
            std::optional<std::size_t>& baseline = baselines[cases[number].world];
            if (baseline)
                summary.pairs.push_back(of_pair(plan, results, number, *baseline, time));
            else
                baseline = number;
        }
    }
    return summary;
}

std::string case_words(const SweepPlan& plan, const SweepCase& one) {
    const SweepSpec& spec = plan.spec();
    std::string words = spec.behaviours[one.behaviour].name;
    for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
        if (!one.values[i].empty())
            words += ' ' + spec.parameters[i].name.text + '=' + one.values[i];
    }
    return spec.worlds.size() == 1 ? words : words + ", " + spec.worlds[one.world].text;
}

}  // namespace trellis
