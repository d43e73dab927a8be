// Quiet steps give what whole steps give. A traced step never is a quiet one, so two runs of the
// same machine, one of them traced, are compared tick by tick.
// SPDX-License-Identifier: MIT
#include "exec/step.h"
#include "sim/bridge/leaves.h"
#include "support/machine_story.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <string>

namespace trellis {
namespace {

const Registry& roomba() {
    static Registry registry;
    if (registry.leaves().empty()) { register_roomba(registry); }
    return registry;
}

class Nothing final : public TraceSink {
public:
    void on(const TraceEvent&) override {}
};

// Runs both for `ticks`; `change` may change robot and state before each. Returns the last status.
using Change = std::function<void(std::uint64_t tick, Roomba& robot, State& state)>;

Status compare(std::string_view states, int ticks, const Change& change = {}) {
    const Program program = test::loaded(test::machine_file(states), {}, roomba());
    State quick = fresh_state(program);
    State slow = fresh_state(program);
    Roomba quick_robot;
    Roomba slow_robot;
    Nothing trace;
    Status status = Status::idle;
    for (int i = 0; i < ticks; ++i) {
        if (change) {
            change(quick.tick, quick_robot, quick);
            change(slow.tick, slow_robot, slow);
        }
        status = step(program, quick, quick_robot, {.dt = 0.5});
        REQUIRE(step(program, slow, slow_robot, {.dt = 0.5, .trace = &trace}) == status);
        REQUIRE_MESSAGE(same(program, quick, slow), "tick " << i);
        // as values, so that NaN equals itself
        REQUIRE(Value::real(quick_robot.linear) == Value::real(slow_robot.linear));
        REQUIRE(Value::real(quick_robot.angular) == Value::real(slow_robot.angular));
        if (status != Status::running) { break; }
    }
    CHECK(describe_fault(program, quick) == describe_fault(program, slow));
    return status;
}

}  // namespace

TEST_CASE("quiet step: every form of guard and input gives what its code gives") {
    const Status status = compare(R"xml(
        <datamodel><data id="limit" expr="2"/><data id="angle" expr="0.75"/></datamodel>
        <state id="a">
          <invoke type="leaf" src="SetVelocity">
            <param name="linear" expr="limit"/> <param name="angular" expr="1 / (2 + elapsed())"/>
          </invoke>
          <transition event="tick" cond="_x.bumper" target="b"/>
          <transition event="tick" cond="elapsed() &gt; limit" target="b"/>
        </state>
        <state id="b">
          <invoke type="leaf" src="SetVelocity">
            <param name="angular" expr="angle &gt; 0 ? 0.5 : -0.5"/>
            <param name="linear" expr="_x.x * 2.0"/>
          </invoke>
          <transition event="tick" cond="elapsed() &gt; abs(angle) / 0.5" target="c">
            <assign location="angle" expr="-angle - 1"/>
            <assign location="limit" expr="limit + 0.5"/>
          </transition>
        </state>
        <state id="c">
          <invoke type="leaf" src="Wait"><param name="duration" expr="1.0"/></invoke>
          <transition event="done.invoke" target="a"/>
          <transition event="tick" cond="elapsed() &gt; 100.0" target="a"/>
        </state>)xml",
                                  300, [](std::uint64_t tick, Roomba& robot, State&) {
                                      robot.bumper = tick % 7 == 3;
                                      robot.x = static_cast<double>(tick);
                                  });
    CHECK(status == Status::running);
}

TEST_CASE("quiet step: a variable that the host changes is noticed, whatever it then holds") {
    compare(R"xml(
        <datamodel><data id="v" expr="4.0"/></datamodel>
        <state id="a">
          <invoke type="leaf" src="SetVelocity"><param name="linear" expr="v - 1"/></invoke>
          <transition event="tick" cond="elapsed() &gt; v * 2.0" target="b"/>
        </state>
        <state id="b">
          <invoke type="leaf" src="SetVelocity"><param name="linear" expr="v"/></invoke>
          <transition event="tick" cond="elapsed() &gt; v" target="a"/>
        </state>)xml",
            400, [](std::uint64_t tick, Roomba&, State& state) {
                Value& v = state.slots[0];
                wake(state);
                switch (tick % 40) {
                case 7: v = Value::integer(3); break;
                case 13: v = Value::real(std::nan("")); break;
                case 17: v = Value::text("2"); break;
                case 19: v = {}; break;
                case 23: v = Value::boolean(true); break;
                case 29: v = Value::real(-0.0); break;
                case 31: v = Value::real(0.0); break;
                case 37: v = Value::real(1.5); break;
                default: break;
                }
            });
}

