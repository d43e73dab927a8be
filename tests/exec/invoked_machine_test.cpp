// Machines that invoke machines: starting, messages both ways, ending and cancelling, what a State
// holds of them. Section numbers are those of the SCXML Recommendation.
// SPDX-License-Identifier: MIT
#include "support/machine_story.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace trellis::test {
namespace {

/// A state that invokes a machine of those states as `c`, logs every event, and ends at `stop`.
std::string invoking(const std::string& child, const std::string& attributes = {},
                     const std::string& inside = {}) {
    return "<datamodel><data id='v' expr='7'/></datamodel><state id='s'><invoke id='c'" +
           attributes + ">" + inside + "<content><scxml version='1.0' datamodel='script'>" + child +
           "</scxml></content></invoke><transition event='stop' target='end'/><transition "
           "event='*'><log expr='_event.name'/></transition></state><state id='end'/>";
}

}  // namespace

TEST_CASE("invoke: a machine begins when its state has been entered, and its end is an event") {
    Machine m(invoking("<state id='x'><transition event='go' target='y'/></state><final id='y'>"
                       "<donedata><content expr='3'/></donedata></final>"));
    CHECK(m.start() == "+s +x");
    CHECK(m.step({"e"}) == "(e)");
    REQUIRE(m.run.state.children.size() == 1);
    send(m.program.machines[0], m.run.state.children[0].state, "go");
    CHECK(m.step() == "-x +y -y (done.invoke.c)");
    CHECK(m.run.state.children.empty());
}

TEST_CASE("invoke: a state that is left in the same macrostep invokes nothing (6.4)") {
    Machine m("<state id='s'><invoke><content><scxml version='1.0'><state id='x'/></scxml>"
              "</content></invoke><transition target='t'/></state><state id='t'/>");
    CHECK(m.start() == "+s -s +t");
    CHECK(m.run.state.session.sessions == 1);
}

TEST_CASE("invoke: messages go to the parent and back, and tell who sent them") {
    Machine m("<state id='s'><invoke id='c'><content><scxml version='1.0'><state id='x'><onentry>"
              "<send event='hello' target='#_parent'/></onentry><transition event='answer'><log "
              "label='child'/></transition></state></scxml></content></invoke><transition "
              "event='hello'><log expr=\"_event.invokeid .. ' ' .. _event.origin\"/><send "
              "event='answer' target='#_c'/></transition></state>");
    CHECK(m.start() == "+s +x");
    CHECK(m.step() == "(c #_scxml_s2) (child)");
}

TEST_CASE("invoke: params and namelist are first values of top-level data only (6.4.4)") {
    Machine m(invoking("<datamodel><data id='v' expr='1'/><data id='w' expr='2'/></datamodel>"
                       "<state id='x'><datamodel><data id='z' expr='3'/></datamodel><onentry><log "
                       "expr='[v, w, z]'/></onentry></state>",
                       " namelist='v'",
                       "<param name='w' expr='v + 1'/><param name='z' expr='9'/><param name='no' "
                       "expr='1'/>"));
    CHECK(m.start() == "+s +x ([7,8,3])");
}

TEST_CASE(
    "invoke: leaving the state leaves the machine's states, which sends nothing more (6.4.3)") {
    Machine m(invoking("<state id='x'><onexit><log label='out'/><send event='late' "
                       "target='#_parent'/></onexit></state>"));
    m.start();
    CHECK(m.step({"stop"}) == "(out) -x -s +end");
    CHECK(m.step().empty());
    CHECK(m.run.state.children.empty());
}

TEST_CASE("invoke: autoforward copies external events, finalize comes before the answer (6.5)") {
    Machine m(invoking("<state id='x'><transition event='e'><log label='child'/><send event='r' "
                       "target='#_parent'><param name='v' expr='8'/></send></transition></state>",
                       " autoforward='true' namelist='v'", "<finalize/>"));
    m.start();
    CHECK(m.step({"e"}) == "(e) (child) (r)");
    CHECK(m.variable("v") == Value::real(8));
}

TEST_CASE("invoke: a machine file, computed or not, and one that invokes itself") {
    Texts files;
    files.add("child.scxml", machine_file("<final id='f'/>"));
    files.add("again.scxml", machine_file("<state id='x'><invoke src='again.scxml'/></state>"));
    const LoadOptions options{.reader = &files};
    Machine named("<state id='s'><invoke id='c' src='file:child.scxml'/><transition "
                  "event='done.invoke.c'><log label='done'/></transition></state>",
                  {}, options);
    CHECK(named.start() == "+s +f -f");
    CHECK(named.step() == "(done)");
    Machine computed("<datamodel><data id='f' expr=\"'child'\"/></datamodel><state id='s'>"
                     "<onentry><assign location='f' expr=\"'child.scxml'\"/></onentry><invoke "
                     "srcexpr='f'/></state>",
                     {}, options);
    CHECK(computed.start() == "+s +f -f");
    Machine unknown("<datamodel><data id='f' expr=\"'chi' + 'ld.scxml'\"/></datamodel>"
                    "<state id='s'><invoke srcexpr='f'/><transition event='error.communication'>"
                    "<log label='unknown'/></transition></state>",
                    {}, options);
    CHECK(unknown.start() == "+s ! (unknown)");
    Machine endless("<state id='s'><invoke src='again.scxml'/></state>", {}, options);
    CHECK(endless.program.machines.size() == 1);
    endless.run.start({.dt = 0.5});
    CHECK(describe_fault(endless.program, endless.run.state)
              .find("machines invoke each other 64 deep") != std::string::npos);
}

TEST_CASE("invoke: a fault in an invoked machine is told with its place") {
    Machine m(invoking("<state id='x'><transition target='x'/></state>"));
    m.run.start({.dt = 0.5});
    CHECK(describe_fault(m.program, m.run.state)
              .find("c: in its machine: x: this machine does "
                    "not come to rest") != std::string::npos);
}

TEST_CASE("invoke: tick is each machine's own, from the cycle after its start on") {
    Machine m(invoking("<state id='x'><transition event='tick' cond='elapsed() &gt; 0.5'><log "
                       "label='t'/></transition></state>"));
    m.start();
    CHECK(m.step().empty());
    CHECK(m.step().empty());
    CHECK(m.step() == "(t)");
}

TEST_CASE("invoke: a State holds its sessions: copied, saved and restored it goes on the same") {
    Machine m(invoking("<state id='x'><onentry><send event='later' delay='1s'/></onentry>"
                       "<transition event='later' target='y'/></state><final id='y'/>"));
    m.start();
    m.step();
    const std::vector<std::byte> bytes = save(m.program, m.run.state);
    const std::optional<State> restored = restore(m.program, bytes);
    REQUIRE(restored.has_value());
    CHECK(same(m.program, *restored, m.run.state));
    CHECK(hash(m.program, *restored) == hash(m.program, m.run.state));
    const State copy = m.run.state;
    const std::string first = m.step();
    CHECK(first == "-x +y -y (done.invoke.c)");
    m.run.state = *restored;
    CHECK_FALSE(same(m.program, copy, State(fresh_state(m.program))));
    CHECK(m.step() == first);
    m.run.state = copy;
    CHECK(m.step() == first);
}

}  // namespace trellis::test
