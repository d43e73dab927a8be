// The page: its style, its sections in order, and the runs that are drawn once more.
// SPDX-License-Identifier: MIT
#include "runner/sweep/report.h"

#include "runner/labels.h"
#include "runner/sweep/summary_report.h"
#include "runner/table.h"
#include "sim/svg.h"
#include "sim/trail.h"
#include "sim/trail_svg.h"

#include <algorithm>
#include <string_view>

namespace trellis {
namespace {

// Eight hues that stay apart for most eyes, each lighter on dark ground.
constexpr std::string_view style = R"css(
:root { color-scheme: light dark; --ground: #ffffff; --ink: #1f2328; --soft: #59636e; --grid: #e4e7eb;
  --card: #f6f8fa; --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #9a5fb0; --c4: #b58900;
  --c5: #c2417c; --c6: #56697a; --c7: #5b8c00; --map: 204, 100%; }
@media (prefers-color-scheme: dark) { :root { --ground: #14181d; --ink: #e6e9ec; --soft: #9aa4af;
  --grid: #2b323a; --card: #1d232a; --c0: #58b4e8; --c1: #ff9352; --c2: #3fcf9f; --c3: #c99be0;
  --c4: #e3b93c; --c5: #f484b5; --c6: #a3b3c2; --c7: #a4d44a; } }
body { background: var(--ground); color: var(--ink); font: 15px/1.5 system-ui, sans-serif;
  max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.5rem; } h3 { font-size: 1rem; }
p { color: var(--soft); } svg { max-width: 100%; height: auto; }
pre, code { font: 13px/1.5 ui-monospace, monospace; background: var(--card); }
pre { padding: .75rem; overflow-x: auto; border-radius: 6px; }
.grid { stroke: var(--grid); fill: none; } .axis { fill: var(--soft); font-size: 12px; }
.label { fill: var(--ink); font-size: 12px; } .line { fill: none; stroke-width: 2; }
.leader { fill: none; stroke-width: 1; } .band { stroke: none; opacity: .16; }
.line.c0, .leader.c0 { stroke: var(--c0); } .band.c0 { fill: var(--c0); }
.line.c1, .leader.c1 { stroke: var(--c1); } .band.c1 { fill: var(--c1); }
.line.c2, .leader.c2 { stroke: var(--c2); } .band.c2 { fill: var(--c2); }
.line.c3, .leader.c3 { stroke: var(--c3); } .band.c3 { fill: var(--c3); }
.line.c4, .leader.c4 { stroke: var(--c4); } .band.c4 { fill: var(--c4); }
.line.c5, .leader.c5 { stroke: var(--c5); } .band.c5 { fill: var(--c5); }
.line.c6, .leader.c6 { stroke: var(--c6); } .band.c6 { fill: var(--c6); }
.line.c7, .leader.c7 { stroke: var(--c7); } .band.c7 { fill: var(--c7); }
.map { border-collapse: separate; border-spacing: 2px; font-variant-numeric: tabular-nums; }
.map th { font-weight: 500; color: var(--soft); padding: .2rem .6rem; }
.map td { padding: .35rem .8rem; text-align: right; border-radius: 3px; color: #10202c; }
.h0 { background: hsl(var(--map), 97%); } .h1 { background: hsl(var(--map), 93%); }
.h2 { background: hsl(var(--map), 89%); } .h3 { background: hsl(var(--map), 84%); }
.h4 { background: hsl(var(--map), 79%); } .h5 { background: hsl(var(--map), 74%); }
.h6 { background: hsl(var(--map), 69%); } .h7 { background: hsl(var(--map), 63%); }
.h8 { background: hsl(var(--map), 56%); } .h9 { background: hsl(var(--map), 49%); }
.runs { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1.5rem; }
.runs svg { border-radius: 6px; width: 100%; }
)css";

/// A word of a shell command.
std::string shell_word(const std::string& text) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=+,:@%";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + '\'';
}

/// The run once more, as a picture.
std::string trail_of(const SweepPlan& plan, std::uint64_t run, double time) {
    const SweepCase& one = plan.case_of(run);
    const Program& program = plan.program(one);
    const Labels labels(program);
    Episode episode(program, plan.setup_of(run));
    Trail trail;
    const double ticks = time / plan.spec().dt;
    while (static_cast<double>(episode.state().tick) + 0.5 < ticks && !episode.is_over()) {
        const Roomba before = episode.robot();
        if (!episode.tick()) break;
        const LabelId label = labels.of(labels.row(episode.state()));
        trail.add({before.x, before.y,
                   static_cast<std::uint16_t>(
                       std::min<std::uint32_t>(label.index, TrailPoint::no_leaf))});
    }
    const std::string title = case_words(plan, one);
    const std::string words = "seed " + std::to_string(plan.seed_of(run));
    return trail_svg(LabWorld{}, trail.points(), episode.robot(),
                     {.title = title,
                      .run = words,
                      .seconds = time,
                      .leaves = labels.names(),
                      .walled = plan.world(one),
                      .start = start_of(episode.setup())});
}

std::string drawn_run(const SweepPlan& plan, const Results& results, std::uint64_t run,
                      const std::string& heading) {
    const double time = plan.spec().times.front();
    const double covered = values_of(plan, run, results[run]->stops.front()).covered;
    return "<div>\n<h3>" + heading + ": " + fixed(covered, 1) + " % after " + brief(time) +
           " s</h3>\n" + trail_of(plan, run, time) + "<pre>" +
           svg::escaped(command_of(plan, run, time)) + "</pre>\n</div>\n";
}

/// The runs of a world that cover most and least at the shortest time, where they differ most.
std::string extremes(const SweepPlan& plan, const Results& results, std::size_t world) {
    std::vector<std::uint64_t> runs;
    for (std::uint64_t run = 0; run < results.size(); ++run) {
        if (plan.case_of(run).world == world) runs.push_back(run);
    }
    const auto less = [&](std::uint64_t a, std::uint64_t b) {
        return results[a]->stops.front().covered < results[b]->stops.front().covered;
    };
    return "<div class=\"runs\">\n" +
           drawn_run(plan, results, *std::max_element(runs.begin(), runs.end(), less), "Best") +
           drawn_run(plan, results, *std::min_element(runs.begin(), runs.end(), less), "Worst") +
           "</div>\n";
}

std::string maps(const SweepPlan& plan, const Results& results, std::size_t world) {
    std::string out;
    for (std::size_t i = 0; i < plan.spec().behaviours.size(); ++i) {
        const std::string map = parameter_map(plan, results, i, world);
        if (map.empty()) continue;
        out += "<h3>" + svg::escaped(plan.spec().behaviours[i].name) +
               ": mean coverage, %, after " + brief(plan.spec().times.back()) + " s</h3>\n" + map;
    }
    return out;
}

}  // namespace

std::string command_of(const SweepPlan& plan, std::uint64_t run, double time) {
    const SweepSpec& spec = plan.spec();
    const SweepCase& one = plan.case_of(run);
    const SpecBehaviour& behaviour = spec.behaviours[one.behaviour];
    std::string command = "trellis run " + shell_word(plan.behaviour_file(one));
    if (!behaviour.tree.empty()) command += " --tree " + shell_word(behaviour.tree);
    for (const SpecBehaviour::Setting& setting : behaviour.set)
        command += " --set " + shell_word(setting.name.text + '=' + setting.value);
    for (std::size_t i = 0; i < one.values.size(); ++i) {
        if (!one.values[i].empty())
            command += " --set " + shell_word(spec.parameters[i].name.text + '=' + one.values[i]);
    }
    if (plan.world(one) != nullptr) command += " --world " + shell_word(plan.world_file(one));
    if (spec.dt != lab_dt) command += " --dt " + brief(spec.dt);
    if (spec.cell != default_cell) command += " --cell " + brief(spec.cell);
    return command + " --seed " + std::to_string(plan.seed_of(run)) + " --time " + brief(time) +
           " --coverage --svg run.svg";
}

std::string sweep_report(const SweepPlan& plan, const Results& results) {
    const SweepSpec& spec = plan.spec();
    const std::string title = svg::escaped(spec.name.empty() ? "Sweep" : spec.name);
    std::string out = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
                      title + "</title>\n<style>" + std::string(style) +
                      "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n<p>" +
                      std::to_string(plan.run_count()) + " runs of " + brief(spec.times.back()) +
                      " s, seeds " + std::to_string(spec.first_seed) + " to " +
                      std::to_string(spec.first_seed + static_cast<std::int64_t>(spec.seeds) - 1) +
                      ", cells of " + brief(spec.cell) +
                      " m. Lines are medians over the seeds, bands go from the 25th to the 75th "
                      "percentile.</p>\n";
    for (std::size_t world = 0; world < spec.worlds.size(); ++world) {
        out += "<h2>" + svg::escaped(spec.worlds[world].text) + "</h2>\n" +
               coverage_chart(plan, results, world) + maps(plan, results, world) +
               extremes(plan, results, world);
    }
    out += "<h2>In numbers</h2>\n<pre>" +
           svg::escaped(summary_text(plan, summarised(plan, results))) + "</pre>\n";
    return out + "</body>\n</html>\n";
}

}  // namespace trellis
