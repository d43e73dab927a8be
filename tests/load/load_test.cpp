// The whole way from a text to a program: both spellings, what a host sets, limits, and that
// messages are sorted by place.
// SPDX-License-Identifier: MIT
#include "load/load.h"

#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis::test {
namespace {

std::string tree(const std::string& root) {
    return "<root BTCPP_format='4'><BehaviorTree ID='T'>" + root + "</BehaviorTree></root>";
}

std::string machine(const std::string& states) {
    return "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0'>" + states + "</scxml>";
}

}  // namespace

TEST_CASE("load: XML and JSON are told apart by their first character") {
    CHECK(loaded(" \n<root BTCPP_format='4'><BehaviorTree ID='T'><Leaf script='S'/></BehaviorTree>"
                 "</root>") ==
          loaded(" \n{\"BTCPP_format\": 4, \"trees\": [{\"ID\": \"T\", \"root\": {\"type\": "
                 "\"Leaf\", \"script\": \"S\"}}]}"));
}

TEST_CASE("load: the host gives variables of a tree their first values, by path in subtrees") {
    const Program program =
        loaded("<root BTCPP_format='4' main_tree_to_execute='M'><BehaviorTree ID='M'><Sequence>"
               "<Echo id='a' in='{v}'/><SubTree ID='S' name='sub'/></Sequence></BehaviorTree>"
               "<BehaviorTree ID='S'><Echo id='b' in='{w}'/></BehaviorTree></root>",
               {.given = {{"v", "7"}, {"sub/w", "text"}}});
    ScriptRun run(program);
    run.step();
    CHECK(run.take_events() == "a=7 b='text'");
}

TEST_CASE("load: a variable that the host sets must exist") {
    CHECK(complaints(tree("<Echo in='{speed}'/>"), {.given = {{"sped", "7"}}}) ==
          "0:0: unknown-variable: there is no variable \"sped\" to set; did you mean \"speed\"?\n");
}

TEST_CASE("load: the host gives data of a machine its value instead of the document's (5.3)") {
    const Program program = loaded(machine("<datamodel><data id='n' expr='1'/><data id='m' "
                                           "expr='n + 1'/></datamodel><state id='a'/>"),
                                   {.given = {{"n", "5"}, {"m", "9"}}});
    ScriptRun run(program);
    run.start();
    CHECK(run.state.slots[0].number() == 5.0);
    CHECK(run.state.slots[1].number() == 9.0);
}

TEST_CASE("load: all faults of a file are told, in the order of the text") {
    CHECK(complaints(tree("<Sequence><Leef/><Leaf script='S' x='1'/><Script code='1 +'/>"
                          "</Sequence>"))
              .find("\n1:") != std::string::npos);
}

TEST_CASE("load: a program has no more rows than allowed, however subtrees multiply") {
    std::string text = "<root BTCPP_format='4' main_tree_to_execute='T0'>";
    for (int i = 0; i < 30; ++i) {
        const std::string next = "<SubTree ID='T" + std::to_string(i + 1) + "'/>";
        text += "<BehaviorTree ID='T" + std::to_string(i) + "'><Sequence>" + next + next +
                "</Sequence></BehaviorTree>";
    }
    text += "<BehaviorTree ID='T30'><Leaf script='S'/></BehaviorTree></root>";
    const std::string told = complaints(text, {.rows = 10'000});
    CHECK(told.find("program-size: more than 10000 nodes once subtrees are expanded") !=
          std::string::npos);
}

TEST_CASE("load: nothing at all is an error") {
    CHECK_FALSE(complaints("").empty());
    CHECK_FALSE(complaints("  \n").empty());
    CHECK_FALSE(complaints("[]").empty());
}

}  // namespace trellis::test
