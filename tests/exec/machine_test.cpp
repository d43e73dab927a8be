// How statecharts run: entering and leaving, selection, executable content and data,
// one behaviour per case. Section numbers are those of the SCXML Recommendation.
// SPDX-License-Identifier: MIT
#include "support/machine_story.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace trellis::test {
namespace {

constexpr std::string_view nested =
    "<state id='a'><onentry><log label='in a'/></onentry><onexit><log label='out a'/></onexit>"
    "<transition event='next' target='b'><log label='between'/></transition>"
    "<state id='a1'><onentry><log label='in a1'/></onentry><onexit><log label='out a1'/></onexit>"
    "<transition event='self' target='a1'/><transition event='up' target='a'/></state></state>"
    "<state id='b'/>";

}  // namespace

// Entering and leaving ----------------------------------------------------------------------------

TEST_CASE("machine: enters outermost first and leaves innermost first (3.13)") {
    Machine m(nested);
    CHECK(m.start() == "+a (in a) +a1 (in a1)");
    CHECK(m.step({"next"}) == "(out a1) -a1 (out a) -a (between) +b");
    CHECK(m.active() == "b");
    CHECK(m.last == Status::running);
}

TEST_CASE("machine: a transition to itself leaves and enters again, to an ancestor leaves that") {
    Machine m(nested);
    m.start();
    CHECK(m.step({"self"}) == "(out a1) -a1 +a1 (in a1)");
    CHECK(m.step({"up"}) == "(out a1) -a1 (out a) -a +a (in a) +a1 (in a1)");
}

TEST_CASE("machine: step() starts what was not started") {
    Machine m(nested);
    CHECK(m.step({"next"}) == "+a (in a) +a1 (in a1) (out a1) -a1 (out a) -a (between) +b");
}

TEST_CASE(
    "machine: begins at initial, as an attribute, with content, or at its first state (3.6)") {
    CHECK(Machine("<state id='a'/><state id='b'/>").start() == "+a");
    CHECK(Machine("<state id='a'/><state id='b'/>", "initial='b'").start() == "+b");
    CHECK(Machine("<state id='a' initial='a2'><state id='a1'/><state id='a2'/></state>").start() ==
          "+a +a2");
    CHECK(Machine("<state id='a'><onentry><log label='in'/></onentry><initial><transition "
                  "target='a2'><log label='way'/></transition></initial><state id='a1'/>"
                  "<state id='a2'/></state>")
              .start() == "+a (in) (way) +a2");
}

TEST_CASE("machine: initial may name a state deep inside, those on the way do not begin (3.6)") {
    CHECK(Machine("<state id='a'><state id='a1'><initial><transition target='x'><log label='no'/>"
                  "</transition></initial><state id='x'/><state id='y'/></state></state>",
                  "initial='y'")
              .start() == "+a +a1 +y");
}

TEST_CASE("machine: an internal transition stays inside its source, an external one leaves it") {
    const std::string_view states =
        "<state id='a'><transition event='in' type='internal' target='a2'/>"
        "<transition event='ex' target='a2'/><transition event='self' type='internal' "
        "target='a'/><state id='a1'/><state id='a2'/></state>";
    Machine m(states);
    m.start();
    CHECK(m.step({"in"}) == "-a1 +a2");
    CHECK(m.step({"ex"}) == "-a2 -a +a +a2");
    CHECK(m.step({"self"}) == "-a2 -a +a +a1");
}

TEST_CASE("machine: a targetless transition leaves nothing (3.13)") {
    Machine m("<state id='a'><transition event='e'><log label='only this'/></transition></state>");
    m.start();
    CHECK(m.step({"e"}) == "(only this)");
}

TEST_CASE("machine: blocks of onentry and onexit run in document order, each on its own") {
    Machine m("<datamodel><data id='v' expr='0'/></datamodel><state id='a'><onentry><log "
              "label='1'/><assign location='v' expr='nosuch'/><log label='not done'/></onentry>"
              "<onentry><log label='2'/></onentry></state>");
    CHECK(m.start() == "+a (1) ! (2)");
}

// Selection ---------------------------------------------------------------------------------------

TEST_CASE("machine: inner states come before outer ones, earlier transitions before later ones") {
    Machine m("<state id='a'><transition event='e' target='c'/><state id='a1'><transition "
              "event='e' cond='false' target='c'/><transition event='e' target='b'/><transition "
              "event='e' target='c'/></state></state><state id='b'/><state id='c'/>");
    m.start();
    CHECK(m.step({"e"}) == "-a1 -a +b");
}

