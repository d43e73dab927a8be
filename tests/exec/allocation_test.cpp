// Stepping takes nothing from the heap once the buffers of a state have grown to what the behaviour
// needs: trees with scripts, texts, ports and subtrees; machines with events, data and activities.
// SPDX-License-Identifier: MIT
#include "support/allocations.h"
#include "support/loading.h"
#include "support/random_tree.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace trellis::test {
namespace {

void steps(ScriptRun& run, int count) {
    for (int i = 0; i < count && !run.state.fault; ++i) {
        run.host.bumper = i % 7 == 0;
        run.step();
    }
}

/// How many leaves have been called at least once.
std::ptrdiff_t called(const ScriptRun& run) {
    const std::vector<std::uint32_t>& calls = run.host.calls;
    return std::count_if(calls.begin(), calls.end(), [](std::uint32_t n) { return n > 0; });
}

/// Calls of operator new in 200 steps, after 2000 to warm up; 0 if a leaf was called for the first
/// time in those 200, or a condition was skipped, because that is no steady state.
std::size_t allocations(const Program& program) {
    ScriptRun run(program);
    run.host.records = false;
    steps(run, 2000);
    const std::ptrdiff_t leaves = called(run);
    const std::size_t before = allocation_count();
    steps(run, 200);
    const std::size_t after = allocation_count();
    return called(run) == leaves && !run.state.fault ? after - before : 0;
}

std::string machine(const std::string& states) {
    return "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0' datamodel='script'>" +
           states + "</scxml>";
}

}  // namespace

TEST_CASE("allocations: none per tick of random trees") {
    Random random(std::int64_t{50});
    for (int i = 0; i < 50; ++i) {
        const TreeSpec spec = random_tree(random, static_cast<int>(random.whole(2, 100)));
        const std::string tree = notation(spec);
        CAPTURE(tree);
        CHECK(allocations(loaded(xml_of(spec))) == 0);
    }
}

TEST_CASE("allocations: none for scripts with texts, ports and subtrees") {
    CHECK(allocations(loaded(
              "<root BTCPP_format='4' main_tree_to_execute='M'><BehaviorTree ID='M'><Sequence>"
              "<Script code=\"n := 1; t := 'a text that does not fit into a small buffer'\"/>"
              "<Script code=\"n += 1; u := t .. ' and more'\" _skipIf='n > 5'/>"
              "<SubTree ID='S' in='{u}'/><ScriptCondition code=\"u != t\"/></Sequence>"
              "</BehaviorTree><BehaviorTree ID='S'><Sequence>"
              "<PutStr id='p' value='another text that does not fit anywhere' out='{own}'/>"
              "<GetStr id='g' in='{own}'/><Echo id='e' in='{in}'/>"
              "<PutDouble id='d' value='1.5' out='{x}'/><GetDouble id='h' in='{x}'/>"
              "</Sequence></BehaviorTree></root>")) == 0);
}

TEST_CASE("allocations: none for queues, times, entries that are watched, and cases") {
    CHECK(allocations(loaded(
              "<root BTCPP_format='4'><BehaviorTree ID='M'><Sequence><LoopString "
              "queue='a text that does not fit into a small buffer;another one of that size' "
              "value='{t}'><Sequence><WasEntryUpdated entry='{t}'/><SetBlackboard value='{t}' "
              "output_key='u'/></Sequence></LoopString><Script code='x := 100000000.5'/>"
              "<Timeout msec='5000'><Delay delay_msec='2000'><Switch2 variable='{x}' case_1='1' "
              "case_2='{t}'><AlwaysSuccess/><AlwaysSuccess/><Sleep msec='1000'/></Switch2></Delay>"
              "</Timeout></Sequence></BehaviorTree></root>")) == 0);
}

TEST_CASE("allocations: none for transitions, raised events, data and guards of machines") {
    CHECK(allocations(loaded(machine(
              "<datamodel><data id='n' expr='0'/><data id='t' expr=\"''\"/></datamodel>"
              "<state id='a'><onentry><raise event='e'/></onentry><transition event='e' "
              "cond='n &lt; 1000'><assign location='n' expr='n + 1'/><assign location='t' "
              "expr=\"'a text of more than sixteen bytes'\"/></transition><transition event='tick' "
              "cond='elapsed() > 2' target='b'><raise event='x'/><raise event='y'/></transition>"
              "</state><state id='b'><transition event='y' cond=\"In('b') &amp;&amp; "
              "!_x.bumper\" target='a'/><transition event='tick' target='a'/></state>"))) == 0);
}

TEST_CASE("allocations: none for activities that run, end and are halted") {
    CHECK(allocations(loaded(machine(
              "<state id='a'><invoke type='leaf' id='i' src='Leaf'><param name='script' "
              "expr=\"'RRS'\"/></invoke><transition event='done.invoke.i.success' target='b'/>"
              "</state><state id='b'><invoke type='leaf' src='Leaf'><param name='script' "
              "expr=\"'R'\"/></invoke><transition event='tick' cond='elapsed() > 1' target='a'/>"
              "</state>"))) == 0);
}

TEST_CASE("allocations: none for reading _event") {
    CHECK(allocations(loaded(machine(
              "<state id='a'><onentry><raise event='an.event.with.a.long.name'/></onentry>"
              "<transition event='an' cond=\"_event.name == 'an.event.with.a.long.name'\" "
              "target='b'/></state><state id='b'><transition event='tick' cond=\"_event.type == "
              "'external'\" target='a'/></state>"))) == 0);
}

}  // namespace trellis::test
