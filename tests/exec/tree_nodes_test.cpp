// The nodes of BehaviorTree.CPP that not every tree has, one behaviour per case (TREES §1): what
// the leaves reported, tick by tick, and what the root returned. The common ones are in
// tree_test.cpp.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/script_leaves.h"
#include "support/tree_table.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace trellis::test {
namespace {

/// Runs a tree for some ticks of 1 s, each "STATUS events", ticks separated by " / "; the tree is
/// halted after tick `halt_after`.
std::string ticks(const std::string& root, int count, int halt_after = 0) {
    const Program program = loaded("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + root +
                                   "</BehaviorTree></root>");
    ScriptRun run(program);
    std::string out;
    for (int i = 1; i <= count && !run.state.fault; ++i) {
        const Status status = run.step();
        out += (i > 1 ? " / " : "") + std::string(name_of(status));
        if (i == halt_after) { run.halt(); }
        const std::string events = run.take_events();
        if (!events.empty()) { out += ' ' + events; }
    }
    return run.state.fault ? out + " fault: " + run.state.fault.message : out;
}

}  // namespace

// Controls ----------------------------------------------------------------------------------------

TEST_CASE("AsyncSequence: yields after a child that succeeds in the tick it began") {
    CHECK(events("AsyncSequence(S, S, S)", 3) == "a:SUCCESS / b:SUCCESS / c:SUCCESS");
    CHECK(events("AsyncSequence(RS, S)", 2) == "a:RUNNING / a:SUCCESS b:SUCCESS");
    CHECK(events("AsyncFallback(F, F)", 2) == "a:FAILURE / b:FAILURE");
}

TEST_CASE("SequenceWithMemory: begins again at the child that failed or was halted") {
    CHECK(events("SequenceWithMemory(S, FS, S)", 4) ==
          "a:SUCCESS / b:FAILURE / b:SUCCESS / c:SUCCESS");
    CHECK(ticks("<SequenceWithMemory><Leaf id='a' script='S'/><Leaf id='b' script='R'/>"
                "</SequenceWithMemory>",
                3, 2) == "RUNNING a:SUCCESS / RUNNING b:RUNNING b:HALT / RUNNING b:RUNNING");
}

TEST_CASE("Parallel: thresholds are looked at after each child") {
    CHECK(events("Parallel[1:-1](S, S)", 1) == "a:SUCCESS");
    CHECK(table("Parallel[-1:1](RS, S)", 2) == "RS | R- R- S-");
    CHECK(table("Parallel[2:2](S, F, R)", 1) == "R | R S F R");
    CHECK(table("Parallel[-1:1](K, K)", 1) == "S | - - -");
    CHECK(table("Parallel[2:1](S, K)", 2) == "RR | RR SS --");
}

TEST_CASE("Parallel: a threshold that the children cannot reach is an error") {
    CHECK(ticks("<Sequence><Script code='n := 3'/><Parallel success_count='{n}'><AlwaysSuccess/>"
                "</Parallel></Sequence>",
                1) == "IDLE fault: asks for 3 of 1 children");
}

TEST_CASE("ParallelAll: ends when all have ended, and counts failures") {
    CHECK(table("ParallelAll[1](F, RS)", 2) == "RF | R- F- R-");
    CHECK(table("ParallelAll[2](F, S)", 1) == "S | - - -");
    CHECK(table("ParallelAll[1](K, K)", 1) == "K | R - -");
}

TEST_CASE("IfThenElse: remembers its choice, and asks a leaf again") {
    CHECK(events("IfThenElse(SF, RS, S)", 3) ==
          "a:SUCCESS b:RUNNING / b:SUCCESS / a:FAILURE c:SUCCESS");
    CHECK(events("IfThenElse(FS, S)", 2) == "a:FAILURE / a:SUCCESS b:SUCCESS");
}

TEST_CASE("IfThenElse: goes on counting skipped children of a condition that failed") {
    CHECK(table("IfThenElse(Sequence(=K, =FK), S)", 2) == "FS | -- F- -- -- --");
}

TEST_CASE("WhileDoElse: asks in every tick, and halts the child that is not chosen") {
    CHECK(events("WhileDoElse(SF, R, R)", 2) == "a:SUCCESS b:RUNNING / a:FAILURE b:HALT c:RUNNING");
    CHECK(ticks("<WhileDoElse><Cond script='K'/><AlwaysSuccess/></WhileDoElse>", 1) ==
          "IDLE :SKIPPED fault: its condition was skipped, so there is no answer");
}

TEST_CASE("Switch: compares as texts, integers, enumerators and numbers") {
    const auto chosen = [](const std::string& variable, const std::string& value) {
        return ticks("<Sequence><Script code=\"v := " + variable +
                         "\"/><Switch2 variable='{v}' case_1='" + value +
                         "' case_2='zz'><Leaf id='yes' script='S'/><Leaf id='zz' script='S'/><Leaf "
                         "id='no' script='S'/></Switch2></Sequence>",
                     1);
    };
    CHECK(chosen("1", "1.0") == "SUCCESS yes:SUCCESS");
    CHECK(chosen("2", "GREEN") == "SUCCESS yes:SUCCESS");
    CHECK(chosen("'RED'", "1") == "SUCCESS yes:SUCCESS");
    CHECK(chosen("1.5", "1.50") == "SUCCESS yes:SUCCESS");
    CHECK(chosen("'1x'", "1") == "SUCCESS no:SUCCESS");
}

TEST_CASE("TryCatch: a failure is caught, and the node fails") {
    CHECK(table("TryCatch(F, RS)", 2) == "RF | R- -- R-");
    CHECK(events("TryCatch(S, F)", 1) == "a:SUCCESS");
    CHECK(ticks("<TryCatch catch_on_halt='true'><Leaf id='a' script='R'/><Leaf id='b' script='R'/>"
                "</TryCatch>",
                1, 1) == "RUNNING a:RUNNING a:HALT b:RUNNING b:HALT");
}

