// The lab's world under hand-written behaviours against every recorded run of the Python lab: bit
// for bit with the mathematics of x86-64 glibc, within 1e-9 elsewhere. What the tree and the
// machine of the lab do to the last bit is in LAB.md; this is the proof that sim/ and the
// references agree. SPDX-License-Identifier: MIT
#include "support/lab_streams.h"

#include "support/lab_reference.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

#if defined(__x86_64__) && defined(__GLIBC__)
constexpr double tolerance = 0.0;  // m, rad, m/s, rad/s
#else
constexpr double tolerance = 1e-9;
#endif

/// Leaf, bumper and whatever else is recorded equal, numbers equal or within the tolerance.
bool agrees(const LabRow& ours, const LabRow& recorded) {
    const auto near = [](double a, double b) { return std::fabs(a - b) <= tolerance; };
    return ours.tick == recorded.tick && ours.bumper == recorded.bumper &&
           ours.leaf == recorded.leaf &&
           (recorded.status.empty() || ours.status == recorded.status) &&
           (recorded.path.empty() || ours.path == recorded.path) && near(ours.x, recorded.x) &&
           near(ours.y, recorded.y) && near(ours.rotation, recorded.rotation) &&
           near(ours.v, recorded.v) && near(ours.w, recorded.w);
}

/// Whether every recorded row is the one of its tick in `run`; the first that is not is a failure.
void check_rows(const std::vector<LabRow>& run, const std::vector<LabRow>& recorded) {
    for (const LabRow& row : recorded) {
        const LabRow& ours = run[static_cast<std::size_t>(row.tick)];
        if (agrees(ours, row)) continue;
        FAIL_CHECK("ours     " << text_of(ours) << "\nrecorded " << text_of(row));
        return;
    }
}

std::vector<LabRow> run(std::string_view kind, const LabStream& stream) {
    return kind == "fsm" ? run_lab_machine(stream.world, stream.angles, lab_ticks)
                         : run_lab_tree(stream.world, stream.angles, lab_ticks);
}

/// The ticks that a recording of events holds: the leaf changes, the bumper is pressed, or 10 s
/// pass.
std::vector<std::int64_t> event_ticks(const std::vector<LabRow>& run) {
    std::vector<std::int64_t> ticks;
    for (std::size_t i = 0; i < run.size(); ++i)
        if (run[i].tick % 600 == 0 || run[i].leaf != run[i - 1].leaf || run[i].bumper)
            ticks.push_back(run[i].tick);
    return ticks;
}

std::vector<std::int64_t> ticks_of(const std::vector<LabRow>& rows) {
    std::vector<std::int64_t> ticks;
    for (const LabRow& row : rows)
        ticks.push_back(row.tick);
    return ticks;
}

}  // namespace

TEST_CASE("lab streams: machine and tree reproduce every recorded event") {
    for (const LabStream& stream : lab_streams()) {
        for (const std::string_view kind : {"fsm", "bt"}) {
            CAPTURE(stream.name);
            CAPTURE(kind);
            const std::vector<LabRow> ours = run(kind, stream);
            const std::vector<LabRow> recorded = lab_events(kind, stream.name);
            REQUIRE(recorded.size() > 60);
            check_rows(ours, recorded);
            CHECK(event_ticks(ours) == ticks_of(recorded));
        }
    }
}

TEST_CASE("lab streams: machine and tree reproduce the runs recorded whole, every tick") {
    for (const LabStream& stream : lab_streams()) {
        for (const std::string_view kind : {"fsm", "bt"}) {
            const std::vector<LabRow> recorded = lab_whole_run(kind, stream.name);
            if (recorded.empty()) continue;
            CAPTURE(stream.name);
            CAPTURE(kind);
            REQUIRE(recorded.size() == lab_ticks + 1);
            check_rows(run(kind, stream), recorded);
        }
    }
}
