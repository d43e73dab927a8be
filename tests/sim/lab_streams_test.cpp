// The lab's world under hand-written behaviours against every recorded run of the Python lab: bit
// for bit with the mathematics of x86-64 glibc, within 1e-9 elsewhere. What the tree and the
// machine of the lab do to the last bit is in LAB.md; this is the proof that sim/ and the
// references agree.
// SPDX-License-Identifier: MIT
#include "support/lab_streams.h"

#include "support/lab_reference.h"
#include "support/lab_rows.h"

#include <doctest/doctest.h>

#include <string_view>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

std::vector<LabRow> run(std::string_view kind, const LabStream& stream) {
    return kind == "fsm" ? run_lab_machine(stream.world, stream.angles, lab_ticks)
                         : run_lab_tree(stream.world, stream.angles, lab_ticks);
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
            check_events(ours, recorded);
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
