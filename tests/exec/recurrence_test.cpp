// States that differ only in when they are reached: what recurs goes on recurring, what waits for a
// time does not recur before it is over.
// SPDX-License-Identifier: MIT
#include "core/recurrence.h"

#include "exec/step.h"
#include "support/loading.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace trellis {
namespace {

/// The states after each of the first ticks of a program without a robot.
std::vector<State> states_of(const Program& program, int ticks) {
    std::vector<State> states{fresh_state(program)};
    start(program, states[0], {});
    for (int i = 0; i < ticks; ++i) {
        states.push_back(states.back());
        step(program, states.back(), {});
    }
    return states;
}

/// How many ticks after tick 20 the state of tick 20 comes back; 0 if it does not. Whatever comes
/// back has the same future.
int period_of(const std::string& text) {
    const Program program = test::loaded(text);
    const std::vector<State> states = states_of(program, 200);
    int period = 0;
    for (std::size_t i = 0; i + 1 < states.size(); ++i) {
        for (std::size_t j = i + 1; j + 1 < states.size(); ++j) {
            if (!recurs(program, states[i], states[j])) continue;
            CHECK(recurs(program, states[i + 1], states[j + 1]));
            if (i == 20 && period == 0) period = static_cast<int>(j - i);
        }
    }
    return period;
}

std::string tree(const std::string& node) {
    return R"(<root BTCPP_format="4"><BehaviorTree ID="T">)" + node + "</BehaviorTree></root>";
}

std::string machine(const std::string& states) {
    return R"(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" datamodel="script">)" +
           states + "</scxml>";
}

TEST_CASE("recurrence: what waits comes back when its time is over") {
    CHECK(period_of(tree("<AlwaysSuccess/>")) == 1);
    const int sleep = period_of(tree("<Sleep msec='100'/>"));
    CHECK(sleep >= 6);
    CHECK(sleep <= 8);
    // the second begins in the tick in which the first ends
    CHECK(period_of(tree("<Sequence><Sleep msec='100'/><Sleep msec='100'/></Sequence>")) ==
          2 * sleep - 1);
    CHECK(period_of(tree("<Timeout msec='100'><Sleep msec='1000'/></Timeout>")) > 0);
    CHECK(period_of(tree("<Delay delay_msec='100'><AlwaysFailure/></Delay>")) > 0);
    // over after the last tick that is looked at
    CHECK(period_of(tree("<Sleep msec='100000'/>")) == 0);
}

TEST_CASE("recurrence: time counts only where somebody reads it") {
    const std::string two = R"(
        <state id="a"><transition event="tick" cond="elapsed() &gt; 0.09" target="b"/></state>
        <state id="b"><transition event="tick" cond="elapsed() &gt; 0.09" target="a"/></state>)";
    CHECK(period_of(machine(two)) == 12);
    CHECK(period_of(machine("<state id='a'/>")) == 1);
    CHECK(period_of(machine(R"(<state id="a"><transition event="tick" cond="elapsed() &gt; 100"
        target="a"/></state>)")) == 0);
}

TEST_CASE("recurrence: variables count") {
    const std::string counting = R"(<datamodel><data id="n" expr="0"/></datamodel>
        <state id="a"><transition event="tick"><assign location="n" expr="n + 1"/></transition>
        </state>)";
    CHECK(period_of(machine(counting)) == 0);
    const std::string turning = R"(<datamodel><data id="n" expr="0"/></datamodel>
        <state id="a"><transition event="tick"><assign location="n" expr="n == 4 ? 0 : n + 1"/>
        </transition></state>)";
    CHECK(period_of(machine(turning)) == 5);
}

TEST_CASE("recurrence: messages that wait are not looked into") {
    const std::string sending = R"(<state id="a"><onentry><send event="x" delay="0.1s"/></onentry>
        <transition event="x" target="a"/></state>)";
    CHECK(period_of(machine(sending)) == 0);
}

}  // namespace
}  // namespace trellis
