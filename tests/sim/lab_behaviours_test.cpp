// The behaviour files against every recorded run of the Python lab: trees/roomba and its primitives
// against the lab's tree, machines/roomba against its machine, in XML and in JSON. Bit for bit with
// the mathematics of x86-64 glibc, within 1e-9 elsewhere; leaf and bumper always. What the
// recordings are is in LAB.md; that sim/ alone reproduces them, in lab_streams_test.cpp.
// SPDX-License-Identifier: MIT
#include "sim/bridge/episode.h"
#include "sim/bridge/leaves.h"
#include "support/behaviours.h"
#include "support/lab_reference.h"
#include "support/lab_rows.h"
#include "support/lab_streams.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

/// A file and the recordings that it reproduces, "fsm" or "bt".
struct Claim {
    std::string_view file, kind;
};
constexpr Claim claims[] = {
    {"machines/roomba.scxml", "fsm"},
    {"machines/roomba.json", "fsm"},
    {"trees/roomba.xml", "bt"},
    {"trees/roomba.json", "bt"},
    {"trees/roomba_primitives.xml", "bt"},
    {"trees/roomba_primitives.json", "bt"},
};

/// A list that is shorter than the run begins again, as the lab's own replay does.
Random replay(const LabStream& stream) {
    constexpr std::size_t most_draws = 4'000;  // a GoBack and a Rotate take more than 9 ticks
    std::vector<double> angles = stream.angles;
    for (std::size_t i = 0; angles.size() < most_draws; ++i)
        angles.push_back(angles[i]);
    return Random::replaying(std::move(angles));
}

/// The leaves of one tick as the recordings write them, "GoBack>Rotate".
class Path final : public TraceSink {
public:
    explicit Path(const Program& program) : program_(program), state_(fresh_state(program)) {}

    void on(const TraceEvent& event) override {
        if (event.kind != TraceEvent::Kind::tick) return;
        state_.last_leaf = event.row;
        const std::string_view leaf = leaf_label(program_, state_);
        if (leaf == last_) return;
        if (!text_.empty()) text_ += '>';
        text_ += leaf;
        last_ = leaf;
    }
    /// Of the ticks since the last call.
    std::string take() {
        last_ = {};
        return std::exchange(text_, {});
    }

private:
    const Program& program_;
    State state_;
    std::string text_;
    std::string_view last_;
};

LabRow row_of(const Episode& run, std::string_view status, std::string path) {
    const EpisodeRow row = run.row();
    return {.tick = static_cast<std::int64_t>(row.tick),
            .x = row.robot.x,
            .y = row.robot.y,
            .rotation = row.robot.rotation,
            .v = row.robot.v,
            .w = row.robot.w,
            .bumper = row.robot.bumper,
            .leaf = std::string(row.leaf),
            .status = std::string(status),
            .path = std::move(path)};
}

std::vector<LabRow> run_of(const Program& program, const LabStream& stream) {
    Episode run(program, {.world = stream.world, .dt = lab_dt, .random = replay(stream)});
    std::vector<LabRow> rows{row_of(run, "-", "")};
    Path path(program);
    for (std::int64_t tick = 1; tick <= lab_ticks; ++tick) {
        if (!run.tick(&path)) {
            FAIL_CHECK("tick " << tick << ": " << run.state().fault.message);
            break;
        }
        const bool done = run.status() == Status::success;
        rows.push_back(row_of(run, done ? "SUCCESS" : "RUNNING", path.take()));
    }
    return rows;
}

}  // namespace

TEST_CASE("lab behaviours: the files reproduce every recorded run of the lab") {
    Registry registry;
    register_roomba(registry);
    for (const Claim& claim : claims) {
        CAPTURE(claim.file);
        const Program program = program_of(claim.file, registry);
        for (const LabStream& stream : lab_streams()) {
            CAPTURE(stream.name);
            const std::vector<LabRow> ours = run_of(program, stream);
            const std::vector<LabRow> events = lab_events(claim.kind, stream.name);
            REQUIRE(events.size() > 60);
            check_rows(ours, events);
            check_events(ours, events);
            check_rows(ours, lab_whole_run(claim.kind, stream.name));  // none: not recorded whole
        }
    }
}

// The report calls machine and tree identical until the first collision; the recordings part at
// tick 181, 34 s earlier (LAB 1.7).
TEST_CASE("lab behaviours: machine and tree part in tick 181, before any collision") {
    Registry registry;
    register_roomba(registry);
    const Program machine = program_of("machines/roomba.scxml", registry);
    const Program tree = program_of("trees/roomba.xml", registry);
    Episode a(machine, {.world = {}, .dt = lab_dt, .random = Random(1)});
    Episode b(tree, {.world = {}, .dt = lab_dt, .random = Random(1)});
    std::uint64_t tick = 0;
    do {
        REQUIRE(a.tick());
        REQUIRE(b.tick());
        ++tick;
        REQUIRE_FALSE(a.robot().bumper);
    } while (a.robot() == b.robot());
    CHECK(tick == 181);
    CHECK(a.row().leaf == "MoveForward");
    CHECK(b.row().leaf == "MoveInSpiral");
}