TEST_CASE("machine: descriptors are prefixes of tokens (3.12.1)") {
    struct {
        const char* descriptor;
        const char* event;
        bool matches;
    } const cases[] = {
        {"foo", "foo", true},        {"foo", "foo.bar", true},   {"foo", "foos", false},
        {"foo.bar", "foo", false},   {"foo.*", "foo.bar", true}, {"foo.*", "foo", true},
        {"foo.", "foo.x.y", true},   {"*", "anything", true},    {".*", "any.thing", true},
        {"a foo", "foo.bar", true},  {"a b", "c", false},        {"foo.bar", "foo.bars", false},
        {"foo", "foo-bar.x", false},
    };
    for (const auto& c : cases) {
        CAPTURE(c.descriptor);
        CAPTURE(c.event);
        Machine m("<state id='a'><transition event='" + std::string(c.descriptor) +
                  "' target='b'/></state><state id='b'/>");
        m.start();
        m.step({c.event});
        CHECK((m.active() == "b") == c.matches);
    }
}

TEST_CASE("machine: tick is queued in every cycle, if a transition names it, and not for *") {
    Machine named("<state id='a'><transition event='tick'><log label='t'/></transition></state>");
    named.start();
    CHECK(named.step() == "(t)");
    CHECK(named.step() == "(t)");
    Machine star("<state id='a'><transition event='*'><log label='any'/></transition></state>");
    star.start();
    CHECK(star.step().empty());
    CHECK(star.step({"other"}) == "(any)");
}

TEST_CASE("machine: events that wait come before the tick of the cycle") {
    Machine m("<state id='a'><transition event='tick'><log label='t'/></transition><transition "
              "event='e'><log label='e'/></transition></state>");
    m.start();
    CHECK(m.step({"e", "e"}) == "(e) (e) (t)");
}

TEST_CASE("machine: eventless transitions come before internal events, those before external") {
    Machine m("<datamodel><data id='n' expr='0'/></datamodel><state id='a'><transition event='e' "
              "target='b'><raise event='i'/></transition></state><state id='b'><transition "
              "cond='n == 0' target='c'><assign location='n' expr='1'/></transition><transition "
              "event='i'><log label='too early'/></transition></state><state id='c'><transition "
              "event='i'><log label='i'/></transition><transition event='e'><log label='e'/>"
              "</transition></state>");
    m.start();
    CHECK(m.step({"e", "e"}) == "-a +b -b +c (i) (e)");
}

TEST_CASE("machine: raised events are processed in the order in which they were raised (4.2)") {
    Machine m("<state id='a'><onentry><raise event='x'/><raise event='y'/></onentry><transition "
              "event='y'><log label='y'/></transition><transition event='x'><log label='x'/>"
              "</transition></state>");
    CHECK(m.start() == "+a (x) (y)");
}

// Final states ------------------------------------------------------------------------------------

TEST_CASE("machine: done.state.ID follows the onentry of the final state (3.7)") {
    Machine m("<state id='a'><transition event='done.state.a' target='b'/><state id='a1'>"
              "<transition event='e' target='f'/></state><final id='f'><onentry><raise event='x'/>"
              "</onentry></final><transition event='x'><log label='x'/></transition></state>"
              "<state id='b'/>");
    m.start();
    CHECK(m.step({"e"}) == "-a1 +f (x) -f -a +b");
}

TEST_CASE("machine: a state without an id may have a final state too") {
    Machine m("<state><state id='a1'><transition event='e' target='f'/></state><final id='f'/>"
              "<transition event='done.state'><log label='done'/></transition></state>");
    m.start();
    CHECK(m.step({"e"}).starts_with("-a1 +f"));
    CHECK_FALSE(m.run.state.fault);
}

TEST_CASE("machine: a top-level final state ends it: all states are left, the rest is dropped") {
    const std::string_view states =
        "<state id='a'><transition event='e' target='done'><raise event='x'/></transition></state>"
        "<final id='done'><onexit><log label='bye'/></onexit></final>";
    Machine m(states);
    m.start();
    CHECK(m.step({"e", "e"}) == "-a +done (bye) -done");
    CHECK(m.last == Status::success);
    CHECK(m.program.name(m.run.state.session.final) == "done");
}

TEST_CASE("machine: the final state called failure is a failure") {
    Machine m("<state id='a'><transition event='e' target='failure'/></state><final "
              "id='failure'/>");
    m.start();
    m.step({"e"});
    CHECK(m.last == Status::failure);
}

// Data and expressions ----------------------------------------------------------------------------

TEST_CASE("machine: early data is there from the start, also of states not entered (5.3)") {
    Machine m("<datamodel><data id='x' expr='1 + 1'/><data id='t'>some  text</data><data id='u'/>"
              "</datamodel><state id='a'/><state id='b'><datamodel><data id='y' expr='[1, 2]'/>"
              "</datamodel></state>");
    m.start();
    CHECK(print(m.variable("x")) == "2.0");
    CHECK(print(m.variable("y")) == "[1.0, 2.0]");
    CHECK(print(m.variable("t")) == "\"some text\"");
    CHECK(print(m.variable("u")) == "undefined");
}

