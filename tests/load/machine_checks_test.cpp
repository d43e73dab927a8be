// What is said about machines that run: states that are never entered, transitions that are never
// taken, events that meet nothing, eventless transitions without end; and what is not said. Exact
// messages.
// SPDX-License-Identifier: MIT
#include "support/loading.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis::test {
namespace {

/// A machine of these states; the first line is that of <scxml>.
std::string told(const std::string& states) {
    return complaints("<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0'>\n" + states +
                      "</scxml>");
}

}  // namespace

TEST_CASE("machine checks: a state that no transition leads to is never entered") {
    CHECK(told("<state id='a'><transition event='e' target='b'/></state>\n<state id='b'/>\n"
               "<state id='c'><state id='d'/><transition event='e' target='f'/></state>\n"
               "<state id='f'/>") ==
          "4:2: never-entered: the state \"c\" is never entered: no transition that can be taken "
          "leads there\n"
          "5:2: never-entered: the state \"f\" is never entered: no transition that can be taken "
          "leads there\n");
}

TEST_CASE("machine checks: initial states, regions and histories are entered") {
    CHECK(told("<parallel id='p'><state id='r' initial='r2'><state id='r1'/><state id='r2'>"
               "<transition event='e' target='r1'/></state></state><state id='s'><state id='s1'/>"
               "</state></parallel>") == "");
    CHECK(told("<state id='a'><transition event='e' target='h'/></state><state id='b' "
               "initial='b1'><history id='h'><transition target='b2'/></history><state id='b1'/>"
               "<state id='b2'><transition event='e' target='b1'/></state></state>") == "");
    // a region is entered by itself when another is gone to, and both when each of them is
    CHECK(told("<state id='a'><transition event='e' target='r2'/></state><parallel id='p'>"
               "<state id='r'>\n<state id='r1'/><state id='r2'/></state><state id='s'>"
               "<state id='s1'/></state></parallel>") ==
          "3:2: never-entered: the state \"r1\" is never entered: no transition that can be taken "
          "leads there\n");
    CHECK(told("<state id='a'><transition event='e' target='r2'/><transition event='f' "
               "target='s1'/></state><parallel id='p'><state id='r'><state id='r1'/>"
               "<state id='r2'/></state><state id='s'><state id='s1'/></state></parallel>") == "");
    CHECK(told("<state id='a'><transition event='e' target='r2 s2'/></state><parallel id='p'>"
               "<state id='r'><state id='r1'><transition event='x' target='r2'/></state>"
               "<state id='r2'/></state><state id='s'><state id='s1'/><state id='s2'/></state>"
               "</parallel>") == "");
}

TEST_CASE("machine checks: a transition behind one for the same events without condition") {
    CHECK(told("<state id='a'>\n<transition event='e' target='b'/>\n<transition event='e.f' "
               "target='a'/>\n<transition event='e' cond='In(\"a\")'/></state><state id='b'/>") ==
          "4:2: never-taken: this transition is never taken: the one in line 3 always comes first\n"
          "5:2: never-taken: this transition is never taken: the one in line 3 always comes "
          "first\n");
    CHECK(told("<state id='a'>\n<transition event='*' cond='true'/>\n<transition event='e f'/>"
               "</state>") ==
          "4:2: never-taken: this transition is never taken: the one in line 3 always comes "
          "first\n");
    CHECK(told("<state id='a'><transition event='e.f'/><transition event='e'/>"
               "<transition event='e.f g'/><transition event='h' cond='In(\"a\")'/>"
               "<transition event='h'/></state>") == "");
    CHECK(told("<state id='a'><state id='b'><transition event='e'/></state><state id='c'/>"
               "<transition event='e' target='c'/></state>")
              .find("never-taken") == std::string::npos);
}

TEST_CASE("machine checks: no event is looked at where a transition needs none") {
    CHECK(told("<state id='a'>\n<transition event='e' target='c'/>\n<transition target='b'/>"
               "</state>\n<state id='b'/>\n<state id='c'/>") ==
          "3:2: never-taken: this transition is never taken: the one in line 4 always comes first\n"
          "6:2: never-entered: the state \"c\" is never entered: no transition that can be taken "
          "leads there\n");
    CHECK(told("<state id='a'><transition cond='In(\"a\")' target='b'/><transition event='e' "
               "target='b'/></state><state id='b'/>") == "");
}

TEST_CASE("machine checks: a transition that a literal switches off is left alone") {
    CHECK(told("<state id='a'><transition event='e' cond='false' target='b'/><transition "
               "event='e' target='b'/></state><state id='b'/>") == "");
}

