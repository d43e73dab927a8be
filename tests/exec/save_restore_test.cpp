// A State is a value: copied, or saved to bytes and restored, at any tick it has the same future;
// halting leaves nothing running. On random trees of up to 200 nodes and on random machines.
// SPDX-License-Identifier: MIT
#include "load/json.h"
#include "support/loading.h"
#include "support/random_machine.h"
#include "support/random_tree.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace trellis::test {
namespace {

constexpr int ticks = 14;

/// What one tick did, as a line.
std::string tick(ScriptRun& run, const std::string& event, bool bumper) {
    if (run.state.fault) { return {}; }
    run.host.bumper = bumper;
    if (!event.empty()) { send(run.program(), run.state, event); }
    const Status status = run.step({.dt = 1.0, .budget = 3000});
    return std::string(name_of(status)) + ' ' + run.statuses() + ' ' + run.take_events();
}

/// The run with its state gone through bytes.
ScriptRun through_bytes(const ScriptRun& run) {
    const std::vector<std::byte> bytes = save(run.program(), run.state);
    const std::optional<State> restored = restore(run.program(), bytes);
    REQUIRE(restored.has_value());
    CHECK(save(run.program(), *restored) == bytes);
    CHECK(same(run.program(), run.state, *restored));
    CHECK(hash(run.program(), run.state) == hash(run.program(), *restored));
    ScriptRun out = run;
    out.state = *restored;
    return out;
}

/// Runs a program; at every tick goes on from a copy and from restored bytes as well.
void check_futures(const Program& program, Random& random, bool machine) {
    std::vector<std::string> events;
    std::vector<bool> bumpers;
    std::vector<std::string> lines;
    std::vector<ScriptRun> saved;
    ScriptRun run(program);
    for (int i = 0; i < ticks; ++i) {
        events.push_back(machine ? random_event(random) : "");
        bumpers.push_back(random.whole(0, 2) == 0);
        saved.push_back(run);
        lines.push_back(tick(run, events.back(), bumpers.back()));
    }
    for (std::size_t begin = 0; begin < saved.size(); ++begin) {
        ScriptRun copy = saved[begin];
        ScriptRun restored = through_bytes(saved[begin]);
        saved[begin].state = State();  // what the copies must not need
        for (std::size_t i = begin; i < lines.size(); ++i) {
            REQUIRE(tick(copy, events[i], bumpers[i]) == lines[i]);
            REQUIRE(tick(restored, events[i], bumpers[i]) == lines[i]);
        }
        CHECK(same(program, copy.state, run.state));
        CHECK(same(program, restored.state, run.state));
        CHECK(hash(program, restored.state) == hash(program, run.state));
    }
}

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos;
         at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

/// Lets no TryCatch tick a child while it is halted.
void catch_nothing_on_halt(TreeSpec& tree) {
    if (tree.node == "TryCatch") { tree.number = 0; }
    for (TreeSpec& child : tree.children) {
        catch_nothing_on_halt(child);
    }
}

}  // namespace

TEST_CASE("save and restore: random trees have the same future from every tick") {
    Random random(std::int64_t{40});
    for (int i = 0; i < 60; ++i) {
        const TreeSpec spec = random_tree(random, static_cast<int>(random.whole(2, 200)));
        const std::string tree = notation(spec);
        CAPTURE(tree);
        check_futures(loaded(xml_of(spec)), random, false);
    }
}

TEST_CASE("save and restore: random machines have the same future from every cycle") {
    Random random(std::int64_t{41});
    for (int i = 0; i < 150; ++i) {
        const std::string text = random_machine(random, static_cast<int>(random.whole(1, 20)));
        CAPTURE(text);
        check_futures(loaded(text), random, true);
    }
}

