// Runs that are measured: held against an episode that is ticked and measured by hand.
// SPDX-License-Identifier: MIT
#include "sim/bridge/measured_run.h"

#include "load/load.h"
#include "sim/bridge/leaves.h"
#include "support/behaviours.h"

#include <doctest/doctest.h>

namespace trellis {
namespace {

struct Roombas : Registry {
    Roombas() { register_roomba(*this); }
};

TEST_CASE("measured run: each stop says what the run amounts to by then") {
    const Roombas registry;
    const Program program = test::program_of("trees/roomba.xml", registry);
    const Floor floor = floor_of(LabWorld{});
    const MeasuredRun run = measured_run(program, {.random = Random(7)}, floor,
                                         {.stops = {3600, 18'000}, .curve = {0, 3600, 18'000}});

    Episode episode(program, {.random = Random(7)});
    Coverage coverage(floor);
    coverage.add(episode.robot().x, episode.robot().y, 0);
    Odometer driven;
    REQUIRE(run.stops.size() == 2);
    for (const Measures& stop : run.stops) {
        while (episode.state().tick < stop.tick) {
            episode.tick();
            driven.add(episode.robot(), lab_dt);
            coverage.add(episode.robot().x, episode.robot().y, episode.state().tick);
        }
        Odometer expected = driven;
        expected.turning = false;
        CHECK(stop == Measures{.tick = stop.tick,
                               .covered = coverage.covered_count(),
                               .largest_gap = coverage.largest_gap_count(),
                               .driven = expected,
                               .ended = stop.tick});
    }
    CHECK(run.curve == std::vector<std::uint64_t>{coverage.count_at(0), run.stops[0].covered,
                                                  run.stops[1].covered});
    CHECK(run.reached[0] == coverage.tick_of(0.5));
    CHECK_FALSE(run.reached[4]);
    CHECK(run.message == "");
}

TEST_CASE("measured run: leaping over ticks changes a cell here and there at most") {
    const Roombas registry;
    const Floor floor = floor_of(LabWorld{});
    for (const char* file : {"trees/roomba.xml", "machines/roomba.scxml"}) {
        const Program program = test::program_of(file, registry);
        for (std::int64_t seed = 0; seed < 5; ++seed) {
            const auto run = [&](bool leaps) {
                return measured_run(program, {.random = Random(seed)}, floor,
                                    {.stops = {10'000, 36'000}, .curve = {20'000}, .leaps = leaps});
            };
            const MeasuredRun ticked = run(false);
            const MeasuredRun leaped = run(true);
            for (std::size_t i = 0; i < 2; ++i) {
                const Measures& a = ticked.stops[i];
                const Measures& b = leaped.stops[i];
                CHECK(b.driven.distance == doctest::Approx(a.driven.distance).epsilon(1e-9));
                CHECK(b.driven.turns == a.driven.turns);
                CHECK(b.driven.bumps == a.driven.bumps);
                CHECK(b.ended == a.ended);
                // a way is swept in pieces, which rounding may cut elsewhere
                CHECK(b.covered <= a.covered + 2);
                CHECK(a.covered <= b.covered + 2);
            }
        }
    }
}

TEST_CASE("measured run: dirt is counted, the battery's dock is in the world") {
    const Roombas registry;
    const Program program = test::program_of("trees/roomba.xml", registry);
    World plan = lab_room();
    plan.dirt = {{.centre = {3.4, 2.4}, .radius = 0.3}, {.centre = {0.3, 0.3}, .radius = 0.05}};
    const WalledWorld world(plan);
    const Floor floor = floor_of(world.walls, {3.2, 2.4});
    const MeasuredRun run = measured_run(program, {.walled = &world, .random = Random(0)}, floor,
                                         {.stops = {6, 1800}, .curve = {0}});
    CHECK(run.stops[0].dirt == doctest::Approx(6.0 / 240.0));
    CHECK(run.stops[1].dirt > 0.5);
    CHECK(run.stops[1].dirt <= 1.0);
}

TEST_CASE("measured run: a run that is over stays what it was") {
    const Roombas registry;
    Diagnostics diagnostics;
    const std::string text =
        R"(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" datamodel="script">
  <state id="go">
    <invoke type="leaf" src="SetVelocity"><param name="linear" expr="0.5"/></invoke>
    <transition event="tick" cond="elapsed() &gt; 0.5" target="there"/>
  </state>
  <final id="there"/>
</scxml>)";
    const std::optional<Program> machine = load({"m.scxml", text}, registry, diagnostics);
    REQUIRE_MESSAGE(machine, diagnostics.render());
    const Floor floor = floor_of(LabWorld{});
    const MeasuredRun run =
        measured_run(*machine, {}, floor, {.stops = {10, 100, 1000}, .curve = {1000}});
    CHECK(run.stops[0].ending == Ending::time);
    CHECK(run.stops[1].ending == Ending::final);
    CHECK(run.stops[1].ended == run.stops[2].ended);
    CHECK(run.stops[1].ended < 40);
    CHECK(run.stops[1].covered == run.stops[2].covered);
    CHECK(run.curve[0] == run.stops[2].covered);
    CHECK(run.message == "there");
}

TEST_CASE("measured run: a behaviour that fails ends its run with a message") {
    const Roombas registry;
    const Program program = test::program_of("trees/roomba.xml", registry);
    const Floor floor = floor_of(LabWorld{});
    const MeasuredRun run = measured_run(program, {.random = Random::replaying({1.0})}, floor,
                                         {.stops = {36'000}, .curve = {0}});
    CHECK(run.stops[0].ending == Ending::fault);
    CHECK(run.message.find("there are no random numbers left") != std::string::npos);
}

}  // namespace
}  // namespace trellis
