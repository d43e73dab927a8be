// trellis sweep: every run of a sweep file, by all cores, and what they come to together.
// SPDX-License-Identifier: MIT
#include "runner/commands.h"
#include "runner/sweep/crew.h"
#include "runner/sweep/journal.h"
#include "runner/sweep/progress.h"
#include "runner/sweep/ranks.h"
#include "runner/sweep/results.h"
#include "runner/sweep/shard.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <mutex>
#include <ostream>
#include <utility>

namespace trellis {

namespace {

/// The runs of one process.
class Work {
public:
    Work(const SweepPlan& plan, const Shard& shard, Streams& streams)
        : plan_(plan), shard_(shard), streams_(streams), results_(plan.run_count()) {}

    /// Keeps what is done in a journal, and takes from it what was done before.
    Exit keep_in(const std::string& path, bool resume) {
        Exit exit = Exit::yes;
        journal_ = Journal::open(path, plan_, resume, results_, streams_, exit);
        return exit;
    }

    Exit run(unsigned threads) {
        std::vector<std::uint64_t> left;
        std::uint64_t all = 0;
        for (std::uint64_t run = shard_.number - 1; run < plan_.run_count(); run += shard_.count) {
            ++all;
            if (!results_[run]) left.push_back(run);
        }
        const bool watched = streams_.progress && shard_.number == 1;
        Progress progress(streams_.err, watched, all - left.size(), all);
        std::mutex finishing;
        bool written = true;
        share_out(left.size(), threads, [&](std::size_t i) {
            MeasuredRun run = plan_.measure(left[i]);
            const std::lock_guard lock(finishing);
            written = written && (!journal_ || journal_->add(left[i], run));
            results_[left[i]] = std::move(run);
            progress.add();
            return written;
        });
        if (written) { return Exit::yes; }
        return complain(streams_, Exit::file,
                        "cannot write \"" + journal_->path() + "\": " + journal_->why() +
                            "; what is done so far is kept: go on with --resume");
    }

    /// All runs of this process as records, for another one.
    std::string records() const {
        std::string text;
        for (std::uint64_t run = 0; run < results_.size(); ++run) {
            if (results_[run] && shard_.has(run)) { text += record_of(run, *results_[run]); }
        }
        return text;
    }

    Results& results() { return results_; }

    /// When everything is written elsewhere, nothing is left to go on with.
    void forget_journal() {
        if (!journal_) { return; }
        const std::string path = journal_->path();
        journal_.reset();
        streams_.files.remove(path);
    }

private:
    const SweepPlan& plan_;
    Shard shard_;
    Streams& streams_;
    Results results_;
    std::unique_ptr<Journal> journal_;
};

/// Which part is asked for; none after a message.
std::optional<Shard> shard_of(const SweepArguments& arguments, Streams& streams) {
    const std::optional<Shard> shard =
        arguments.shard.empty() ? slurm_shard(streams.environment) : parse_shard(arguments.shard);
    if (!shard) {
        complain(streams, Exit::usage,
                 arguments.shard.empty()
                     ? "the SLURM_ARRAY_TASK variables make no sense here; give --shard i/n"
                     : "--shard: expected i/n as in 1/3, found \"" + arguments.shard + '"');
    } else if (!shard->is_whole() &&
               (arguments.output.out.empty() || arguments.output.out == "-")) {
        complain(streams, Exit::usage,
                 "a part of a sweep needs --out FILE: its runs are kept beside that file");
        return {};
    }
    return shard;
}

/// A part's result is its journal.
Exit finish_part(const std::string& journal, const Shard& shard, Streams& streams) {
    streams.out << "part " << shard.number << " of " << shard.count << " is in " << journal
                << "; trellis sweep merge puts all parts together\n";
    return Exit::yes;
}

/// The first rank takes the runs of the others.
Exit finish_together(Work& work, const SweepPlan& plan, const Ranks& ranks,
                     const SweepArguments& arguments, Streams& streams) {
    if (ranks.count() > 1) {
        for (const std::string& records : ranks.gathered(work.records())) {
            JournalContent content = read_journal(journal_header(plan) + records, plan);
            for (auto& [number, run] : content.runs) {
                work.results()[number] = std::move(run);
            }
        }
    }
    Exit exit = Exit::yes;
    if (ranks.is_first()) { exit = write_results(plan, work.results(), arguments.output, streams); }
    exit = static_cast<Exit>(ranks.largest(static_cast<int>(exit)));
    if (exit != Exit::file) { work.forget_journal(); }
    return exit;
}

}  // namespace

void add_options(CLI::App& app, SweepArguments& arguments) {
    app.add_option("SPEC", arguments.file, "a sweep file, or -");
    add_options(app, arguments.output);
    app.add_flag("--resume", arguments.resume, "go on with a sweep that was not finished");
    app.add_option("--jobs", arguments.jobs, "how many threads run it; all cores if not given")
        ->type_name("N")
        ->check(CLI::Range(1U, 1024U));
    app.add_option("--shard", arguments.shard,
                   "only the I-th of N parts; the task of a Slurm job array if not given")
        ->type_name("I/N");
}

Exit execute(const SweepArguments& arguments, Streams& streams) {
    if (arguments.file.empty()) {
        return complain(streams, Exit::usage, "which sweep file? try: trellis sweep --help");
    }
    const Ranks ranks;
    const auto together = [&](Exit exit) {
        return static_cast<Exit>(ranks.largest(static_cast<int>(exit)));
    };
    // what is wrong with the files is the same for all ranks
    std::ostream silent(nullptr);
    Streams said{streams.in, streams.out, ranks.is_first() ? streams.err : silent, streams.files};
    said.colour = streams.colour;
    said.environment = streams.environment;

    Exit exit = Exit::usage;
    const std::optional<Shard> shard = shard_of(arguments, said);
    const std::unique_ptr<SweepPlan> plan =
        shard ? SweepPlan::load(arguments.file, said, exit) : nullptr;
    exit = together(exit);
    if (!plan || exit != Exit::yes) { return exit; }

    const auto rank = static_cast<std::uint64_t>(ranks.rank());
    const Shard own{shard->number + shard->count * rank,
                    shard->count * static_cast<std::uint64_t>(ranks.count())};
    Work work(*plan, own, streams);
    const std::string& out = arguments.output.out;
    const std::string journal = journal_name(out, own);
    if (!out.empty() && out != "-") { exit = work.keep_in(journal, arguments.resume); }
    exit = together(exit);
    if (exit != Exit::yes) { return exit; }
    exit = together(work.run(arguments.jobs != 0 ? arguments.jobs : machine_threads()));
    if (exit != Exit::yes) { return exit; }
    if (!shard->is_whole()) { return finish_part(journal, own, streams); }
    return finish_together(work, *plan, ranks, arguments, streams);
}

}  // namespace trellis