TEST_CASE("save and restore: what restore() accepts can be stepped and halted") {
    Random random(std::int64_t{42});
    std::size_t accepted = 0;
    for (int i = 0; i < 200; ++i) {
        const bool machine = i % 2 == 0;
        const int size = static_cast<int>(random.whole(2, 20));
        const Program program =
            loaded(machine ? random_machine(random, size) : xml_of(random_tree(random, size)));
        ScriptRun run(program);
        for (int k = 0; k < 5; ++k) {
            tick(run, machine ? random_event(random) : "", k % 2 == 0);
        }
        const std::vector<std::byte> bytes = save(program, run.state);
        for (int k = 0; k < 40; ++k) {
            std::vector<std::byte> changed = bytes;
            for (std::int64_t n = random.whole(1, 3); n > 0; --n) {
                const auto last = static_cast<std::int64_t>(changed.size()) - 1;
                changed[static_cast<std::size_t>(random.whole(0, last))] =
                    static_cast<std::byte>(random.whole(0, 255));
            }
            if (random.whole(0, 5) == 0) {
                changed.resize(static_cast<std::size_t>(
                    random.whole(0, static_cast<std::int64_t>(changed.size()))));
            }
            const std::optional<State> restored = restore(program, changed);
            if (!restored || restored->fault) { continue; }
            ++accepted;
            ScriptRun other = run;
            other.state = *restored;
            other.step({.dt = 1.0, .budget = 2000});
            if (!other.state.fault) { other.halt({.dt = 1.0, .budget = 2000}); }
        }
    }
    MESSAGE(accepted, " changed states were accepted");
}

TEST_CASE(
    "halt: at any tick of a random tree nothing runs afterwards, running leaves are told once") {
    Random random(std::int64_t{43});
    for (int i = 0; i < 200; ++i) {
        TreeSpec spec = random_tree(random, static_cast<int>(random.whole(2, 200)));
        catch_nothing_on_halt(spec);
        const Program program = loaded(xml_of(spec));
        const std::string tree = notation(spec);
        CAPTURE(tree);
        ScriptRun run(program);
        for (int k = 0; k < 8; ++k) {
            tick(run, "", random.whole(0, 2) == 0);
            if (run.state.fault) { break; }
            ScriptRun halted = run;
            std::size_t leaves = 0;
            for (std::uint32_t n = 0; n < program.rows.size(); ++n) {
                const bool runs = run.state.status[n] == Status::running;
                const bool leaf = runs && program.rows[n].op == Op::action;
                leaves += leaf && program.call({n}).type->halt != nullptr ? 1U : 0U;
            }
            halted.halt();
            REQUIRE(count(halted.take_events(), ":HALT") == leaves);
            REQUIRE(halted.statuses() == std::string(program.rows.size(), '-'));
        }
    }
}

TEST_CASE("save and restore: a copy halts its leaves with the inputs it had") {
    const Program program = loaded("<root BTCPP_format='4'><BehaviorTree ID='T'><Leaf id='name' "
                                   "script='R'/></BehaviorTree></root>");
    std::optional<ScriptRun> run(program);
    run->step();
    run->take_events();
    ScriptRun copy = *run;
    ScriptRun restored = through_bytes(*run);
    run.reset();
    copy.halt();
    restored.halt();
    CHECK(copy.take_events() == "name:HALT");
    CHECK(restored.take_events() == "name:HALT");
}

TEST_CASE("spellings: XML, JSON of it, and XML of that compile to equal programs") {
    Random random(std::int64_t{44});
    for (int i = 0; i < 200; ++i) {
        const bool machine = i % 2 == 0;
        const int size = static_cast<int>(random.whole(2, 40));
        const std::string xml =
            machine ? random_machine(random, size) : xml_of(random_tree(random, size));
        CAPTURE(xml);
        Diagnostics diagnostics;
        const std::optional<Document> document = read({.name = "x", .text = xml}, diagnostics);
        REQUIRE(document.has_value());
        const std::string json =
            write_json(*document, machine ? FileKind::machine : FileKind::tree);
        CHECK(loaded(json) == loaded(xml));
    }
}

}  // namespace trellis::test
