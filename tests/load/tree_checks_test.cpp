// What is said about trees that run: nodes that are never ticked, loops that never end; and what is
// not said, because it can be meant. Exact messages.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis::test {
namespace {

/// A tree of that root; lines are counted from the line of the root.
std::string told(const std::string& root) {
    return complaints("<root BTCPP_format='4'><BehaviorTree ID='T'>" + root +
                      "</BehaviorTree></root>");
}

/// The same without lines and columns, for roots in one line.
std::string said(const std::string& root) {
    const std::string all = told(root);
    const std::size_t id = all.find(": ");
    return id == std::string::npos ? all : all.substr(id + 2);
}

}  // namespace

TEST_CASE("tree checks: after a child that never succeeds a Sequence does not go on") {
    CHECK(told("<Sequence>\n<AlwaysFailure/>\n<Leaf name='a' script='S'/>\n<Leaf script='S'/>\n"
               "</Sequence>") ==
          "3:2: never-ticked: \"a\" is never ticked: \"AlwaysFailure\" in line 2 never succeeds\n");
    for (const char* const sequence : {"ReactiveSequence", "AsyncSequence", "SequenceWithMemory"}) {
        const std::string name = sequence;
        CHECK(told('<' + name + ">\n<Inverter><AlwaysSuccess/></Inverter>\n<Leaf script='S'/></" +
                   name + '>') ==
              "3:2: never-ticked: \"Leaf\" is never ticked: \"Inverter\" in line 2 never "
              "succeeds\n");
    }
}

TEST_CASE("tree checks: after a child that never fails a Fallback does not go on") {
    for (const char* const fallback : {"Fallback", "ReactiveFallback", "AsyncFallback"}) {
        const std::string name = fallback;
        CHECK(told('<' + name + ">\n<Script code='a := 1'/>\n<Leaf script='S'/></" + name + '>') ==
              "3:2: never-ticked: \"Leaf\" is never ticked: \"Script\" in line 2 never fails\n");
    }
}

TEST_CASE("tree checks: what is always running keeps the others from their turn") {
    CHECK(told("<Sequence>\n<KeepRunningUntilFailure><Leaf script='S'/>"
               "</KeepRunningUntilFailure>\n<AlwaysSuccess/></Sequence>") ==
          "3:2: never-ticked: \"AlwaysSuccess\" is never ticked: \"KeepRunningUntilFailure\" in "
          "line 2 never succeeds\n");
    CHECK(told("<Fallback>\n<RetryUntilSuccessful num_attempts='-1'><Sequence><Sleep msec='10'/>"
               "<AlwaysFailure/></Sequence></RetryUntilSuccessful>\n<AlwaysSuccess/></Fallback>") ==
          "3:2: never-ticked: \"AlwaysSuccess\" is never ticked: \"RetryUntilSuccessful\" in line "
          "2 never fails\n");
}

TEST_CASE("tree checks: a leaf may return anything, also skipped") {
    CHECK(told("<Sequence><ForceFailure><Leaf script='S'/></ForceFailure><AlwaysSuccess/>"
               "</Sequence>") == "");
    CHECK(told("<Fallback><Repeat num_cycles='-1'><Cond script='S'/></Repeat><AlwaysSuccess/>"
               "</Fallback>") == "");
}

TEST_CASE("tree checks: the branches of a question that has one answer only") {
    for (const char* const branch : {"IfThenElse", "WhileDoElse"}) {
        const std::string name = branch;
        const std::string end =
            "\n<Leaf name='a' script='S'/>\n<Leaf name='b' script='S'/></" + name + '>';
        CHECK(told('<' + name + ">\n<ScriptCondition code='true'/>" + end) ==
              "4:2: never-ticked: \"b\" is never ticked: \"ScriptCondition\" in line 2 never "
              "fails\n");
        CHECK(told('<' + name + ">\n<AlwaysFailure/>" + end) ==
              "3:2: never-ticked: \"a\" is never ticked: \"AlwaysFailure\" in line 2 never "
              "succeeds\n");
        CHECK(told('<' + name + "><Cond script='S'/>" + end) == "");
        // a question that is not idle is not asked for its conditions
        CHECK(told('<' + name + "><Cond script='S' _failureIf='true'/>" + end) == "");
    }
}

