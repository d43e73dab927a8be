// Machines to programs: states, targets, domains, names, activities, and every message about them.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis::test {
namespace {

std::string machine(const std::string& states, const std::string& attributes = {}) {
    return "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0' " + attributes + ">\n" +
           states + "\n</scxml>";
}

}  // namespace

TEST_CASE("compile machine: rows are the states in document order, activities before states") {
    const Program program = loaded(
        machine("<state id='a'><state id='a1'/><invoke type='leaf' id='i' src='Leaf'><param "
                "name='script' expr=\"'S'\"/></invoke><final id='a2'/></state><state id='b'/>",
                "name='m'"));
    std::string rows;
    for (std::uint32_t n = 0; n < program.rows.size(); ++n) {
        rows += std::string(op_table()[program.rows[n].op].name) + ' ' + program.names[n] + ' ' +
                std::to_string(program.rows[n].end.index) + '\n';
    }
    CHECK(rows == "machine m 7\nstate a 6\ninvoke i 4\naction Leaf 4\nstate a1 5\nfinal a2 6\n"
                  "state b 7\n");
}

TEST_CASE("compile machine: an unknown state, with the one that was meant") {
    CHECK(complaints(machine("<state id='Forward'><transition target='Foward'/></state>")) ==
          "2:41: unknown-state: there is no state \"Foward\"; did you mean \"Forward\"?\n");
}

TEST_CASE("compile machine: an initial state must lie inside") {
    CHECK(
        complaints(machine("<state id='a' initial='b'><state id='a1'/></state><state id='b'/>")) ==
        "2:24: initial-outside: \"b\" is not inside \"a\"\n");
    CHECK(complaints(machine("<state id='a' initial='a'><state id='a1'/></state>")) ==
          "2:24: initial-outside: \"a\" is not inside \"a\"\n");
    CHECK(complaints(machine("<state id='a' initial='a'/>")) ==
          "2:24: initial-outside: \"a\" has no states to begin in\n");
}

TEST_CASE("compile machine: two targets must be able to be active together (3.13)") {
    CHECK(complaints(machine("<state id='a'><transition event='e' target='b c'/></state>"
                             "<state id='b'/><state id='c'/>")) ==
          "2:45: illegal-targets: the states \"b\" and \"c\" cannot be active together\n");
    CHECK(complaints(machine("<state id='a'><transition event='e' target='b b1'/></state>"
                             "<state id='b' initial='b1'><state id='b1'/></state>"))
              .empty());
}

TEST_CASE("compile machine: ids are unique") {
    CHECK(complaints(machine("<state id='a'/><state id='a'/>")) ==
          "2:27: duplicate-id: there is already a state \"a\"\n");
    CHECK(
        complaints(machine("<datamodel><data id='v'/><data id='v'/></datamodel><state id='a'/>")) ==
        "2:36: duplicate-id: there is already a variable \"v\"\n");
}

TEST_CASE("compile machine: unknown leaves and ports, missing params, values that do not fit") {
    CHECK(complaints(machine("<state id='a'><invoke type='leaf' src='Leav'/></state>")) ==
          "2:40: unknown-leaf: there is no leaf \"Leav\"; did you mean \"Leaf\"?\n");
    CHECK(complaints(machine("<state id='a'><invoke type='leaf' src='Leaf'><param name='skript' "
                             "expr='1'/></invoke></state>")) ==
          "2:16: missing-param: Leaf needs the param \"script\"\n"
          "2:59: unknown-port: Leaf has no port \"skript\"; did you mean \"script\"?\n");
    CHECK(complaints(machine("<state id='a'><invoke type='leaf' src='GetInt'><param name='in' "
                             "expr=\"'x'\"/></invoke></state>")) ==
          "2:49: bad-value: \"x\" is not of the type of \"in\", int\n");
}

TEST_CASE("compile machine: a script's error is told at its line and column, entities counted") {
    CHECK(complaints(machine("<state id='a'><transition event='e' cond='1 &lt; &amp;&amp; 2' "
                             "target='a'/></state>"))
              .starts_with("2:50: script-syntax: "));
    CHECK(complaints(machine("<state id='a'><onentry><script>\n\n  a := := 2</script></onentry>"
                             "</state>"))
              .starts_with("4:8: script-syntax: "));
}

TEST_CASE("compile machine: names that nothing declares are warnings, as they fail at run time") {
    CHECK(complaints(machine("<datamodel><data id='speed' expr='1'/></datamodel><state id='a'>"
                             "<transition event='e' cond='sped &gt; 1' target='a'/></state>")) ==
          "2:93: unknown-name: no <data> declares \"sped\"; did you mean \"speed\"?\n");
    CHECK(complaints(machine("<state id='a'><transition event='e' cond=\"In('b')\" target='a'/>"
                             "</state>")) == "2:47: unknown-name: there is no state \"b\"\n");
}

TEST_CASE("compile machine: the domain of a transition decides what is left (3.13)") {
    const Program program = loaded(machine(
        "<state id='a'><transition event='1' target='a2'/><transition event='2' type='internal' "
        "target='a2'/><transition event='3' type='internal' target='a'/><transition event='4' "
        "target='b'/><transition event='5'><log/></transition><state id='a1'><transition event='6' "
        "target='a2'/></state><state id='a2'/></state><state id='b'/>"));
    std::string domains;
    for (const Transition& t : program.transitions) {
        if (t.event_count == 0) { continue; }
        domains += (t.domain ? program.names[t.domain.index] : "-") + (t.internal ? "i " : " ");
    }
    CHECK(domains == "machine ai machine machine - a ");
}

TEST_CASE("compile machine: tick is an event only where some transition names it") {
    const auto has_tick = [](const std::string& event) {
        return static_cast<bool>(
            loaded(machine("<state id='a'><transition event='" + event + "' target='a'/></state>"))
                .tick_event);
    };
    CHECK(has_tick("tick"));
    CHECK(has_tick("other tick"));
    CHECK_FALSE(has_tick("*"));
    CHECK_FALSE(has_tick("ticks"));
}

TEST_CASE("compile machine: equal documents are equal programs, different ones are not") {
    const std::string text = "<state id='a'><transition event='e' target='b'/></state>";
    CHECK(loaded(machine(text + "<state id='b'/>")) == loaded(machine(text + "\n<state id='b'/>")));
    CHECK_FALSE(loaded(machine(text + "<state id='b'/>")) ==
                loaded(machine(text + "<final id='b'/>")));
}

}  // namespace trellis::test
