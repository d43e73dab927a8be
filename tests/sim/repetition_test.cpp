// Runs that repeat themselves end early, with the coverage that they have at any later time; others
// do not.
// SPDX-License-Identifier: MIT
#include "sim/bridge/repetition.h"

#include "load/load.h"
#include "sim/bridge/leaves.h"
#include "sim/bridge/measured_run.h"
#include "support/behaviours.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

namespace trellis {
namespace {

struct Roombas : Registry {
    Roombas() { register_roomba(*this); }
};

using Settings = std::vector<std::pair<std::string, std::string>>;

Program loaded(const std::string& text, const Registry& registry, Settings given = {}) {
    Diagnostics diagnostics;
    std::optional<Program> program =
        load({"file", text}, registry, diagnostics, {.given = std::move(given)});
    REQUIRE_MESSAGE(program, diagnostics.render());
    return std::move(*program);
}

Program lab_with(const Registry& registry, Settings given) {
    return loaded(test::read_file(TRELLIS_SOURCE_DIR "/machines/roomba.scxml"), registry,
                  std::move(given));
}

constexpr std::uint64_t hour = 216'000;  // ticks

MeasuredRun run_of(const Program& program, bool ends_early, EpisodeSetup setup = {}) {
    static const Floor lab = floor_of(LabWorld{});
    setup.random = Random(1);
    return measured_run(program, std::move(setup), lab,
                        {.stops = {hour}, .curve = {hour}, .ends_early = ends_early});
}

/// A tree that does one thing for ever.
std::string for_ever(const std::string& leaf) {
    return R"(<root BTCPP_format="4"><BehaviorTree ID="T">)" + leaf + "</BehaviorTree></root>";
}

TEST_CASE("repetition: a way that is turned about a point again and again") {
    const Roombas registry;
    for (const auto& [forward_time, spiral_time] :
         std::vector<std::pair<std::string, std::string>>{{"2", "8"}, {"1", "5"}, {"0.5", "12"}}) {
        const std::string forward = forward_time;
        const std::string spiral = spiral_time;
        CAPTURE(forward);
        const Program program =
            lab_with(registry, {{"forward_time", forward}, {"spiral_time", spiral}});
        const MeasuredRun early = run_of(program, true);
        const MeasuredRun whole = run_of(program, false);
        const Measures& end = early.stops[0];
        CHECK(whole.stops[0].driven.bumps == 0);
        CHECK(end.ending == Ending::orbit);
        CHECK(end.ended < hour / 2);
        // cells within 1 mm of the rim may be missing
        CHECK(end.covered <= whole.stops[0].covered);
        CHECK(end.covered + 4 >= whole.stops[0].covered);
        CHECK(early.message.starts_with("every "));
        MESSAGE(forward << " s/" << spiral << " s: " << end.covered << " of "
                        << whole.stops[0].covered << " cells, ended in tick " << end.ended << ", "
                        << early.message);
    }
}

TEST_CASE("repetition: a robot that cannot go on is stuck") {
    const Roombas registry;
    const Program pressing = loaded(for_ever("<SetVelocity linear='0.5'/>"), registry);
    const MeasuredRun early = run_of(pressing, true);
    CHECK(early.stops[0].ending == Ending::stuck);
    CHECK(early.stops[0].ended < 5000);
    CHECK(early.stops[0].covered == run_of(pressing, false).stops[0].covered);

    const Program turning = loaded(for_ever("<SetVelocity angular='1'/>"), registry);
    CHECK(run_of(turning, true).stops[0].ending == Ending::stuck);
    // a tree that waits for something that comes is not
    const Program waiting =
        loaded(for_ever("<Sequence><Wait duration='3000'/><SetVelocity linear='0.1'/></Sequence>"),
               registry);
    const MeasuredRun waited = run_of(waiting, true);
    CHECK(waited.stops[0].covered == run_of(waiting, false).stops[0].covered);
    CHECK(waited.stops[0].covered > run_of(turning, false).stops[0].covered);
}

TEST_CASE("repetition: a circle is an orbit as soon as it is closed") {
    const Roombas registry;
    const Program circle = loaded(for_ever("<SetVelocity linear='0.5' angular='0.5'/>"), registry);
    const MeasuredRun early = run_of(circle, true);
    CHECK(early.stops[0].ending == Ending::orbit);
    CHECK(early.stops[0].ended < 5000);
    CHECK(early.stops[0].covered == run_of(circle, false).stops[0].covered);
}

TEST_CASE("repetition: in a world of walls, and with a battery that nobody reads") {
    const Roombas registry;
    const WalledWorld world(lab_room());
    const Program program = lab_with(registry, {{"forward_time", "2"}, {"spiral_time", "8"}});
    CHECK(run_of(program, true, {.walled = &world}).stops[0].ending == Ending::orbit);

    World noisy = lab_room();
    noisy.noise.angular_slip = 0.1;
    const WalledWorld slippery(noisy);
    CHECK(run_of(program, true, {.walled = &slippery}).stops[0].ending == Ending::time);
}

TEST_CASE("repetition: a behaviour that knows where it is may do something else") {
    const Roombas registry;
    const Program program = loaded(for_ever("<ReactiveFallback><ScriptCondition code='_x.rotation "
                                            "> 600'/><SetVelocity linear='0.5' angular='0.5'/>"
                                            "</ReactiveFallback>"),
                                   registry);
    const MeasuredRun run = run_of(program, true);
    CHECK(run.stops[0].ending == Ending::time);
}

TEST_CASE("repetition: runs that draw numbers are what they would be without a watch") {
    const Roombas registry;
    for (const char* file : {"trees/roomba.xml", "machines/roomba.scxml", "trees/bounce.xml",
                             "trees/roomba_primitives.xml", "machines/modes.scxml"}) {
        CAPTURE(file);
        const Program program = test::program_of(file, registry);
        CHECK(run_of(program, true) == run_of(program, false));
    }
}

}  // namespace
}  // namespace trellis