TEST_CASE("tree checks: a node that a literal switches off is left alone, with all that is in it") {
    const std::string inside = "><AlwaysFailure/><AlwaysSuccess/></Sequence>";
    for (const char* const off :
         {"_skipIf='true'", "_failureIf='1'", "_successIf='true'", "_while='false'"}) {
        CHECK(told("<Sequence " + std::string(off) + inside) == "");
    }
    CHECK(told("<Precondition if='false'><Sequence" + inside + "</Precondition>") == "");
    for (const char* const on :
         {"_skipIf='false'", "_failureIf='0'", "_successIf='false'", "_while='true'"}) {
        CHECK(said("<Sequence " + std::string(on) + inside) ==
              "never-ticked: \"AlwaysSuccess\" is never ticked: \"AlwaysFailure\" in line 1 never "
              "succeeds\n");
    }
    CHECK(told("<Precondition if='true'><Leaf script='S'/></Precondition>") == "");
}

TEST_CASE("tree checks: what a condition decides counts for those after it") {
    CHECK(told("<Fallback>\n<Leaf script='S' _skipIf='@a'/>\n<AlwaysFailure _successIf='true'/>\n"
               "<AlwaysSuccess/><Script code='@a := 1'/></Fallback>")
              .find("4:2: never-ticked: \"AlwaysSuccess\" is never ticked: \"AlwaysFailure\" in "
                    "line 3 never fails") != std::string::npos);
    CHECK(told("<Sequence><AlwaysFailure _skipIf='@a'/><Script code='@a := 1'/></Sequence>") == "");
    CHECK(told("<Sequence>\n<Precondition if='false' else='RUNNING'><AlwaysSuccess/>"
               "</Precondition>\n<AlwaysSuccess/></Sequence>") ==
          "3:2: never-ticked: \"AlwaysSuccess\" is never ticked: \"Precondition\" in line 2 never "
          "succeeds\n");
    CHECK(told("<Sequence><Precondition if='false' else='SKIPPED'><AlwaysSuccess/>"
               "</Precondition><AlwaysSuccess/></Sequence>") == "");
}

TEST_CASE("tree checks: loops without a cycle") {
    CHECK(said("<Repeat num_cycles='0'><Leaf script='S'/></Repeat>") ==
          "never-ticked: \"Leaf\" is never ticked: num_cycles is 0\n");
    CHECK(
        said("<RetryUntilSuccessful num_attempts='0'><Leaf script='S'/></RetryUntilSuccessful>") ==
        "never-ticked: \"Leaf\" is never ticked: num_attempts is 0\n");
    CHECK(said("<LoopInt queue='' value='{v}'><Leaf script='S'/></LoopInt>") ==
          "never-ticked: \"Leaf\" is never ticked: the queue is empty\n");
    CHECK(told("<LoopInt queue='1;2' value='{v}'><Leaf script='S'/></LoopInt>") == "");
}

TEST_CASE("tree checks: two equal cases of a Switch") {
    CHECK(told("<Sequence><Script code=\"v := 'a'\"/>\n<Switch2 variable='{v}' case_1='a' "
               "case_2='a'>\n<Leaf name='1' script='S'/>\n<Leaf name='2' script='S'/>\n"
               "<Leaf script='S'/></Switch2></Sequence>") ==
          "4:2: never-ticked: \"2\" is never ticked: its case is that of \"1\" in line 3\n");
    CHECK(told("<Sequence><Script code=\"v := 'a'\"/><Switch2 variable='{v}' case_1='a' "
               "case_2='b'><Leaf script='S'/><Leaf script='S'/><Leaf script='S'/></Switch2>"
               "</Sequence>") == "");
}

TEST_CASE("tree checks: the last child of TryCatch where nothing fails or is halted") {
    CHECK(told("<TryCatch><AlwaysSuccess/>\n<Leaf name='c' script='S'/></TryCatch>") ==
          "2:2: never-ticked: \"c\" is never ticked: nothing before it can fail\n");
    CHECK(told("<TryCatch><Leaf script='S'/><Leaf script='S'/></TryCatch>") == "");
    CHECK(told("<TryCatch catch_on_halt='true'><Sleep msec='1'/><Leaf script='S'/></TryCatch>") ==
          "");
    CHECK(told("<TryCatch><AlwaysFailure/>\n<AlwaysSuccess/>\n<Leaf script='S'/></TryCatch>") ==
          "2:2: never-ticked: \"AlwaysSuccess\" is never ticked: \"AlwaysFailure\" in line 1 never "
          "succeeds\n");
}

