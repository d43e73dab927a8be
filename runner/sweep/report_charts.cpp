// The pictures of the page that show numbers. Colours are classes: the page's style knows them.
// SPDX-License-Identifier: MIT
#include "runner/sweep/report.h"
#include "runner/sweep/summary.h"
#include "runner/table.h"
#include "sim/svg.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace trellis {
namespace {

using svg::number;

// layout of the curves, in pixels
constexpr double left = 48.0;
constexpr double top = 12.0;
constexpr double width = 560.0;
constexpr double height = 300.0;
constexpr double labels = 220.0;  // right of the curves
constexpr double bottom = 44.0;
constexpr double between = 16.0;  // at least, from label to label
constexpr std::size_t most_cases = 8;

std::string text(double x, double y, const std::string& attributes, const std::string& words) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + attributes + ">" +
           svg::escaped(words) + "</text>\n";
}

double percent(const Floor& floor, std::uint64_t cells) {
    return floor.reachable_count() == 0
               ? 0.0
               : 100.0 * static_cast<double>(cells) / static_cast<double>(floor.reachable_count());
}

/// Percentiles over the seeds, by step of the curve, from the start on, in %.
struct Curve {
    std::size_t number = 0;  // SweepPlan::cases
    std::vector<double> low, middle, high;
};

Curve curve_of(const SweepPlan& plan, const Results& results, std::size_t number_of_case) {
    Curve curve{.number = number_of_case, .low = {0.0}, .middle = {0.0}, .high = {0.0}};
    const SweepCase& one = plan.cases()[number_of_case];
    for (std::size_t step = 0; step < curve_steps; ++step) {
        std::vector<double> values;
        for (std::uint64_t seed = 0; seed < plan.spec().seeds; ++seed) {
            const MeasuredRun& run = *results[number_of_case * plan.spec().seeds + seed];
            values.push_back(percent(plan.floor(one), run.curve[step]));
        }
        std::sort(values.begin(), values.end());
        curve.low.push_back(percentile(values, 25.0));
        curve.middle.push_back(percentile(values, 50.0));
        curve.high.push_back(percentile(values, 75.0));
    }
    return curve;
}

/// The cases of a world that are shown.
std::vector<Curve> curves_of(const SweepPlan& plan, const Results& results, std::size_t world) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < plan.cases().size(); ++i) {
        if (plan.cases()[i].world == world) curves.push_back(curve_of(plan, results, i));
    }
    if (curves.size() <= most_cases) return curves;
    std::stable_sort(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
        return a.middle.back() > b.middle.back();
    });
    curves.resize(most_cases);
    std::sort(curves.begin(), curves.end(),
              [](const Curve& a, const Curve& b) { return a.number < b.number; });
    return curves;
}

double x_of(std::size_t step) {
    return left + width * static_cast<double>(step) / static_cast<double>(curve_steps);
}
double y_of(double covered) {
    return top + height * (1.0 - covered / 100.0);
}

std::string line_of(const std::vector<double>& values) {
    std::string data;
    for (std::size_t i = 0; i < values.size(); ++i)
        data += (i == 0 ? "M" : "L") + number(x_of(i)) + ' ' + number(y_of(values[i]));
    return data;
}

std::string band_of(const Curve& curve) {
    std::string data = line_of(curve.low);
    for (std::size_t i = curve.high.size(); i-- > 0;)
        data += "L" + number(x_of(i)) + ' ' + number(y_of(curve.high[i]));
    return data + 'Z';
}

std::string axes(double seconds) {
    std::string out;
    for (int covered = 0; covered <= 100; covered += 20) {
        const double y = y_of(covered);
        out += "<path class=\"grid\" d=\"M" + number(left) + ' ' + number(y) + 'h' + number(width) +
               "\"/>\n";
        out += text(left - 8.0, y + 4.0, "class=\"axis\" text-anchor=\"end\"",
                    std::to_string(covered) + (covered == 100 ? " %" : ""));
    }
    const bool minutes = seconds >= 300.0;
    for (int quarter = 0; quarter <= 4; ++quarter) {
        const double at = seconds * quarter / 4.0;
        const double x = left + width * quarter / 4.0;
        out +=
            text(x, top + height + 20.0, "class=\"axis\" text-anchor=\"middle\"",
                 brief(minutes ? at / 60.0 : at) + (quarter == 4 ? (minutes ? " min" : " s") : ""));
    }
    return out;
}

