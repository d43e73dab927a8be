// The variants in machines/labs and trees/labs do what LAB.md's table says of the labs they are
// written after: how many ticks each leaf lasts, how far and to which sides the robot turns.
// Whole runs of them are in traces_test.cpp.
// SPDX-License-Identifier: MIT
#include "sim/bridge/episode.h"
#include "sim/bridge/leaves.h"
#include "support/behaviours.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

/// An unbroken stretch of ticks with the same leaf.
struct Stretch {
    std::string leaf;
    int ticks = 0;
    double turn = 0.0;  ///< rad, how far the rotation changed
};

/// All stretches of a run that came to their end.
std::vector<Stretch> stretches(const Program& program, const LabWorld& world, std::int64_t seed,
                               int ticks) {
    Episode run(program, {.world = world, .dt = lab_dt, .random = Random(seed)});
    std::vector<Stretch> all;
    for (int tick = 0; tick < ticks; ++tick) {
        const double before = run.robot().rotation;
        const bool went_on = run.tick();
        REQUIRE_MESSAGE(went_on, run.state().fault.message);
        const std::string_view leaf = run.row().leaf;
        if (all.empty() || all.back().leaf != leaf) all.push_back({.leaf = std::string(leaf)});
        ++all.back().ticks;
        all.back().turn += run.robot().rotation - before;
    }
    all.pop_back();
    return all;
}

/// The first stretch of that leaf; 0 ticks if there is none.
Stretch first(const std::vector<Stretch>& all, std::string_view leaf) {
    for (const Stretch& stretch : all)
        if (stretch.leaf == leaf) return stretch;
    return {};
}

/// To which sides a robot turns.
enum class Turns : std::uint8_t {
    both,
    right,  ///< to positive rotation only
    alike,  ///< by the same angle every time
};

/// What the table says of one file: ticks that a leaf lasts when nothing is in the way, and bounds
/// of the ticks of a turn.
struct Lab {
    std::string_view file;
    int forward, spiral, back;
    int least, most;
    Turns turns = Turns::both;
};

// the longest turn of pi rad at 0.5 rad/s takes 377 ticks
constexpr Lab lab_table[] = {
    {"machines/roomba.scxml", 181, 1201, 31, 1, 377},
    {"machines/roomba_leaves.scxml", 181, 1201, 31, 1, 377},
    {"machines/labs/lab02.scxml", 181, 1201, 31, 1, 377},
    {"machines/labs/lab03.scxml", 181, 1201, 31, 1, 377},
    {"machines/labs/lab04.scxml", 181, 1201, 31, 1, 377},
    {"machines/labs/lab05.scxml", 181, 1200, 31, 1, 377},
    {"machines/labs/lab06.scxml", 301, 1200, 31, 1, 377, Turns::right},
    {"machines/labs/lab07.scxml", 182, 1201, 32, 1, 190, Turns::right},
    {"machines/labs/lab08.scxml", 182, 1202, 32, 1, 378},
    {"machines/labs/lab09.scxml", 182, 1201, 32, 1, 378},
    {"machines/labs/lab10.scxml", 181, 1200, 31, 1, 377, Turns::right},
    {"machines/labs/lab11.scxml", 181, 1200, 31, 1, 754, Turns::right},
    {"machines/labs/lab12.scxml", 181, 1200, 31, 189, 566, Turns::right},
    {"machines/labs/lab13.scxml", 180, 1200, 30, 189, 566, Turns::right},
    {"machines/labs/lab14.scxml", 181, 1200, 31, 181, 361, Turns::right},
    {"machines/labs/lab15.scxml", 181, 1200, 31, 31, 181, Turns::right},
    {"machines/labs/lab16.scxml", 181, 1201, 31, 1, 1000, Turns::right},
    {"machines/labs/lab18.scxml", 180, 1200, 30, 1, 377, Turns::alike},
    {"machines/labs/lab19.scxml", 182, 1201, 32, 2, 756, Turns::right},
    {"machines/labs/lab20.scxml", 181, 1201, 31, 1, 377},
    {"trees/roomba.xml", 180, 1201, 30, 1, 377},
    {"trees/roomba_primitives.xml", 180, 1201, 30, 1, 377},
    {"trees/labs/dead_draw.xml", 180, 1201, 30, 1, 377},
    {"trees/labs/lab01.xml", 180, 1201, 30, 1, 377},
    {"trees/labs/lab02.xml", 181, 1202, 31, 1, 378},
    {"trees/labs/lab03.xml", 181, 1202, 31, 1, 378},
    {"trees/labs/lab04.xml", 180, 1201, 30, 1, 377},
    {"trees/labs/lab05.xml", 180, 1200, 30, 1, 377},
    {"trees/labs/lab06.xml", 300, 1200, 30, 1, 377, Turns::right},
    {"trees/labs/lab07.xml", 181, 1201, 31, 1, 190, Turns::right},
    {"trees/labs/lab08.xml", 181, 1202, 31, 1, 378},
    {"trees/labs/lab09.xml", 180, 1200, 30, 1, 377},
    {"trees/labs/lab10.xml", 181, 1201, 31, 1, 378, Turns::right},
    {"trees/labs/lab11.xml", 180, 1200, 30, 1, 754, Turns::right},
    {"trees/labs/lab12.xml", 181, 1201, 31, 190, 567, Turns::right},
    {"trees/labs/lab13.xml", 178, 1199, 28, 188, 565, Turns::right},
    {"trees/labs/lab14.xml", 181, 1201, 31, 181, 362, Turns::right},
    {"trees/labs/lab15.xml", 180, 1200, 30, 31, 181, Turns::right},
    {"trees/labs/lab16.xml", 181, 1202, 31, 1, 1001, Turns::right},
    {"trees/labs/lab18.xml", 179, 1200, 29, 1, 377},
    {"trees/labs/lab19.xml", 181, 1201, 31, 2, 756, Turns::right},
    {"trees/labs/lab20.xml", 180, 1201, 30, 1, 377},
};

