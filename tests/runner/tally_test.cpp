// What a run amounts to, counted by hand.
// SPDX-License-Identifier: MIT
#include "runner/tally.h"

#include "runner/behaviour.h"
#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

namespace {

struct Counter : TraceSink {
    Tally& tally;
    explicit Counter(Tally& t) : tally(t) {}
    void on(const TraceEvent& event) override { tally.on(event); }
};

}  // namespace

TEST_CASE("tally: entries, ticks, distance and results of a tree of one leaf") {
    const RoombaRegistry registry;
    Diagnostics diagnostics;
    const auto program = load({"a.xml", forward_tree}, registry, diagnostics);
    REQUIRE(program);
    const Labels labels(*program);
    Tally tally(labels);
    Counter counter(tally);
    Episode episode(*program, {});
    for (int i = 0; i < 10; ++i) {
        episode.tick(&counter);
        tally.tick(episode);
    }
    // four ticks each: the fourth ends it
    CHECK(tally.entered == std::vector<std::uint64_t>{3});
    CHECK(tally.ticks == std::vector<std::uint64_t>{10});
    CHECK(tally.successes == 2);
    CHECK(tally.failures == 0);
    CHECK(tally.driven.bumps == 0);
    CHECK(tally.driven.distance == doctest::Approx(10 * 0.5 / 60.0));
}

TEST_CASE("tally: a tick with the bumper pressed is a bump") {
    const RoombaRegistry registry;
    Diagnostics diagnostics;
    const auto program = load({"a.xml", forward_tree}, registry, diagnostics);
    REQUIRE(program);
    const Labels labels(*program);
    Tally tally(labels);
    EpisodeSetup setup;
    setup.world.start.x = setup.world.width;
    Episode episode(*program, setup);
    for (int i = 0; i < 3; ++i) {
        episode.tick();
        tally.tick(episode);
    }
    CHECK(tally.driven.bumps == 3);
    CHECK(tally.failures == 3);
}