TEST_CASE("quiet step: every form of formula rounds as its code does") {
    for (const std::string_view formula : {"_x.x",
                                           "_x.x * 3.0",
                                           "3.0 * _x.x",
                                           "_x.x + 0.1",
                                           "0.1 + _x.x",
                                           "_x.x - 0.1",
                                           "0.1 - _x.x",
                                           "_x.x / 3.0",
                                           "3.0 / _x.x",
                                           "0.1 - _x.x * 3.0",
                                           "_x.x * 3.0 * 7.0",
                                           "(_x.x + 0.1) * 3.0",
                                           "_x.x + 0.1 + 0.7",
                                           "_x.x / 3.0 / 7.0 - 0.1",
                                           "0.1 - (0.7 - _x.x)",
                                           "3.0 / (0.7 / (0.1 - _x.x)) + 0.0",
                                           "_x.x + 0.0",
                                           "_x.x - 0.0",
                                           "0.0 - _x.x",
                                           "_x.x * 1.0",
                                           "_x.x * -1.0 * 0.0"}) {
        CAPTURE(formula);
        compare("<state id='a'><invoke type='leaf' src='SetVelocity'><param name='linear' expr='" +
                    std::string(formula) + "'/></invoke></state>",
                60, [](std::uint64_t tick, Roomba& robot, State&) {
                    static constexpr double special[] = {0.0, -0.0, 1e308, -1e308, 5e-324};
                    robot.x = tick < std::size(special) ? special[tick]
                                                        : 0.1 * static_cast<double>(tick) - 2.0;
                });
    }
}

TEST_CASE("quiet step: limits of every size end it in the cycle that the guard asks for") {
    for (const std::string_view limit : {"0.0", "-1.0", "0.5", "2.0", "2.25", "1e300", "0.0 / 0.0",
                                         "1 / 0", "-1 / 0", "true", "'2'"}) {
        CAPTURE(limit);
        compare("<datamodel><data id='limit' expr=\"" + std::string(limit) +
                    "\"/></datamodel><state id='a'><invoke type='leaf' src='SetVelocity'/>"
                    "<transition event='tick' cond='elapsed() &gt; limit' target='b'/></state>"
                    "<state id='b'><invoke type='leaf' src='SetVelocity'/>"
                    "<transition event='tick' cond='elapsed() &gt; limit * 2' target='a'/></state>",
                40);
    }
}

TEST_CASE("quiet step: a message and an event of the host are answered in their cycle") {
    compare(R"xml(
        <state id="a">
          <onentry><send event="late" delay="3s"/><send event="later" delay="3.2s"/></onentry>
          <invoke type="leaf" src="SetVelocity"><param name="linear" expr="elapsed()"/></invoke>
          <transition event="late" target="b"/>
        </state>
        <state id="b">
          <invoke type="leaf" src="SetVelocity"><param name="linear" expr="2.0"/></invoke>
          <transition event="later hello" target="a"/>
        </state>)xml",
            60);
    const Program program = test::loaded(test::machine_file(R"xml(
        <state id="a"><invoke type="leaf" src="SetVelocity"/>
          <transition event="hello" target="b"/></state>
        <state id="b"/>)xml"),
                                         {}, roomba());
    State state = fresh_state(program);
    Roomba robot;
    for (int i = 0; i < 3; ++i) {
        step(program, state, robot, {});
    }
    CHECK(state.quiet.cycles > 0);
    send(program, state, "hello");
    step(program, state, robot, {});
    CHECK(program.name(state.session.atom) == "b");
}

TEST_CASE("quiet step: a step of another length is counted as such") {
    const Program program = test::loaded(test::machine_file(R"xml(
        <state id="a"><invoke type="leaf" src="SetVelocity"/>
          <transition event="tick" cond="elapsed() &gt; 2.0" target="b"/></state>
        <state id="b"/>)xml"),
                                         {}, roomba());
    State state = fresh_state(program);
    Roomba robot;
    for (int i = 0; i < 3; ++i) {
        step(program, state, robot, {.dt = 0.5});
    }
    CHECK(state.quiet.cycles == 2);
    // three cycles, each of a second
    step(program, state, robot, {.dt = 1.0});
    CHECK(program.name(state.session.atom) == "b");
}

TEST_CASE("quiet step: one activity of several, or none, is as without the short cut") {
    compare(R"xml(
        <state id="a">
          <invoke type="leaf" src="Wait"><param name="duration" expr="3.0"/></invoke>
          <invoke type="leaf" src="SetVelocity"><param name="linear" expr="elapsed()"/></invoke>
          <transition event="tick" cond="elapsed() &gt; 6.0" target="b"/>
        </state>
        <state id="b"><transition event="tick" cond="elapsed() &gt; 2.0" target="a"/></state>)xml",
            100);
}

TEST_CASE("quiet step: an activity that asks for a random number that is not there is a fault") {
    const std::string states = R"xml(
        <state id="a"><invoke type="leaf" src="GoBack"/>
          <transition event="done.invoke" target="b"/></state>
        <state id="b"><invoke type="leaf" src="Rotate"/></state>)xml";
    CHECK(compare(states, 20, [](std::uint64_t tick, Roomba&, State& state) {
              if (tick == 0) { state.random = Random::replaying({}); }
          }) == Status::idle);
}

}  // namespace trellis