TEST_CASE("machine: late data is set when its state is first entered, whatever it held (5.3.3)") {
    Machine m("<state id='a'><onentry><assign location='y' expr='9'/></onentry><transition "
              "event='e' target='b'/></state><state id='b'><datamodel><data id='y' expr='1'/>"
              "</datamodel><onentry><log expr='y'/><assign location='y' expr='5'/></onentry>"
              "<transition event='e' target='b'/></state>",
              "binding='late'");
    CHECK(m.start() == "+a");
    CHECK(m.variable("y") == Value::real(9.0));
    CHECK(m.step({"e"}) == "-a +b (1)");
    CHECK(m.step({"e"}) == "-b +b (5)");
}

TEST_CASE("machine: late data is undefined before its state is entered") {
    Machine m("<state id='a'/><state id='b'><datamodel><data id='y' expr='1'/></datamodel></state>",
              "binding='late'");
    m.start();
    CHECK(print(m.variable("y")) == "undefined");
}

TEST_CASE("machine: if, elseif, else: the first that holds, a failing one is false (4.3)") {
    Machine m(
        "<datamodel><data id='n' expr='2'/></datamodel><state id='a'><onentry>"
        "<if cond='n == 1'><log label='one'/><elseif cond='nosuch'/><log label='no'/>"
        "<elseif cond='n == 2'/><log label='two'/><elseif cond='true'/><log label='late'/>"
        "<else/><log label='else'/></if><log label='after'/>"
        "<if cond='false'><log label='no'/><else/><log label='else'/></if></onentry></state>");
    CHECK(m.start() == "+a ! (two) (after) (else)");
}

TEST_CASE("machine: a guard that fails is false and raises error.execution (5.9.1)") {
    Machine m("<state id='a'><transition event='e' cond='nosuch' target='b'/><transition "
              "event='e'><log label='other'/></transition><transition event='error.execution'>"
              "<log label='told'/></transition></state><state id='b'/>");
    m.start();
    CHECK(m.step({"e"}) == "! (other) (told)");
}

TEST_CASE("machine: a guard that always fails is a livelock, not a hang") {
    Machine m("<state id='a'><transition cond='nosuch' target='a'/></state>");
    m.run.host.records = false;
    m.run.start({.dt = 0.5});
    CHECK(m.run.state.fault.kind == Fault::Kind::livelock);
}

TEST_CASE("machine: transitions that swap for ever are a livelock") {
    Machine m("<state id='a'><transition target='b'/></state><state id='b'><transition "
              "target='a'/></state>");
    m.run.start({.dt = 0.5});
    CHECK(m.run.state.fault.kind == Fault::Kind::livelock);
    CHECK(m.run.state.fault.message ==
          "this machine does not come to rest: too many events and transitions in one cycle, "
          "again and again from \"b\", \"a\"");
}

TEST_CASE("machine: _event tells the name, type and data of the event, also after it (5.10.1)") {
    Machine m("<state id='a'><transition event='e' target='b'/></state><state id='b'><onentry><log "
              "expr=\"_event.name .. ' ' .. _event.type\"/><raise event='i'/></onentry><transition "
              "event='i' target='c'><log expr=\"_event.name .. ' ' .. _event.type\"/></transition>"
              "</state><state id='c'><transition event='*'><log expr='_event.data.v'/></transition>"
              "</state>");
    m.start();
    CHECK(m.step({"e.more"}) == "-a +b (e.more external) -b (i internal) +c");
    Value data = Value::object();
    data.set_member("v", Value::integer(7));
    send(m.program, m.run.state, "x", data);
    CHECK(m.step() == "(7)");
}

TEST_CASE("machine: In() tells what is active, also by a name known only now (5.9.2)") {
    Machine m("<datamodel><data id='s' expr=\"'a'\"/></datamodel><state id='a'><onexit><log "
              "expr=\"In('a')\"/></onexit><transition event='e' cond=\"In('a') &amp;&amp; "
              "!In('b') &amp;&amp; In(s)\" target='b'/></state><state id='b'><onentry><log "
              "expr=\"In('a') .. ' ' .. In('b')\"/></onentry></state>");
    m.start();
    CHECK(m.step({"e"}) == "(true) -a +b (false true)");
}

TEST_CASE("machine: sensors are read only, and seen by guards of the same cycle") {
    Machine m("<state id='a'><transition event='tick' cond='_x.bumper' target='b'/></state>"
              "<state id='b'/>");
    m.start();
    CHECK(m.step().empty());
    m.run.host.bumper = true;
    CHECK(m.step() == "-a +b");
}

TEST_CASE("halt: a machine leaves its states and begins anew with the next step") {
    Machine m(nested);
    m.start();
    m.run.halt({.dt = 0.5, .trace = &m.story});
    CHECK(m.story.take() == "(out a1) -a1 (out a) -a");
    CHECK(m.step() == "+a (in a) +a1 (in a1)");
}

}  // namespace trellis::test
