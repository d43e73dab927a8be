// Runs in which ticks are leaped over, against the same runs ticked: leaves and bumps of every
// tick, poses within 1e-9, over the recorded angles of the lab and 1,000 seeds.
// SPDX-License-Identifier: MIT
#include "sim/bridge/fast_forward.h"

#include "sim/bridge/leaves.h"
#include "support/behaviours.h"
#include "support/lab_streams.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace trellis {
namespace {

struct Roombas : Registry {
    Roombas() { register_roomba(*this); }
};

/// What became of one comparison.
struct Outcome {
    std::uint64_t leaped = 0;   // ticks
    std::uint64_t differs = 0;  // the first tick whose leaf or bumper differs; 0: none
    double apart = 0.0;         // m or rad, the largest difference of a pose
};

/// Runs both to `ticks`.
Outcome compared(const Program& program, const EpisodeSetup& setup, std::uint64_t ticks) {
    Episode fast(program, setup);
    Episode judge(program, setup);
    FastForward forward(program);
    Outcome outcome;
    while (fast.state().tick < ticks) {
        const std::uint64_t leaped = forward.leap(fast, ticks - fast.state().tick);
        outcome.leaped += leaped;
        if (leaped == 0) fast.tick();
        const std::string_view leaf = leaf_label(program, fast.state());
        while (judge.state().tick < fast.state().tick) {
            judge.tick();
            const bool same = leaf_label(program, judge.state()) == leaf &&
                              judge.robot().bumper == fast.robot().bumper &&
                              judge.status() == fast.status();
            if (!same && outcome.differs == 0) outcome.differs = judge.state().tick;
        }
        const Roomba& a = fast.robot();
        const Roomba& b = judge.robot();
        outcome.apart = std::max({outcome.apart, std::fabs(a.x - b.x), std::fabs(a.y - b.y),
                                  std::fabs(a.rotation - b.rotation), std::fabs(a.v - b.v),
                                  std::fabs(a.w - b.w)});
    }
    return outcome;
}

/// TRELLIS_TICKS makes the runs of the seeds longer or shorter.
std::uint64_t ticks_of_seeds() {
    const char* const text = std::getenv("TRELLIS_TICKS");
    return text == nullptr ? 3'600 : std::strtoull(text, nullptr, 10);
}

constexpr const char* files[] = {"machines/roomba.scxml", "trees/roomba.xml",
                                 "machines/bounce.scxml", "trees/bounce.xml"};

TEST_CASE("fast forward: the recorded angles of the lab, ticked and leaped") {
    const Roombas registry;
    for (const char* file : {files[0], files[1]}) {
        CAPTURE(file);
        const Program program = test::program_of(file, registry);
        for (const test::LabStream& stream : test::lab_streams()) {
            CAPTURE(stream.name);
            std::vector<double> angles = stream.angles;
            for (std::size_t i = 0; angles.size() < 4000; ++i)
                angles.push_back(angles[i]);
            const Outcome outcome = compared(
                program, {.world = stream.world, .random = Random::replaying(std::move(angles))},
                test::lab_ticks);
            CHECK(outcome.differs == 0);
            CHECK(outcome.apart < 1e-9);
        }
    }
}

TEST_CASE("fast forward: a thousand seeds, ticked and leaped") {
    const Roombas registry;
    for (const char* file : files) {
        CAPTURE(file);
        const Program program = test::program_of(file, registry);
        const std::uint64_t ticks = ticks_of_seeds();
        Outcome worst;
        for (std::int64_t seed = 0; seed < 1000; ++seed) {
            const Outcome outcome = compared(program, {.random = Random(seed)}, ticks);
            if (worst.differs == 0) worst.differs = outcome.differs;
            worst.apart = std::max(worst.apart, outcome.apart);
            worst.leaped += outcome.leaped;
        }
        CHECK(worst.differs == 0);
        CHECK(worst.apart < 1e-9);
        // most ticks are leaped over
        CHECK(worst.leaped > 950 * ticks);
    }
}

TEST_CASE("fast forward: what it does not know is ticked") {
    const Roombas registry;
    const Program primitives = test::program_of("trees/roomba_primitives.xml", registry);
    Episode run(primitives, {.random = Random(0)});
    run.tick();
    CHECK(FastForward(primitives).leap(run, 100) == 0);

    const Program program = test::program_of("trees/roomba.xml", registry);
    const WalledWorld world(lab_room());
    Episode walled(program, {.walled = &world, .random = Random(0)});
    walled.tick();
    CHECK(FastForward(program).leap(walled, 100) == 0);

    // in front of a wall, every tick
    Episode near(program, {.start = Pose{6.2, 2.0, 0.0}, .random = Random(0)});
    near.tick();
    CHECK(FastForward(program).leap(near, 100) < 4);
}

TEST_CASE("fast forward: a leap ends where it is told to") {
    const Roombas registry;
    const Program program = test::program_of("machines/roomba.scxml", registry);
    Episode run(program, {.random = Random(0)});
    FastForward forward(program);
    run.tick();
    CHECK(forward.leap(run, 1) == 0);
    CHECK(forward.leap(run, 10) == 10);
    CHECK(run.state().tick == 11);
    CHECK(run.robot().x == doctest::Approx(3.2 + 11 * 0.5 / 60.0).epsilon(1e-12));
}

}  // namespace
}  // namespace trellis
