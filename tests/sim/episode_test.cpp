// An Episode: the order of a tick, its rows and labels, saving and restoring by copying, faults.
// Whole runs are compared with recordings in lab_behaviours_test.cpp and tests/golden.
// SPDX-License-Identifier: MIT
#include "sim/bridge/episode.h"

#include "load/diagnostics.h"
#include "load/load.h"
#include "sim/bridge/leaves.h"
#include "support/behaviours.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

/// The Roomba's leaves.
struct Robot {
    Registry registry;
    Robot() { register_roomba(registry); }

    /// The program of a tree whose main tree is `body`, or of a whole machine.
    Program program(std::string text) const {
        if (!text.starts_with("<scxml") && !text.starts_with("<root"))
            text = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + text +
                   "</BehaviorTree></root>";
        Diagnostics diagnostics;
        std::optional<Program> loaded = load({"test", text}, registry, diagnostics);
        REQUIRE_MESSAGE(loaded.has_value(), diagnostics.render());
        return std::move(loaded).value();
    }
};

constexpr LabWorld at_right_wall{.start = {6.23, 2.4, 0.0}};

/// The row after the start and each of `ticks` ticks.
std::vector<Roomba> robots(Episode run, int ticks) {
    std::vector<Roomba> all{run.robot()};
    for (int i = 0; i < ticks; ++i) {
        REQUIRE(run.tick());
        all.push_back(run.robot());
    }
    return all;
}

}  // namespace

TEST_CASE("episode: row 0 is the start, before the first tick") {
    const Robot robot;
    const Program program = robot.program("<MoveForward/>");
    const Episode run(program, {});
    const EpisodeRow row = run.row();
    CHECK(row.tick == 0);
    CHECK(row.time == 0.0);
    CHECK(row.leaf == "-");
    CHECK(row.robot == at_start(LabWorld{}));
    CHECK(run.status() == Status::running);
    CHECK_FALSE(run.is_over());
}

TEST_CASE("episode: a tick senses, lets the behaviour command, and moves") {
    const Robot robot;
    // commands a velocity that says whether the bumper was seen
    const Program program =
        robot.program("<ReactiveFallback><Sequence><Bumped/><SetVelocity linear=\"-0.1\"/>"
                      "</Sequence><SetVelocity linear=\"0.5\"/></ReactiveFallback>");
    Episode run(program, {.world = at_right_wall});
    REQUIRE(run.tick());
    // the contact of the start is sensed, the command of this tick is obeyed in this tick
    CHECK(run.robot().bumper);
    CHECK(run.robot().v == -0.1);
    CHECK(run.robot().x == doctest::Approx(6.23 - 0.1 / 60).epsilon(1e-12));
    CHECK(run.row().tick == 1);
    CHECK(run.row().time == lab_dt);
}

TEST_CASE("episode: velocities stay until they are commanded anew") {
    const Robot robot;
    const Program program = robot.program(
        "<Sequence><SetVelocity linear=\"0.5\" hold=\"false\"/><Wait duration=\"1\"/></Sequence>");
    Episode run(program, {});
    for (int i = 0; i < 10; ++i)
        REQUIRE(run.tick());
    CHECK(run.robot().v == 0.5);
}

TEST_CASE("episode: a copy is the saved run, and runs on to the same end") {
    const Robot robot;
    for (const auto& file : {"trees/roomba_primitives.xml", "machines/roomba.scxml"}) {
        CAPTURE(file);
        const Program program = program_of(file, robot.registry);
        Episode run(program, {.world = {}, .dt = lab_dt, .random = Random(3)});
        for (int i = 0; i < 2'300; ++i)
            REQUIRE(run.tick());
        const Episode saved = run;
        const std::vector<Roomba> first = robots(run, 1'000);
        for (int i = 0; i < 500; ++i)
            REQUIRE(run.tick());
        CHECK_FALSE(same(program, run.state(), saved.state()));
        run = saved;
        CHECK(same(program, run.state(), saved.state()));
        CHECK(robots(run, 1'000) == first);
    }
}

TEST_CASE("episode: another seed is another run") {
    const Robot robot;
    const Program program = program_of("machines/roomba.scxml", robot.registry);
    const auto with_seed = [&](std::int64_t seed) {
        return robots(Episode(program, {.world = {}, .dt = lab_dt, .random = Random(seed)}), 2'400);
    };
    CHECK(with_seed(1) == with_seed(1));
    CHECK(with_seed(1) != with_seed(2));
}

TEST_CASE("episode: the length of a tick is the setup's") {
    const Robot robot;
    const Program program = robot.program("<MoveForward/>");
    Episode run(program, {.world = {}, .dt = 0.25});
    int ticks = 0;
    do {
        REQUIRE(run.tick());
        ++ticks;
    } while (run.status() == Status::running);
    CHECK(ticks == 13);  // the first time beyond 3 s
    CHECK(run.row().time == 3.25);
}

TEST_CASE("episode: a tree's label is its last leaf, or the innermost subtree around it") {
    const Robot robot;
    const Program leaf = robot.program("<Inverter><Wait name=\"pause\"/></Inverter>");
    Episode run(leaf, {});
    REQUIRE(run.tick());
    CHECK(run.row().leaf == "pause");

    const Program subtree =
        robot.program("<root BTCPP_format=\"4\" main_tree_to_execute=\"A\">"
                      "<BehaviorTree ID=\"A\"><SubTree ID=\"B\"/></BehaviorTree>"
                      "<BehaviorTree ID=\"B\"><Sequence><SubTree ID=\"C\" name=\"clean\"/>"
                      "</Sequence></BehaviorTree>"
                      "<BehaviorTree ID=\"C\"><Wait/></BehaviorTree></root>");
    Episode nested(subtree, {});
    REQUIRE(nested.tick());
    CHECK(nested.row().leaf == "clean");
}

TEST_CASE("episode: a machine's label is its active atomic state, from the start on") {
    const Robot robot;
    const Program program = robot.program(
        "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" version=\"1.0\" datamodel=\"script\">"
        "<state id=\"outer\"><state id=\"inner\"><transition event=\"tick\" target=\"end\"/>"
        "</state></state><final id=\"end\"/></scxml>");
    Episode run(program, {});
    CHECK(run.row().leaf == "inner");
    REQUIRE(run.tick());
    CHECK(run.row().leaf == "end");
    CHECK(run.is_over());
    CHECK(run.status() == Status::success);
}

TEST_CASE("episode: a behaviour that fails stops the run and says why") {
    const Robot robot;
    const Program program = robot.program("<Rotate/>");
    Episode run(program, {.world = {}, .dt = lab_dt, .random = Random::replaying({})});
    CHECK_FALSE(run.tick());
    CHECK(run.state().fault.kind == Fault::Kind::draws);
    CHECK(run.state().fault.row == RowId{1});
    CHECK(run.robot().w == 0.0);  // it has not moved
}
