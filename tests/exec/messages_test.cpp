// Messages: <send>, <cancel>, delays, the fields of _event, one behaviour per case. Section numbers
// are those of the SCXML Recommendation. Cycles are of half a second.
// SPDX-License-Identifier: MIT
#include "support/machine_story.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis::test {
namespace {

/// A state that does `content` when it is entered and logs every event.
std::string on_entry(const std::string& content, const std::string& more = {}) {
    return "<datamodel><data id='v' expr='1'/></datamodel><state id='a'><onentry>" + content +
           "</onentry><transition event='*'><log expr='_event.name'/>" + more +
           "</transition></state>";
}

}  // namespace

TEST_CASE("send: to itself comes after what was raised (6.2)") {
    Machine m(on_entry("<send event='sent'/><raise event='raised'/><send event='inner' "
                       "target='#_internal'/>"));
    CHECK(m.start() == "+a (raised) (inner)");
    CHECK(m.step() == "(sent)");
}

TEST_CASE("send: a delay counts cycles, and the earlier message comes first") {
    Machine m(on_entry("<send event='late' delay='1s'/><send event='b' delay='.4s'/>"
                       "<send event='a' delay='300ms'/><send event='now'/>"));
    m.start();
    CHECK(m.step() == "(now) (a) (b)");
    CHECK(m.step() == "(late)");
    CHECK(m.step().empty());
}

TEST_CASE("send: what it carries is evaluated when it is sent (6.2.4)") {
    Machine m(on_entry("<send event='e' delay='1s'><param name='x' expr='v'/></send>"
                       "<assign location='v' expr='2'/>",
                       "<log expr='_event.data.x'/>"));
    m.start();
    m.step();
    CHECK(m.step() == "(e) (1)");
}

TEST_CASE("send: namelist, params and content are the data of the event") {
    Machine m(on_entry("<send event='e' namelist='v'><param name='w' expr='2'/></send>"
                       "<send event='f'><content>[1, {a: 2}]</content></send>"
                       "<send event='g'><content> some   words </content></send>"
                       "<send event='h'><content><b xmlns=''>x</b></content></send>",
                       "<log expr='_event.data'/>"));
    m.start();
    CHECK(m.step() == "(e) ({\"v\":1,\"w\":2}) (f) ([1,{\"a\":2}]) (g) (some words) (h) "
                      "(<b xmlns=\"\">x</b>)");
}

TEST_CASE("send: all fields of _event are there, sendid only if there is an id (5.10.1)") {
    Machine m(on_entry("<send event='e' id='me'/><send event='f'/>",
                       "<log expr='_event.sendid'/><log expr='_event.origin'/><log "
                       "expr='_event.type'/><log expr='_event.invokeid'/>"));
    m.start();
    CHECK(m.step() == "(e) (me) (#_scxml_s1) (external) (undefined) (f) (undefined) "
                      "(#_scxml_s1) (external) (undefined)");
}

TEST_CASE("send: wrong targets and types are error.execution, lost ones error.communication") {
    Machine m(on_entry("<send event='e' target='baz'/>"));
    CHECK(m.start() == "+a ! (error.execution)");
    Machine type(on_entry("<send event='e' type='http://smoke'/>"));
    CHECK(type.start() == "+a ! (error.execution)");
    Machine lost(on_entry("<send event='e' target='#_scxml_s9'/><log label='goes on'/>"));
    CHECK(lost.start() == "+a ! (goes on) (error.communication)");
    Machine parent(on_entry("<send event='e' target='#_parent'/>"));
    CHECK(parent.start() == "+a ! (error.communication)");
}

TEST_CASE("send: a message to the own session id, and to an origin, arrives (C.1)") {
    Machine m(on_entry("<send event='e' targetexpr=\"'#_scxml_' + _sessionid\"/>"));
    m.start();
    CHECK(m.step() == "(e)");
    Machine io(on_entry("<send event='e' targetexpr='_ioprocessors.scxml.location'/>"));
    io.start();
    CHECK(io.step() == "(e)");
}

TEST_CASE("cancel: takes back all messages with the id (6.3)") {
    Machine m(on_entry("<send event='a' id='x' delay='1s'/><send event='b' id='x' delay='1s'/>"
                       "<send event='c' id='y' delay='1s'/><cancel sendid='x'/>"));
    m.start();
    m.step();
    CHECK(m.step() == "(c)");
}

TEST_CASE("send: idlocation gets an id of its own, which cancels") {
    Machine m(on_entry("<send event='a' idlocation='v' delay='1s'/><log expr='v'/><cancel "
                       "sendidexpr='v'/>"));
    CHECK(m.start() == "+a (send.s1.1)");
    m.step();
    CHECK(m.step().empty());
}

TEST_CASE("foreach: goes through the elements that there were, and makes its variables (4.6)") {
    Machine m("<datamodel><data id='list' expr='[1, 2]'/></datamodel><state id='a'><onentry>"
              "<foreach array='list' item='x' index='i'><assign location='list' "
              "expr='append(list, x)'/><log expr='x * 10 + i'/></foreach><log expr='len(list)'/>"
              "</onentry></state>");
    CHECK(m.start() == "+a (10) (21) (4)");
}

TEST_CASE("foreach: an error inside it ends it, what is no array is an error") {
    Machine m("<datamodel><data id='v' expr='1'/></datamodel><state id='a'><onentry><foreach "
              "array='[1, 2]' item='x'><log expr='x'/><log expr='nosuch'/></foreach><log "
              "label='no'/></onentry><onentry><foreach array='v' item='x'/><log label='no'/>"
              "</onentry></state>");
    CHECK(m.start() == "+a (1) ! !");
}

TEST_CASE("machine: a million raised events end in a fault, not in memory") {
    Machine m("<datamodel><data id='l' expr='[1,2,3,4,5,6,7,8,9,10]'/></datamodel><state id='a'>"
              "<onentry><raise event='e'/></onentry><transition event='e'><foreach array='l' "
              "item='x'><foreach array='l' item='y'><foreach array='l' item='z'><raise event='e'/>"
              "</foreach></foreach></foreach></transition></state>");
    m.run.start({.dt = 0.5});
    CHECK(m.run.state.fault.kind == Fault::Kind::livelock);
    CHECK(m.run.state.fault.message.starts_with("this machine does not come to rest: "));
}

TEST_CASE("machine: a storm of messages ends in a fault, now or later") {
    for (const char* delay : {"", " delay='5s'"}) {
        Machine m("<datamodel><data id='l' expr='[1,2,3,4,5,6,7,8,9,10]'/></datamodel>"
                  "<state id='a'><onentry><raise event='e'/></onentry><transition event='e'>"
                  "<foreach array='l' item='x'><send event='f'" +
                  std::string(delay) + "/></foreach><raise event='e'/></transition></state>");
        m.run.start({.dt = 0.5});
        CHECK(m.run.state.fault.kind == Fault::Kind::livelock);
    }
}

TEST_CASE("machine: time can jump to what happens next") {
    Machine m(on_entry("<send event='e' delay='2m'/>"));
    m.start();
    CHECK(idle_cycles(m.program, m.run.state) == std::optional<std::uint64_t>(239));
    skip_cycles(m.run.state, 239);
    CHECK(m.step() == "(e)");
    CHECK(m.run.state.tick == 240);
    CHECK_FALSE(idle_cycles(m.program, m.run.state).has_value());
}

}  // namespace trellis::test
