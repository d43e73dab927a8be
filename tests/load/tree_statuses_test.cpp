// The sets of statuses against recorded trees: what a node returns in a run is in its set, and a
// row that is never ticked has no event. What is said of it: tree_checks_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/tree_statuses.h"

#include "support/disk.h"
#include "support/files.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trellis::test {
namespace {

/// Counts what contradicts the statuses found.
class Contradictions final : public TraceSink {
public:
    explicit Contradictions(const TreeStatuses& found) : found_(found) {}

    void on(const TraceEvent& event) override {
        using Kind = TraceEvent::Kind;
        const bool ended = event.kind == Kind::status && is_done(event.to);
        if (!ended && event.kind != Kind::tick && event.kind != Kind::skip) { return; }
        ++events;
        const Status returned = event.kind == Kind::skip ? Status::skipped : event.to;
        if (!found_.by_row[event.row.index].has(returned)) { ++wrong; }
        for (const NeverTicked& rows : found_.never_ticked) {
            // what a condition of its own decides is the status of a node, too
            const bool decides = rows.reason == NeverTicked::Reason::switched_off;
            const RowId first{rows.first.index + (decides ? 1U : 0U)};
            if (first <= event.row && event.row < rows.end) { ++wrong; }
        }
    }

    std::size_t events = 0, wrong = 0;

private:
    const TreeStatuses& found_;
};

}  // namespace

TEST_CASE("tree statuses: recorded trees return nothing that was not found possible") {
    const std::filesystem::path folder = TRELLIS_CONFORMANCE_DIR "/trees";
    if (!std::filesystem::exists(folder)) {
        MESSAGE("no recorded trees in " TRELLIS_CONFORMANCE_DIR);
        return;
    }
    std::size_t events = 0;
    std::size_t never_ticked = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".xml") { continue; }
        Diagnostics diagnostics;
        Disk disk;
        const std::string name = entry.path().string();
        const std::optional<Program> program = load(
            {name, read_file(entry.path())}, script_registry(), diagnostics, {.reader = &disk});
        if (!program) { continue; }
        const TreeStatuses found = find_statuses(*program);
        never_ticked += found.never_ticked.size();
        Contradictions sink(found);
        ScriptRun run(*program);
        for (int tick = 0; tick < 20; ++tick) {
            const Status status = run.step({.dt = 1.0, .trace = &sink});
            if (run.state.fault) { break; }
            CHECK_MESSAGE(found.by_row[0].has(status), name);
        }
        CHECK_MESSAGE(sink.wrong == 0, name);
        events += sink.events;
    }
    CHECK(events > 10'000);
    CHECK(never_ticked > 100);
}

}  // namespace trellis::test
