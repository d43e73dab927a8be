// trellis sweep merge: the parts of a sweep put together.
// SPDX-License-Identifier: MIT
#include "runner/commands.h"
#include "runner/sweep/journal.h"
#include "runner/sweep/results.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>

namespace trellis {

namespace {

/// Adds the runs of a part; yes, or what to return after a message.
Exit add_part(const std::string& part, const SweepPlan& plan, Results& results, Streams& streams) {
    const std::optional<std::string> text = read_text(part, streams);
    if (!text) { return Exit::file; }
    JournalContent content = read_journal(*text, plan);
    if (!content.is_of_plan) {
        return complain(streams, Exit::no,
                        "\"" + part +
                            "\" is no part of this sweep: its file, a behaviour or a "
                            "world has changed since");
    }
    for (auto& [number, run] : content.runs) {
        // a run that is there twice is one run: it cannot have come to two different things
        results[number] = std::move(run);
    }
    return Exit::yes;
}

}  // namespace

void add_options(CLI::App& app, SweepMergeArguments& arguments) {
    app.add_option("SPEC", arguments.file, "the sweep file, or -")->required();
    app.add_option("PART", arguments.parts, "files that trellis sweep --shard has written")
        ->required();
    add_options(app, arguments.output);
}

Exit execute(const SweepMergeArguments& arguments, Streams& streams) {
    Exit exit = Exit::yes;
    const std::unique_ptr<SweepPlan> plan = SweepPlan::load(arguments.file, streams, exit);
    if (!plan) { return exit; }
    Results results(plan->run_count());
    for (const std::string& part : arguments.parts) {
        exit = add_part(part, *plan, results, streams);
        if (exit != Exit::yes) { return exit; }
    }
    const auto missing =
        std::count_if(results.begin(), results.end(), [](const auto& run) { return !run; });
    if (missing != 0) {
        return complain(streams, Exit::no,
                        std::to_string(missing) + " of " + std::to_string(results.size()) +
                            " runs are missing: give all parts, and finish them with --resume");
    }
    return write_results(*plan, results, arguments.output, streams);
}

}  // namespace trellis