TEST_CASE("tree checks: side by side, every child has its turn") {
    CHECK(told("<Parallel><AlwaysFailure/><Leaf script='S'/></Parallel>") == "");
    CHECK(told("<Sequence><Parallel success_count='0'><AlwaysFailure/></Parallel><AlwaysSuccess/>"
               "</Sequence>") == "");
    CHECK(told("<Sequence><ParallelAll max_failures='-1'><AlwaysFailure/><AlwaysSuccess/>"
               "</ParallelAll><AlwaysSuccess/></Sequence>") == "");
}

TEST_CASE("tree checks: loops without an end around what takes no time") {
    CHECK(told("<Repeat num_cycles='-1'>\n<Sequence><Script code='a := 1'/><AlwaysSuccess/>"
               "</Sequence></Repeat>") ==
          "1:46: endless-loop: \"Repeat\" never ends: \"Sequence\" in line 2 always succeeds at "
          "once\n");
    CHECK(said("<RetryUntilSuccessful num_attempts='-1'><AlwaysFailure/></RetryUntilSuccessful>") ==
          "endless-loop: \"RetryUntilSuccessful\" never ends: \"AlwaysFailure\" in line 1 always "
          "fails at once\n");
    CHECK(told("<Repeat num_cycles='-1'><Sequence><Sleep msec='1'/><AlwaysSuccess/></Sequence>"
               "</Repeat>") == "");
    CHECK(told("<RetryUntilSuccessful num_attempts='-1'><Cond script='F'/>"
               "</RetryUntilSuccessful>") == "");
    // running in every tick, and that is all it is for
    CHECK(told("<KeepRunningUntilFailure><AlwaysSuccess/></KeepRunningUntilFailure>") == "");
}

TEST_CASE("tree checks: a subtree is judged by what is in it, and told of once") {
    const std::string use = "<SubTree ID='S'/>";
    CHECK(complaints("<root BTCPP_format='4' main_tree_to_execute='M'><BehaviorTree ID='M'>"
                     "<Fallback>" +
                     use + use +
                     "</Fallback></BehaviorTree><BehaviorTree ID='S'>\n<Sequence>\n"
                     "<AlwaysFailure/>\n<Leaf script='S'/></Sequence></BehaviorTree></root>") ==
          "4:2: never-ticked: \"Leaf\" is never ticked: \"AlwaysFailure\" in line 3 never "
          "succeeds\n");
}

TEST_CASE("tree checks: inside what is never ticked nothing more is said") {
    CHECK(told("<Sequence><AlwaysFailure/>\n<Sequence><AlwaysFailure/>\n<AlwaysSuccess/>"
               "</Sequence></Sequence>") ==
          "2:2: never-ticked: \"Sequence\" is never ticked: \"AlwaysFailure\" in line 1 never "
          "succeeds\n");
}

TEST_CASE("tree checks: a Switch whose variable nothing sets always ticks its last child") {
    CHECK(told("<Switch2 variable='{v}' case_1='a' case_2='b'>\n<Leaf name='1' script='S'/>"
               "<Leaf name='2' script='S'/><Leaf script='S'/></Switch2>") ==
          "2:2: never-ticked: \"1\" is never ticked: nothing gives the variable of \"Switch2\" in "
          "line 1 a value\n");
    CHECK(complaints("<root BTCPP_format='4'><BehaviorTree ID='T'><Switch2 variable='{v}' "
                     "case_1='a' case_2='b'><Leaf script='S'/><Leaf script='S'/><Leaf script='S'/>"
                     "</Switch2></BehaviorTree></root>",
                     {.given = {{"v", "a"}}}) == "");
}

TEST_CASE("tree checks: what is never ticked may read what nothing sets, with a warning") {
    const std::string reads = "<ScriptCondition code='v == 1'/>";
    const std::string never = "nothing gives the variable \"v\" a value\n";
    CHECK(told("<Sequence><Cond script='S'/>" + reads + "</Sequence>") ==
          "1:96: never-set: " + never);
    const std::string idle = "<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence>"
                             "<AlwaysFailure/>" +
                             reads + "</Sequence></BehaviorTree></root>";
    CHECK(loaded(idle).rows.size() == 4);
    CHECK(complaints(idle) == "1:72: never-ticked: \"ScriptCondition\" is never ticked: "
                              "\"AlwaysFailure\" in line 1 never succeeds\n"
                              "1:94: never-set: " +
                                  never);
    // halting the whole tree runs this script of a node that was never ticked, too
    CHECK(told("<Sequence><AlwaysFailure/>\n<AlwaysSuccess _onHalted='w := v'/></Sequence>") ==
          "2:32: never-set: " + never);
}

}  // namespace trellis::test
