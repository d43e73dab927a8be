// trellis compare: two behaviours side by side.
// SPDX-License-Identifier: MIT
#include "runner/commands.h"
#include "runner/compare_report.h"
#include "runner/declarations.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <ostream>
#include <utility>

namespace trellis {

namespace {

/// A file with everything that an Entrant refers to. Stays where it is: the labels point into it.
class Loaded {
public:
    Loaded(std::unique_ptr<RoombaRegistry> registry, Behaviour behaviour, Document document)
        : registry_(std::move(registry)), behaviour_(std::move(behaviour)),
          document_(std::move(document)), labels_(*behaviour_.program) {}
    Loaded(const Loaded&) = delete;
    Loaded& operator=(const Loaded&) = delete;

    Entrant entrant() const { return {behaviour_.name, *behaviour_.program, document_, labels_}; }

private:
    std::unique_ptr<RoombaRegistry> registry_;
    Behaviour behaviour_;
    Document document_;
    Labels labels_;
};

std::unique_ptr<Loaded> load_entrant(const std::string& file, const LoadArguments& arguments,
                                     Streams& streams, Exit& exit) {
    // what one file declares is not known in the other
    auto registry = std::make_unique<RoombaRegistry>();
    std::optional<Behaviour> behaviour = load_behaviour(file, arguments, *registry, streams, exit);
    if (!behaviour) { return nullptr; }
    // what compiled can be read once more, without a finding
    Diagnostics diagnostics;
    Document document = *read(behaviour->source(), diagnostics);
    return std::make_unique<Loaded>(std::move(registry), std::move(*behaviour),
                                    std::move(document));
}

/// The random numbers of each match and their names; none after messages.
std::vector<std::pair<std::string, Random>> randoms(const CompareArguments& arguments,
                                                    Streams& streams, Exit& exit) {
    std::vector<std::pair<std::string, Random>> all;
    if (!arguments.episode.draws.empty()) {
        std::optional<Random> draws = load_draws(arguments.episode.draws, streams, exit);
        if (draws) {
            all.emplace_back("draws " + shown_name(arguments.episode.draws), std::move(*draws));
        }
        return all;
    }
    std::vector<std::int64_t> seeds = arguments.episode.seeds;
    for (std::int64_t seed = 0; seed < arguments.seed_count; ++seed) {
        seeds.push_back(seed);
    }
    if (seeds.empty()) { seeds.push_back(0); }
    for (const std::int64_t seed : seeds) {
        all.emplace_back("seed " + std::to_string(seed), Random(seed));
    }
    return all;
}

}  // namespace

void add_options(CLI::App& app, CompareArguments& arguments) {
    app.add_option("A", arguments.a, "a tree or machine file, or -")->required();
    app.add_option("B", arguments.b, "another")->required();
    add_options(app, arguments.episode);
    CLI::Option* draws = app.get_option("--draws");
    CLI::Option* seeds = app.add_option("--seed", arguments.episode.seeds,
                                        "seed of the random numbers; may be given several times; "
                                        "0 if not given")
                             ->type_name("N")
                             ->allow_extra_args(false)
                             ->excludes(draws);
    app.add_option("--seeds", arguments.seed_count, "the seeds from 0 to N - 1")
        ->type_name("N")
        ->check(CLI::Range(1, 1'000'000))
        ->excludes(draws)
        ->excludes(seeds);
    add_options(app, arguments.load);
    add_format(app, arguments.format);
}

Exit execute(const CompareArguments& arguments, Streams& streams) {
    if (arguments.a == "-" && arguments.b == "-") {
        return complain(streams, Exit::usage, "only one of the files can be standard input");
    }
    Exit exit = Exit::yes;
    const auto a = load_entrant(arguments.a, arguments.load, streams, exit);
    if (!a) { return exit; }
    const auto b = load_entrant(arguments.b, arguments.load, streams, exit);
    if (!b) { return exit; }
    const Entrant a_entrant = a->entrant();
    const Entrant b_entrant = b->entrant();
    std::vector<Match> matches;
    for (auto& [words, random] : randoms(arguments, streams, exit)) {
        EpisodeSetup setup = setup_of(arguments.episode);
        setup.random = std::move(random);
        matches.push_back(
            compare(a_entrant, b_entrant, setup, arguments.episode.tick_count(), words));
        if (const std::string fault = matches.back().fault(); !fault.empty()) {
            streams.err << fault << '\n';
            exit = Exit::no;
        }
        if (matches.back().parting) { exit = Exit::no; }
    }
    if (matches.empty()) { return exit; }
    streams.out << (arguments.format == Format::json ? comparison_json(matches)
                                                     : comparison_text(matches));
    return exit;
}

}  // namespace trellis