TEST_CASE("machine checks: done events of states and activities that do not exist") {
    CHECK(told("<state id='a'><state id='b'/><final id='c'/><transition event='done.state.a' "
               "target='c'/></state>")
              .find("never-raised") == std::string::npos);
    CHECK(told("<state id='work'>\n<state id='b'/><transition event='done.state.work'/></state>") ==
          "3:35: never-raised: nothing raises \"done.state.work\": the state \"work\" has no final "
          "state inside\n");
    CHECK(told("<state id='work' initial='c'><final id='c'/>\n<transition "
               "event='done.state.werk'/></state>") ==
          "3:20: never-raised: nothing raises \"done.state.werk\"; did you mean "
          "\"done.state.work\"?\n");
    CHECK(told("<state id='a'>\n<invoke type='leaf' src='Leaf' id='go'><param name='script' "
               "expr='\"S\"'/></invoke>\n<transition event='done.invoke.og.success'/>"
               "<transition event='done.invoke.go'/><transition event='done.invoke.go.failure'/>"
               "<transition event='done.invoke'/></state>")
              .find("4:20: never-raised: nothing raises \"done.invoke.og.success\"") == 0);
}

TEST_CASE("machine checks: slips in the names of the platform's events") {
    const auto slip = [](const std::string& event) {
        return told("<state id='a'>\n<transition event='" + event + "'/></state>");
    };
    CHECK(slip("error.excution") ==
          "3:20: never-raised: nothing raises \"error.excution\"; did you mean "
          "\"error.execution\"?\n");
    CHECK(slip("eror.communication.x") ==
          "3:20: never-raised: nothing raises \"eror.communication.x\"; did you mean "
          "\"error.communication.x\"?\n");
    CHECK(slip("done.stat.a") == "3:20: never-raised: nothing raises \"done.stat.a\"; did you mean "
                                 "\"done.state.a\"?\n");
    CHECK(slip("x dome.invoke.a") ==
          "3:20: never-raised: nothing raises \"dome.invoke.a\"; did you mean "
          "\"done.invoke.a\"?\n");
    for (const char* const good : {"error", "error.*", "error.execution", "error.platform.livelock",
                                   "error.mine", "done.start", "done", "down.state", "e.x"}) {
        CHECK(slip(good) == "");
    }
    CHECK(told("<state id='a'><onentry><raise event='error.excution'/></onentry><transition "
               "event='error.excution'/></state>") == "");
}

TEST_CASE("machine checks: a state that cannot be left, in a machine that has an end") {
    const std::string begin = "<state id='a'><transition event='e' target='b'/><transition "
                              "event='f' target='end'/></state>\n";
    const std::string end = "<final id='end'/>";
    CHECK(told(begin + "<state id='b'/>" + end) ==
          "3:2: no-way-out: the state \"b\" is not final, but no transition leads out of it\n");
    CHECK(told(begin +
               "<state id='b'><transition event='e'/><transition event='g' cond='false' "
               "target='a'/></state>" +
               end) ==
          "3:2: no-way-out: the state \"b\" is not final, but no transition leads out of it\n");
    // around it, or to itself: it goes on
    CHECK(told(begin + "<state id='b'><state id='c'/><transition event='e' target='end'/></state>" +
               end) == "");
    CHECK(told(begin + "<state id='b'><transition event='e' target='b'/></state>" + end) == "");
    // no end is meant, or another region may lead to it
    CHECK(told("<state id='a'><transition event='e' target='b'/></state><state id='b'/>") == "");
    CHECK(told(begin +
               "<parallel id='b'><state id='r'/><state id='s'><transition event='e' "
               "target='end'/></state></parallel>" +
               end) == "");
}

TEST_CASE("machine checks: an event that is raised and that no transition is for") {
    CHECK(told("<state id='a'><onentry>\n<raise event='redy'/><raise event='ready.now'/></onentry>"
               "<transition event='ready'/></state>") ==
          "3:15: unmatched-event: no transition is for the event \"redy\"; did you mean "
          "\"ready\"?\n");
    CHECK(told("<state id='a'><onentry>\n<send event='x'/><send event='y' target='#_parent'/>"
               "</onentry></state>") ==
          "3:14: unmatched-event: no transition is for the event \"x\"\n");
    CHECK(told("<state id='a'><onentry><raise event='x'/></onentry><transition event='*'/>"
               "</state>") == "");
}

TEST_CASE("machine checks: eventless transitions that lead back to where they began") {
    CHECK(told("<state id='a'>\n<transition target='b'/></state><state id='b' initial='c'>"
               "<state id='c'/>\n<transition target='a'/></state>") ==
          "4:2: never-rests: transitions without event and condition lead from \"a\" back to it, "
          "without end\n");
    CHECK(
        told("<state id='a'><onentry><log expr='1'/></onentry>\n<transition cond='true'/></state>")
            .find("3:2: never-rests: transitions without event and condition lead from \"a\"") !=
        std::string::npos);
    CHECK(told("<state id='a'><transition target='b'/></state><state id='b'><transition "
               "cond='In(\"a\")' target='c'/><transition target='a'/></state><state id='c'/>") ==
          "");
    CHECK(told("<state id='a'><transition target='b'/></state><state id='b'><transition "
               "event='e' target='a'/></state>") == "");
}

}  // namespace trellis::test
