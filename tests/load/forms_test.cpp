// Which guards and inputs get a form that needs no code. That forms and code say the same is in
// tests/exec/quiet_step_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/forms.h"

#include "sim/bridge/leaves.h"
#include "support/machine_story.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis {
namespace {

const Registry& roomba() {
    static Registry registry;
    if (registry.leaves().empty()) { register_roomba(registry); }
    return registry;
}

Program machine(const std::string& guard, const std::string& input) {
    return test::loaded(test::machine_file("<datamodel><data id=\"v\" expr=\"1.0\"/><data id=\"w\" "
                                           "expr=\"1.0\"/></datamodel><state id=\"a\"><invoke "
                                           "type=\"leaf\" src=\"SetVelocity\"><param "
                                           "name=\"linear\" expr=\"" +
                                           input +
                                           "\"/></invoke><transition event=\"tick\" cond=\"" +
                                           guard + "\" target=\"a\"/></state>"),
                        {}, roomba());
}

Condition::Form guard(const std::string& cond) {
    const Program program = machine(cond, "0.5");
    return program.transitions.back().guard.form;
}

// "elapsed", "sensor", "steady" or "code"; the number of steps after the first two
std::string input(const std::string& expr) {
    const Program program = machine("_x.bumper", expr);
    const FormulaId id = program.live_inputs.back().formula;
    if (!id) { return program.live_inputs.back().steady ? "steady" : "code"; }
    static constexpr const char* names[] = {"elapsed", "elapsed", "sensor"};
    const Formula& formula = program.formulas[id.index];
    return std::string(names[static_cast<std::size_t>(formula.source)]) + ' ' +
           std::to_string(formula.step_count);
}

}  // namespace

TEST_CASE("forms: sensors and times are answered without code, other guards are not") {
    using enum Condition::Form;
    CHECK(guard("_x.bumper") == sensor);
    CHECK(guard("elapsed() &gt; 2.5") == elapsed);
    CHECK(guard("elapsed() &gt; v") == elapsed_variable);
    CHECK(guard("elapsed() &gt; abs(v) / 0.5") == elapsed_variable);
    CHECK(guard("elapsed() &gt; v * v + 1") == elapsed_variable);
    CHECK(guard("!_x.bumper") == code);
    CHECK(guard("elapsed() &gt;= 2.5") == code);
    CHECK(guard("elapsed() &gt; v + w") == elapsed_variable);
    CHECK(guard("elapsed() &gt; (v &gt; 0 ? 1 : 2)") == code);
    CHECK(guard("elapsed() &gt; v + uniform(0, 1)") == code);
    CHECK(guard("elapsed() &gt; v + _x.x") == code);
    CHECK(guard("elapsed() &gt; elapsed() + v") == code);
    CHECK(guard("elapsed() &gt; 1 &amp;&amp; v &gt; 2") == code);
    CHECK(guard("2 &gt; elapsed()") == code);
}

TEST_CASE("forms: arithmetic with literals needs no code, and few steps") {
    CHECK(input("elapsed()") == "elapsed 0");
    CHECK(input("_x.x - 1.0") == "sensor 1");
    CHECK(input("1.0 - 2.0 * _x.x") == "sensor 2");
    CHECK(input("0.5 / (0.2 + 0.05 * elapsed())") == "elapsed 1");
    CHECK(input("(elapsed() + 1.0) * 2.0 * 3.0 / 7.0 + 1.0") == "elapsed 4");
    CHECK(input("v + elapsed()") == "code");
    CHECK(input("v + _x.x") == "code");
}

TEST_CASE("forms: what only variables decide is steady") {
    CHECK(input("v") == "steady");
    CHECK(input("v &gt; 0 ? 0.5 : -0.5") == "steady");
    CHECK(input("v + v * 2 - abs(v)") == "steady");
    CHECK(input("v + w") == "steady");
    CHECK(input("uniform(0, v)") == "code");
    CHECK(input("(v := 2) + 1") == "code");
}

}  // namespace trellis