/// Names at the ends of their curves, moved apart where they would lie on each other.
std::string end_labels(const SweepPlan& plan, const std::vector<Curve>& curves) {
    std::vector<std::pair<double, std::size_t>> ends;
    for (std::size_t i = 0; i < curves.size(); ++i)
        ends.emplace_back(y_of(curves[i].middle.back()), i);
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i)
        ends[i].first = std::max(ends[i].first, ends[i - 1].first + between);
    // the last ones may have been moved out of the picture
    const double over = ends.empty() ? 0.0 : std::max(0.0, ends.back().first - (top + height));
    std::string out;
    for (const auto& [y, i] : ends) {
        const SweepCase& one = plan.cases()[curves[i].number];
        const double from = y_of(curves[i].middle.back());
        const std::string words = case_words(plan, one);
        const std::string shown =
            plan.spec().worlds.size() == 1 ? words : words.substr(0, words.rfind(", "));
        out += "<path class=\"leader c" + std::to_string(i) + "\" d=\"M" + number(left + width) +
               ' ' + number(from) + "L" + number(left + width + 12.0) + ' ' + number(y - over) +
               "\"/>\n";
        out += text(left + width + 16.0, y - over + 4.0, "class=\"label\"",
                    fixed(curves[i].middle.back(), 1) + "  " +
                        svg::fitted(shown, labels - 60.0, 12.0));
    }
    return out;
}

/// The parameters of a behaviour that have several values.
std::vector<std::size_t> varied(const SweepPlan& plan, std::size_t behaviour) {
    std::vector<std::size_t> found;
    const std::vector<SpecParameter>& all = plan.spec().parameters;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].is_of(plan.spec().behaviours[behaviour]) && all[i].values.size() > 1)
            found.push_back(i);
    }
    return found;
}

/// The mean coverage of a case at the longest time, %.
double mean_covered(const SweepPlan& plan, const Results& results, std::size_t number_of_case) {
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < plan.spec().seeds; ++seed) {
        const std::uint64_t run = number_of_case * plan.spec().seeds + seed;
        sum += values_of(plan, run, results[run]->stops.back()).covered;
    }
    return sum / static_cast<double>(plan.spec().seeds);
}

/// The case of that behaviour and world with those values of two parameters.
std::optional<std::size_t> case_with(const SweepPlan& plan, std::size_t behaviour,
                                     std::size_t world, std::size_t across,
                                     const std::string& across_value, std::size_t down,
                                     const std::string& down_value) {
    for (std::size_t i = 0; i < plan.cases().size(); ++i) {
        const SweepCase& one = plan.cases()[i];
        bool matches = one.behaviour == behaviour && one.world == world;
        for (std::size_t p = 0; matches && p < one.values.size(); ++p) {
            const std::string& wanted = p == across ? across_value
                                        : p == down ? down_value
                                                    : plan.spec().parameters[p].values.front();
            matches = one.values[p].empty() || one.values[p] == wanted;
        }
        if (matches) return i;
    }
    return {};
}

}  // namespace

std::string coverage_chart(const SweepPlan& plan, const Results& results, std::size_t world) {
    const std::vector<Curve> curves = curves_of(plan, results, world);
    const double whole_width = left + width + labels;
    const double whole_height = top + height + bottom;
    std::string out = "<svg class=\"chart\" viewBox=\"0 0 " + number(whole_width) + ' ' +
                      number(whole_height) + "\" role=\"img\" aria-label=\"coverage over time\">\n";
    out += axes(plan.spec().times.back());
    for (std::size_t i = 0; i < curves.size(); ++i)
        out +=
            "<path class=\"band c" + std::to_string(i) + "\" d=\"" + band_of(curves[i]) + "\"/>\n";
    for (std::size_t i = 0; i < curves.size(); ++i)
        out += "<path class=\"line c" + std::to_string(i) + "\" d=\"" + line_of(curves[i].middle) +
               "\"/>\n";
    return out + end_labels(plan, curves) + "</svg>\n";
}

std::string parameter_map(const SweepPlan& plan, const Results& results, std::size_t behaviour,
                          std::size_t world) {
    const std::vector<std::size_t> parameters = varied(plan, behaviour);
    if (parameters.size() < 2) return {};
    const std::size_t down = parameters[0];
    const std::size_t across = parameters[1];
    const std::vector<std::string>& columns = plan.spec().parameters[across].values;
    std::string out = "<table class=\"map\">\n<tr><th>" +
                      svg::escaped(plan.spec().parameters[down].name.text) + " ↓ " +
                      svg::escaped(plan.spec().parameters[across].name.text) + " →</th>";
    for (const std::string& value : columns)
        out += "<th>" + svg::escaped(value) + "</th>";
    for (const std::string& down_value : plan.spec().parameters[down].values) {
        out += "</tr>\n<tr><th>" + svg::escaped(down_value) + "</th>";
        for (const std::string& value : columns) {
            const std::optional<std::size_t> found =
                case_with(plan, behaviour, world, across, value, down, down_value);
            const double covered = found ? mean_covered(plan, results, *found) : 0.0;
            // ten steps of one hue, from the page's style
            const int shade = std::clamp(static_cast<int>(covered / 10.0), 0, 9);
            out += "<td class=\"h" + std::to_string(shade) + "\">" + fixed(covered, 1) + "</td>";
        }
    }
    return out + "</tr>\n</table>\n";
}

}  // namespace trellis