// Decorators --------------------------------------------------------------------------------------

TEST_CASE("Delay and Timeout: count ticks of logical time") {
    CHECK(ticks("<Delay delay_msec='2000'><Leaf id='a' script='S'/></Delay>", 4) ==
          "RUNNING / RUNNING / SUCCESS a:SUCCESS / RUNNING");
    CHECK(ticks("<Timeout msec='1500'><Leaf id='a' script='R'/></Timeout>", 4) ==
          "RUNNING a:RUNNING / RUNNING a:RUNNING / FAILURE a:HALT / RUNNING a:RUNNING");
    CHECK(ticks("<Timeout msec='0'><Leaf id='a' script='RRS'/></Timeout>", 3) ==
          "RUNNING a:RUNNING / RUNNING a:RUNNING / SUCCESS a:SUCCESS");
    CHECK(ticks("<Delay delay_msec='2000'><Leaf id='a' script='S'/></Delay>", 4, 1) ==
          "RUNNING / RUNNING / RUNNING / SUCCESS a:SUCCESS");
    CHECK(ticks("<Sleep msec='1000'/>", 3) == "RUNNING / SUCCESS / RUNNING");
}

TEST_CASE("RunOnce: never runs again, not even after a halt") {
    CHECK(table("RunOnce(S)", 2) == "SK | -- --");
    CHECK(ticks("<RunOnce then_skip='false'><Leaf id='a' script='F'/></RunOnce>", 3, 1) ==
          "FAILURE a:FAILURE / FAILURE / FAILURE");
}

TEST_CASE("Precondition: is asked before the child begins, and again after a halt") {
    CHECK(events("Precondition[3](R)", 3, "101") == "a:RUNNING / a:RUNNING / a:RUNNING");
    CHECK(ticks("<Sequence><Script code='n := 0' _skipIf='false'/><Precondition if='n == 0' "
                "else='SKIPPED'><Leaf id='a' script='R' _onHalted='n = 1'/></Precondition>"
                "</Sequence>",
                1, 1) == "RUNNING a:RUNNING a:HALT");
}

TEST_CASE("queue loops: an element per tick, and one tick to find the queue empty") {
    CHECK(ticks("<LoopInt queue='1;2' value='{v}'><Echo id='e' in='{v}'/></LoopInt>", 4) ==
          "RUNNING e=1 / RUNNING e=2 / SUCCESS / RUNNING e=1");
    CHECK(ticks("<LoopBool queue='true;0' value='{v}' if_empty='FAILURE'><Echo id='e' in='{v}'/>"
                "</LoopBool>",
                3) == "RUNNING e=1 / RUNNING e=0 / FAILURE");
    CHECK(ticks("<Sequence><RunOnce><Script code=\"q := 'a;b'\"/></RunOnce><LoopString "
                "queue='{q}' value='{v}'><Echo id='e' in='{v}'/></LoopString></Sequence>",
                4) == "RUNNING e='a' / RUNNING e='b' / SUCCESS / RUNNING e='a'");
    CHECK(ticks("<Sequence><RunOnce><Script code='q := 1'/></RunOnce><LoopInt queue='{q}'>"
                "<AlwaysSuccess/></LoopInt></Sequence>",
                1) == "IDLE fault: the queue must be an array or a text, found 1");
}

TEST_CASE("watching nodes: a write counts, whatever was written") {
    CHECK(ticks("<Sequence><RunOnce><Script code='n := 0'/></RunOnce><SkipUnlessUpdated "
                "entry='{n}'><Leaf id='a' script='RS'/></SkipUnlessUpdated><Leaf id='b' "
                "script='S'/></Sequence>",
                3) == "RUNNING a:RUNNING / SUCCESS a:SUCCESS b:SUCCESS / SUCCESS b:SUCCESS");
    CHECK(ticks("<WaitValueUpdate entry='{n}'><AlwaysSuccess/></WaitValueUpdate>", 1) == "RUNNING");
    CHECK(ticks("<Fallback><WasEntryUpdated entry='n'/><Script code='n := 1'/></Fallback>", 1) ==
          "SUCCESS");
}

// Leaves ------------------------------------------------------------------------------------------

TEST_CASE("SetBlackboard: writes a text, or copies a value with its type") {
    CHECK(ticks("<Sequence><SetBlackboard value='42' output_key='k'/><Echo id='e' in='{k}'/>"
                "</Sequence>",
                2) == "SUCCESS e='42' / SUCCESS e='42'");
    CHECK(ticks("<Sequence><PutInt id='p' value='1' out='{k}'/><SetBlackboard value='42' "
                "output_key='k'/><Echo id='e' in='{k}'/></Sequence>",
                1) == "SUCCESS p>1 e=42");
    CHECK(ticks("<SetBlackboard value='{nothing}' output_key='k'/>", 1) == "FAILURE");
    CHECK(ticks("<Sequence><Script code=\"name := 'k'\"/><SetBlackboard value='v' "
                "output_key='{name}'/><Echo id='e' in='{k}'/></Sequence>",
                1) == "SUCCESS e='v'");
}

TEST_CASE("UnsetBlackboard: removes the entry and its type") {
    CHECK(ticks("<Sequence><PutInt id='p' value='1' out='{k}'/><UnsetBlackboard key='k'/><Echo "
                "id='e' in='{k}' _onFailure=\"k := 'text'\"/></Sequence>",
                1) == "FAILURE p>1 e=ERR");
}

}  // namespace trellis::test