constexpr LabWorld open_room{.width = 1000.0, .height = 1000.0, .start = {500.0, 500.0, 0.0}};

void check_turns(const Lab& lab, const std::vector<Stretch>& all) {
    std::vector<Stretch> turns;
    for (const Stretch& stretch : all)
        if (stretch.leaf == "Rotate") turns.push_back(stretch);
    REQUIRE(turns.size() >= 10);
    bool right = false, left = false, alike = true;
    for (const Stretch& turn : turns) {
        CHECK(turn.ticks >= lab.least);
        CHECK(turn.ticks <= lab.most);
        (turn.turn > 0.0 ? right : left) = true;
        alike = alike && turn.ticks == turns[0].ticks;
    }
    CHECK(alike == (lab.turns == Turns::alike));
    if (lab.turns == Turns::both) CHECK((right && left));
    if (lab.turns == Turns::right) CHECK_FALSE(left);
}

/// The angle of the first turn of a run in the lab's room, rad.
double first_turn(std::string_view file, std::int64_t seed, const Registry& registry) {
    const Program program = program_of(file, registry);
    return first(stretches(program, {}, seed, 3'600), "Rotate").turn;
}

}  // namespace

TEST_CASE("labs: every file has the dwell times and the turns of its lab") {
    Registry registry;
    register_roomba(registry);
    for (const Lab& lab : lab_table) {
        CAPTURE(lab.file);
        const Program program = program_of(lab.file, registry);
        const std::vector<Stretch> undisturbed = stretches(program, open_room, 1, 2'000);
        const std::vector<Stretch> all = stretches(program, {}, 1, 36'000);
        CHECK(first(undisturbed, "MoveForward").ticks == lab.forward);
        CHECK(first(undisturbed, "MoveInSpiral").ticks == lab.spiral);
        CHECK(first(all, "GoBack").ticks == lab.back);
        check_turns(lab, all);
    }
}

TEST_CASE("labs: the table names every behaviour file that is a lab's") {
    std::vector<std::string> named{"machines/bounce.scxml",     "machines/cleaner.scxml",
                                   "machines/door.scxml",       "machines/modes.scxml",
                                   "machines/supervisor.scxml", "trees/bounce.xml",
                                   "trees/cleaner.xml",         "trees/door.xml"};
    std::vector<std::string> files;
    for (const Lab& lab : lab_table)
        named.emplace_back(lab.file);
    for (const std::filesystem::path& file : xml_behaviours())
        files.push_back(file.generic_string());
    std::sort(named.begin(), named.end());
    CHECK(named == files);
}

// random.Random(42) gives +0.876 and then -2.984; a turn is longer than its angle by less than a
// tick (LAB 1.4).
TEST_CASE("labs: a dead draw makes tree and machine see different angles of one seed") {
    Registry registry;
    register_roomba(registry);
    constexpr double tick = 0.5 * lab_dt;  // rad
    CHECK(first_turn("machines/roomba.scxml", 42, registry) ==
          doctest::Approx(0.876 + tick / 2).epsilon(tick));
    CHECK(first_turn("trees/roomba.xml", 42, registry) ==
          doctest::Approx(0.876 + tick / 2).epsilon(tick));
    CHECK(first_turn("trees/labs/dead_draw.xml", 42, registry) ==
          doctest::Approx(-2.984 - tick / 2).epsilon(tick));
}
