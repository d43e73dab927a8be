// Activities of states: leaves and trees that run while a state is active, their parameters, what
// their end tells, and how they are halted (MACHINES, SCXML 6.4).
// SPDX-License-Identifier: MIT
#include "support/machine_story.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

namespace trellis::test {
namespace {

/// Runs for ever and reports its input.
struct Live {
    std::int32_t value = 0;
    Status tick(ScriptHost& host, const Tick&) const {
        host.report("live", '=', std::to_string(value));
        return Status::running;
    }
};

const Registry& live_registry() {
    static Registry registry;
    if (registry.leaves().empty()) {
        registry.add<Live, ScriptHost>("Live", "report an input").input("value", &Live::value);
    }
    return registry;
}

}  // namespace

TEST_CASE(
    "invoke: a leaf runs from the cycle its state is entered, and is halted when it is left") {
    Machine m("<state id='a'><invoke type='leaf' src='Leaf'><param name='id' expr=\"'l'\"/><param "
              "name='script' expr=\"'R'\"/></invoke><transition event='e' target='b'/></state>"
              "<state id='b'/>");
    m.start();
    m.step();
    CHECK(m.run.take_events() == "l:RUNNING");
    CHECK(m.step({"e"}) == "-a +b");
    CHECK(m.run.take_events() == "l:HALT");
}

TEST_CASE("invoke: its end is an event of the next cycle, with the status as suffix and data") {
    Machine m("<state id='a'><invoke type='leaf' id='drive' src='Leaf'><param name='id' "
              "expr=\"'l'\"/><param name='script' expr=\"'RF'\"/></invoke><transition "
              "event='done.invoke.drive' target='b'><log expr=\"_event.name .. ' ' .. "
              "_event.data.status .. ' ' .. _event.invokeid\"/></transition></state><state "
              "id='b'/>");
    m.start();
    CHECK(m.step().empty());
    CHECK(m.step().empty());
    CHECK(m.step() == "-a (done.invoke.drive.failure failure drive) +b");
    CHECK(m.run.take_events() == "l:RUNNING l:FAILURE");
}

TEST_CASE("invoke: an end that comes after its state was entered again is dropped") {
    const std::string script = "<param name='script' expr=\"'S'\"/></invoke>";
    Machine m("<state id='o'><invoke type='leaf' id='x' src='Leaf'>" + script +
              "<transition event='done.invoke.x' type='internal' target='i'/>"
              "<state id='i'><invoke type='leaf' id='y' src='Leaf'>" +
              script +
              "<transition event='done.invoke.y'><log label='done'/></transition></state></state>");
    m.start();
    CHECK(m.step().empty());  // x ends, then y
    CHECK(m.step() == "-i +i");
    CHECK(m.step() == "(done)");
}

TEST_CASE("invoke: elapsed() in a guard is the time before this cycle, in a param with it") {
    Machine m("<state id='a'><invoke type='leaf' src='GetDouble'><param name='id' expr=\"'p'\"/>"
              "<param name='in' expr='elapsed()'/></invoke><transition event='tick'><log "
              "expr='elapsed()'/></transition></state>");
    m.start();
    CHECK(m.step() == "(0)");
    CHECK(m.step() == "(0.5)");
    CHECK(m.run.take_events() == "p=0.5");
}

TEST_CASE("invoke: a leaf's params are live: read again before each tick") {
    Machine m("<datamodel><data id='n' expr='0'/></datamodel><state id='a'><invoke type='leaf' "
              "src='Live'><param name='value' expr='n'/></invoke><transition event='tick'>"
              "<assign location='n' expr='n + 1'/></transition></state>",
              {}, {}, live_registry());
    m.start();
    m.step();
    m.step();
    CHECK(m.run.take_events() == "live=1 live=2");
}

TEST_CASE("invoke: a param that fails raises error.execution and the leaf runs without it (5.7)") {
    Machine m("<state id='a'><invoke type='leaf' src='GetDouble'><param name='id' expr=\"'p'\"/>"
              "<param name='in' expr='nosuch'/></invoke><transition event='error.execution'><log "
              "label='told'/></transition></state>");
    m.start();
    m.step();
    CHECK_FALSE(m.run.state.fault);
    CHECK(m.run.take_events() == "p=ERR");
    CHECK(m.step() == "(told)");
}

TEST_CASE("invoke: a tree runs with its own variables, params are written before each tick") {
    Texts texts;
    texts.add("sub.xml", "<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence><Echo id='e' "
                         "in='{v}'/><Leaf id='l' script='RS'/></Sequence></BehaviorTree>"
                         "</root>");
    Machine m("<datamodel><data id='n' expr='0'/></datamodel><state id='a'><invoke type='tree' "
              "id='t' src='sub.xml'><param name='v' expr='n'/></invoke><transition event='tick'>"
              "<assign location='n' expr='n + 1'/></transition><transition "
              "event='done.invoke.t.success' target='b'/></state><state id='b'/>",
              {}, {.reader = &texts});
    m.start();
    m.step();
    m.step();
    CHECK(m.run.take_events() == "e=1 l:RUNNING l:SUCCESS");
    CHECK(m.step() == "-a +b");
}

TEST_CASE("invoke: leaving a state halts its tree, every running leaf once") {
    Texts texts;
    texts.add("sub.xml", "<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence><Leaf id='l' "
                         "script='R'/></Sequence></BehaviorTree></root>");
    Machine m("<state id='a'><invoke type='tree' src='sub.xml'/><transition event='e' "
              "target='a'/></state>",
              {}, {.reader = &texts});
    m.start();
    m.step();
    m.step({"e"});
    CHECK(m.run.take_events() == "l:RUNNING l:HALT l:RUNNING");
}

}  // namespace trellis::test
