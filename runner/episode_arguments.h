// The options that say how an episode begins and how long it lasts, shared by the commands that run
// behaviours. Covered by tests/runner/episode_arguments_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/streams.h"
#include "sim/bridge/episode.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace trellis {

struct EpisodeArguments {
    std::optional<std::uint64_t> ticks;
    double time = 60.0;               ///< s, used without `ticks`
    std::vector<std::int64_t> seeds;  ///< none: 0
    std::string draws;                ///< file of numbers to replay; empty: none
    std::optional<Pose> pose;         ///< none: the world's own start
    double dt = lab_dt;               ///< s

    /// How many ticks the run has.
    std::uint64_t tick_count() const;
};

/// Adds --ticks, --time, --draws, --pose and --dt to a command; it adds --seed itself.
void add_options(CLI::App& app, EpisodeArguments& arguments);

/// Where the run begins, but for its random numbers.
EpisodeSetup setup_of(const EpisodeArguments& arguments);

/// The numbers of the file of draws; none after messages, with what to return in `exit`.
std::optional<Random> load_draws(const std::string& file, Streams& streams, Exit& exit);

/// "1/60 s", or a number of seconds.
std::string describe_dt(double dt);

}  // namespace trellis
