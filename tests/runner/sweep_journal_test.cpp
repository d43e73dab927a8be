// Runs as lines, and files of them: whole, cut off, damaged, of another sweep.
// SPDX-License-Identifier: MIT
#include "runner/command.h"
#include "runner/sweep/journal.h"

#include <doctest/doctest.h>

#include <sstream>

namespace trellis {
namespace {

const char* const small_sweep = R"({"behaviours": [{"file": "a.xml"}], "times": [1, 2],
"seeds": {"count": 3}, "marks": [0.5]})";

struct Sweep {
    Sweep() {
        files.content["a.xml"] = test::forward_tree;
        files.content["s.json"] = small_sweep;
        Exit exit = Exit::internal;
        plan = SweepPlan::load("s.json", streams, exit);
        REQUIRE(exit == Exit::yes);
    }

    test::MemoryFiles files;
    std::istringstream in;
    std::ostringstream out, err;
    Streams streams{in, out, err, files};
    std::unique_ptr<SweepPlan> plan;
};

TEST_CASE("sweep journal: a run goes through a line unchanged") {
    const Sweep sweep;
    MeasuredRun run = sweep.plan->measure(1);
    run.message = "a message\nof two lines, with  blanks";
    run.reached[1] = 17;
    const std::string line = record_of(1, run);
    CHECK(line.find('\n') == line.size() - 1);
    const std::string whole = line.substr(0, line.size() - 1);
    const std::optional<NumberedRun> read = read_record(whole, sweep.plan->measuring());
    REQUIRE(read);
    CHECK(read->first == 1);
    CHECK(read->second == run);
    for (std::size_t size = 0; size < whole.size(); ++size)
        CHECK_FALSE(read_record(whole.substr(0, size), sweep.plan->measuring()));
    std::string damaged = whole;
    damaged[2] = damaged[2] == '1' ? '2' : '1';
    CHECK_FALSE(read_record(damaged, sweep.plan->measuring()));
}

TEST_CASE("sweep journal: goes on behind the last whole line") {
    Sweep sweep;
    Exit exit = Exit::internal;
    Results results(3);
    const auto open = [&](bool resume) {
        return Journal::open("j", *sweep.plan, resume, results, sweep.streams, exit);
    };
    REQUIRE(open(false));
    const std::string header = journal_header(*sweep.plan);
    CHECK(sweep.files.content["j"] == header);

    const std::string first = record_of(2, sweep.plan->measure(2));
    const std::string second = record_of(0, sweep.plan->measure(0));
    sweep.files.content["j"] = header + first + second.substr(0, second.size() - 1);
    REQUIRE(open(true));
    CHECK(sweep.files.content["j"] == header + first);
    CHECK(results[2] == sweep.plan->measure(2));
    CHECK_FALSE(results[0]);

    // killed within its first line
    sweep.files.content["j"] = header.substr(0, 5);
    REQUIRE(open(false));
    CHECK(sweep.files.content["j"] == header);
}

TEST_CASE("sweep journal: does not touch what is not its own") {
    Sweep sweep;
    Exit exit = Exit::internal;
    Results results(3);
    sweep.files.content["j"] = journal_header(*sweep.plan);
    CHECK_FALSE(Journal::open("j", *sweep.plan, false, results, sweep.streams, exit));
    CHECK(exit == Exit::usage);
    CHECK(sweep.err.str() ==
          "trellis: \"j\" has the runs of a sweep that was not finished: go on with --resume, or "
          "remove it\n");
    sweep.err.str("");
    sweep.files.content["j"] = "something else\n";
    CHECK_FALSE(Journal::open("j", *sweep.plan, true, results, sweep.streams, exit));
    CHECK(exit == Exit::no);
    CHECK(sweep.err.str() ==
          "trellis: \"j\" is of another sweep: its file, a behaviour or a world has changed since; "
          "remove it to begin anew\n");
    CHECK(sweep.files.content["j"] == "something else\n");
}

TEST_CASE("sweep journal: another text of a behaviour is another sweep") {
    Sweep a;
    test::MemoryFiles files = a.files;
    files.content["a.xml"] += "<!-- other -->";
    Streams streams{a.in, a.out, a.err, files};
    Exit exit = Exit::internal;
    const std::unique_ptr<SweepPlan> b = SweepPlan::load("s.json", streams, exit);
    REQUIRE(b);
    CHECK(journal_header(*a.plan) != journal_header(*b));
}

}  // namespace
}  // namespace trellis
