// Reading and checking the options of an episode.
// SPDX-License-Identifier: MIT
#include "runner/episode_arguments.h"

#include "core/number.h"
#include "load/diagnostics.h"
#include "runner/behaviour.h"
#include "runner/draws.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace trellis {

namespace {

/// More ticks than that are a mistyped option, not a run.
constexpr double most_ticks = 1e12;

std::optional<double> finite_number(std::string_view text) {
    const ParsedNumber parsed = parse_whole_number(text);
    if (parsed.length == 0 || !std::isfinite(parsed.value)) { return {}; }
    return parsed.value;
}

/// "x,y,rotation" as three numbers.
std::optional<Pose> parse_pose(std::string_view text) {
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t comma = i + 1 < numbers.size() ? text.find(',') : text.size();
        if (comma == std::string_view::npos) { return {}; }
        const std::optional<double> number = finite_number(text.substr(0, comma));
        if (!number) { return {}; }
        numbers[i] = *number;
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return Pose{numbers[0], numbers[1], numbers[2]};
}

/// An option that takes a positive number of seconds.
CLI::Option* add_seconds(CLI::App& app, const std::string& name, double& target,
                         const std::string& doc) {
    return app
        .add_option_function<std::string>(
            name,
            [name, &target](const std::string& text) {
                const std::optional<double> seconds = finite_number(text);
                if (!seconds || *seconds <= 0.0) {
                    throw CLI::ValidationError(name, "expected a number of seconds above 0, found "
                                                     "\"" +
                                                         text + "\"");
                }
                target = *seconds;
            },
            doc)
        ->type_name("S");
}

}  // namespace

std::uint64_t EpisodeArguments::tick_count() const {
    if (ticks) { return *ticks; }
    return static_cast<std::uint64_t>(std::llround(std::min(time / dt, most_ticks)));
}

void add_options(CLI::App& app, EpisodeArguments& arguments) {
    CLI::Option* ticks =
        app.add_option("--ticks", arguments.ticks, "how many ticks to run")->type_name("N");
    add_seconds(app, "--time", arguments.time, "simulated time to run, in seconds; 60 if not given")
        ->excludes(ticks);
    app.add_option("--draws", arguments.draws,
                   "replay the random numbers of a file, one per line, instead of drawing them")
        ->type_name("FILE");
    app.add_option_function<std::string>(
           "--pose",
           [&arguments](const std::string& text) {
               arguments.pose = parse_pose(text);
               if (!arguments.pose) {
                   throw CLI::ValidationError(
                       "--pose", "expected three numbers as in 3.2,2.4,0, found \"" + text + "\"");
               }
           },
           "where the robot starts, in m and rad; 3.2,2.4,0 if not given")
        ->type_name("X,Y,ROTATION");
    add_seconds(app, "--dt", arguments.dt, "length of a tick, in seconds; 1/60 if not given");
}

EpisodeSetup setup_of(const EpisodeArguments& arguments) {
    EpisodeSetup setup;
    setup.dt = arguments.dt;
    if (arguments.pose) { setup.start = *arguments.pose; }
    return setup;
}

std::optional<Random> load_draws(const std::string& file, Streams& streams, Exit& exit) {
    exit = Exit::file;
    const std::optional<std::string> text = read_text(file, streams);
    if (!text) { return {}; }
    Diagnostics diagnostics;
    std::vector<double> draws = read_draws(shown_name(file), *text, diagnostics);
    show(diagnostics, streams);
    exit = Exit::no;
    if (!diagnostics.ok()) { return {}; }
    exit = Exit::yes;
    return Random::replaying(std::move(draws));
}

std::string describe_dt(double dt) {
    return dt == lab_dt ? "1/60 s" : print_number(dt) + " s";
}

}  // namespace trellis
