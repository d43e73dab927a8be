// How each node of a tree is ticked and halted, one behaviour per case (TREES §1). A table is what
// the root returned, then the stored statuses of every node, a letter per tick.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/script_leaves.h"
#include "support/tree_table.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace trellis::test {
namespace {

std::string tree_file(std::string_view root, std::string_view more = {}) {
    return "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\"><BehaviorTree ID=\"Main\">" +
           std::string(root) + "</BehaviorTree>" + std::string(more) + "</root>";
}

/// The variable of that name; undefined if there is none.
Value variable(const ScriptRun& run, std::string_view name) {
    for (std::size_t i = 0; i < run.program().slots.size(); ++i) {
        if (run.program().slots[i].name == name) { return run.state.slots[i]; }
    }
    return {};
}

/// Runs a tree for some ticks, each "STATUS events", ticks separated by " / ".
std::string ticks(std::string_view root, int count, const StepOptions& options = {.dt = 1.0}) {
    const Program program = loaded(tree_file(root));
    ScriptRun run(program);
    std::string out;
    for (int i = 0; i < count && !run.state.fault; ++i) {
        const Status status = run.step(options);
        if (i > 0) { out += " / "; }
        out += name_of(status);
        const std::string events = run.take_events();
        if (!events.empty()) { out += ' ' + events; }
    }
    return run.state.fault ? out + " fault: " + run.state.fault.message : out;
}

}  // namespace

// Controls ----------------------------------------------------------------------------------------

TEST_CASE("Sequence: goes on at the running child and does not tick earlier ones again") {
    CHECK(table("Sequence(SS, RS)", 2) == "RS | R- S- R-");
    CHECK(table("Sequence(SF, RR)", 2) == "RR | RR SS RR");
    CHECK(events("Sequence(SF, RR)", 2) == "a:SUCCESS b:RUNNING / b:RUNNING");
}

TEST_CASE("Sequence: a failure resets all children and the next tick begins at the first") {
    CHECK(table("Sequence(SS, FS)", 2) == "FS | -- -- --");
    CHECK(events("Sequence(SS, FS)", 2) == "a:SUCCESS b:FAILURE / a:SUCCESS b:SUCCESS");
}

TEST_CASE("Sequence: is skipped if all children are, and keeps its stored status then") {
    CHECK(table("Sequence(K, K)", 2) == "KK | RR -- --");
    CHECK(table("Sequence(K, S)", 1) == "S | - - -");
    CHECK(table("Sequence(K, F)", 1) == "F | - - -");
}

TEST_CASE("Sequence: counts skipped children across running ticks") {
    CHECK(table("Sequence(K, RK)", 2) == "RK | RR -- R-");
    CHECK(events("Sequence(K, RK)", 2) == "a:SKIPPED b:RUNNING / b:SKIPPED b:HALT");
}

TEST_CASE("Sequence: a child that skipped counts as running when it is halted") {
    // the inner sequence stays stored RUNNING although it was skipped
    CHECK(table("Sequence(Sequence(K), R)", 1) == "R | R R - R");
    CHECK(table("ReactiveSequence(SF, Sequence(K), R)", 2) == "RF | R- -- -- -- R-");
}

TEST_CASE("Fallback: mirrors Sequence") {
    CHECK(table("Fallback(FF, RS)", 2) == "RS | R- F- R-");
    CHECK(table("Fallback(FF, FF)", 2) == "FF | -- -- --");
    CHECK(events("Fallback(FF, SS)", 2) == "a:FAILURE b:SUCCESS / a:FAILURE b:SUCCESS");
    CHECK(table("Fallback(K, K)", 1) == "K | R - -");
    CHECK(table("Fallback(K, F)", 1) == "F | - - -");
}

TEST_CASE("ReactiveSequence: an earlier failure halts the running child") {
    CHECK(table("ReactiveSequence(SF, RR)", 2) == "RF | R- -- R-");
    CHECK(events("ReactiveSequence(SF, RR)", 2) == "a:SUCCESS b:RUNNING / a:FAILURE b:HALT");
}

TEST_CASE("ReactiveSequence: a running child resets all others, before and after it") {
    CHECK(table("ReactiveSequence(SR, RR)", 2) == "RR | RR -R R-");
    CHECK(events("ReactiveSequence(SR, RR)", 2) == "a:SUCCESS b:RUNNING / a:RUNNING b:HALT");
}

TEST_CASE("ReactiveSequence: a skipped child is reset at once") {
    CHECK(events("ReactiveSequence(RK, SS)", 2) == "a:RUNNING / a:SKIPPED a:HALT b:SUCCESS");
    CHECK(table("ReactiveSequence(K, K)", 1) == "K | R - -");
    CHECK(table("ReactiveSequence(K, S)", 1) == "S | - - -");
}

TEST_CASE("ReactiveFallback: mirrors ReactiveSequence") {
    CHECK(table("ReactiveFallback(FS, RR)", 2) == "RS | R- -- R-");
    CHECK(events("ReactiveFallback(FS, RR)", 2) == "a:FAILURE b:RUNNING / a:SUCCESS b:HALT");
    CHECK(table("ReactiveFallback(K, K)", 1) == "K | R - -");
    CHECK(table("ReactiveFallback(F, F)", 1) == "F | - - -");
}

// Decorators --------------------------------------------------------------------------------------

TEST_CASE("decorators: map success and failure, pass running and skipped") {
    CHECK(table("Inverter(SFRK)", 4) == "FSRK | --RR --RR");
    CHECK(table("ForceSuccess(SFRK)", 4) == "SSRK | --RR --RR");
    CHECK(table("ForceFailure(SFRK)", 4) == "FFRK | --RR --RR");
}

TEST_CASE("Repeat: one cycle of a synchronous child per tick") {
    CHECK(table("Repeat[3](=S)", 3) == "RRS | RR- ---");
    CHECK(table("Repeat[3](S)", 3) == "RRS | RR- ---");
}

TEST_CASE("Repeat: a child that was running is started again in the same tick") {
    CHECK(table("Repeat[2](RS)", 3) == "RRS | RR- RR-");
    CHECK(events("Repeat[2](RS)", 3) == "a:RUNNING / a:SUCCESS a:RUNNING / a:SUCCESS");
}

TEST_CASE("Repeat: failure forgets the count, skipped keeps it") {
    CHECK(table("Repeat[2](SFSS)", 4) == "RFRS | R-R- ----");
    CHECK(table("Repeat[2](SKS)", 3) == "RKS | RR- ---");
}

TEST_CASE("Repeat: 0 and negative numbers succeed without a tick, -1 never ends") {
    CHECK(table("Repeat[0](S)", 1) == "S | - -");
    CHECK(events("Repeat[0](S)", 1).empty());
    CHECK(table("Repeat[-2](S)", 1) == "S | - -");
    CHECK(table("Repeat[-1](=S)", 4) == "RRRR | RRRR ----");
}

TEST_CASE("Repeat: halting forgets the count") {
    CHECK(events("ReactiveFallback(FSFF, Repeat[2](=S))", 4) ==
          "a:FAILURE b:SUCCESS / a:SUCCESS / a:FAILURE b:SUCCESS / a:FAILURE b:SUCCESS");
    CHECK(table("ReactiveFallback(FSFF, Repeat[2](=S))", 4) == "RSRS | R-R- ---- R-R- ----");
}

TEST_CASE("RetryUntilSuccessful: mirrors Repeat") {
    CHECK(table("RetryUntilSuccessful[2](=F)", 2) == "RF | R- --");
    CHECK(table("RetryUntilSuccessful[2](FS)", 2) == "RS | R- --");
    CHECK(table("RetryUntilSuccessful[2](RF)", 3) == "RRF | RR- RR-");
    CHECK(table("RetryUntilSuccessful[0](S)", 1) == "F | - -");
    CHECK(table("RetryUntilSuccessful[2](FKF)", 3) == "RKF | RR- ---");
}

TEST_CASE("Repeat and Retry: a number from a variable is read again where BehaviorTree.CPP does") {
    // Repeat looks when it is ticked
    CHECK(ticks("<Sequence><Script code='n := 1'/><Repeat num_cycles='{n}'>"
                "<SyncLeaf id='a' script='S' _onSuccess='n = 3'/></Repeat></Sequence>",
                1) == "SUCCESS a:SUCCESS");
    // Retry also after each failure
    CHECK(
        ticks("<Sequence><Script code='n := 1'/><RetryUntilSuccessful num_attempts='{n}'>"
              "<SyncLeaf id='a' script='F' _onFailure='n = 3'/></RetryUntilSuccessful></Sequence>",
              3) == "RUNNING a:FAILURE / RUNNING a:FAILURE / FAILURE a:FAILURE");
}

// Wake-ups ----------------------------------------------------------------------------------------

TEST_CASE("step: while_woken goes on as long as a node asks for it") {
    const StepOptions once{.dt = 1.0, .while_woken = true};
    CHECK(ticks("<Repeat num_cycles='3'><SyncLeaf id='a' script='S'/></Repeat>", 1, once) ==
          "SUCCESS a:SUCCESS a:SUCCESS a:SUCCESS");
}

TEST_CASE("step: a node that was woken and ended is not where the next tick begins") {
    const StepOptions once{.dt = 1.0, .while_woken = true};
    CHECK(ticks("<Sequence><ReactiveSequence><Leaf id='a' script='RS'/><Repeat num_cycles='2'>"
                "<SyncLeaf id='b' script='S'/></Repeat></ReactiveSequence>"
                "<Leaf id='c' script='R'/></Sequence>",
                4, once) == "RUNNING a:RUNNING / RUNNING a:SUCCESS b:SUCCESS a:RUNNING / "
                            "RUNNING a:SUCCESS b:SUCCESS a:RUNNING / "
                            "RUNNING a:SUCCESS b:SUCCESS a:RUNNING");
    CHECK(ticks("<Sequence><ReactiveSequence><Leaf id='a' script='RSS'/><Repeat num_cycles='2'>"
                "<SyncLeaf id='b' script='S'/></Repeat></ReactiveSequence>"
                "<Leaf id='c' script='R'/></Sequence>",
                3, once) ==
          "RUNNING a:RUNNING / RUNNING a:SUCCESS b:SUCCESS a:SUCCESS b:SUCCESS c:RUNNING / "
          "RUNNING c:RUNNING");
}

TEST_CASE("step: a loop that never yields ends with a fault that names it") {
    const Program program = loaded(
        tree_file("<Repeat name='for ever' num_cycles='-1'><SyncLeaf script='S'/></Repeat>"));
    ScriptRun run(program);
    run.host.records = false;
    CHECK(run.step({.dt = 1.0, .while_woken = true}) == Status::idle);
    CHECK(run.state.fault.kind == Fault::Kind::budget);
    CHECK(run.state.fault.message == "this tick does not end: too many nodes were ticked");
}

// Conditions --------------------------------------------------------------------------------------

TEST_CASE("pre-conditions: force a status, in the order failure, success, skip") {
    CHECK(table("f?S", 2, "10") == "FS | --");
    CHECK(table("s?F", 2, "10") == "SF | --");
    CHECK(table("k?S", 2, "10") == "KS | --");
    CHECK(table("k?s?f?R", 1, "1") == "F | -");
    CHECK(table("k?s?R", 1, "1") == "S | -");
}

TEST_CASE("pre-conditions: are tested only when the node is idle, _while also when it runs") {
    CHECK(table("k?RR", 2, "01") == "RR | RR");
    CHECK(table("f?RR", 2, "01") == "RR | RR");
    CHECK(table("w?RRR", 3, "101") == "RKR | R-R");
    CHECK(events("w?RRR", 3, "101") == "a:RUNNING / a:HALT / a:RUNNING");
    CHECK(table("w?S", 1, "0") == "K | -");
}

TEST_CASE("pre-conditions: a node left running by skipping does not test _skipIf again") {
    CHECK(events("k?Sequence(K)", 3, "011") == "a:SKIPPED / a:SKIPPED / a:SKIPPED");
}

TEST_CASE("pre-conditions: an integer must be 0 or 1, a text is no condition") {
    CHECK(ticks("<Leaf id='a' script='R' _skipIf='1.5'/>", 1) == "SKIPPED");
    CHECK(ticks("<Leaf id='a' script='R' _skipIf='0'/>", 1) == "RUNNING a:RUNNING");
    CHECK(ticks("<Leaf id='a' script='R' _skipIf='2'/>", 1).starts_with("IDLE fault: "));
    CHECK(ticks("<Leaf id='a' script='R' _skipIf=\"'yes'\"/>", 1).starts_with("IDLE fault: "));
}

TEST_CASE("post-conditions: _onSuccess or _onFailure, then _post, none when running or skipped") {
    const Program program = loaded(
        tree_file("<Leaf script='SFRK' _successIf=\"t := 't'; false\" _onSuccess=\"t := t .. 's'\" "
                  "_onFailure=\"t := t .. 'f'\" _post=\"t := t .. 'p'\"/>"));
    ScriptRun run(program);
    std::string trails;
    for (int i = 0; i < 4; ++i) {
        run.step();
        trails += variable(run, "t").as_text() + ' ';
    }
    CHECK(trails == "tsp tfp t t ");
}

TEST_CASE("post-conditions: run after a status that a pre-condition forced") {
    const Program program = loaded(
        tree_file("<Leaf script='R' _failureIf=\"t := 't'; true\" _onFailure=\"t := t .. 'f'\"/>"));
    ScriptRun run(program);
    CHECK(run.step() == Status::failure);
    CHECK(variable(run, "t").as_text() == "tf");
}

TEST_CASE("post-conditions: _onHalted runs after the children were halted") {
    const Program program = loaded(tree_file(
        "<ReactiveFallback><Cond script='FS' _successIf=\"_x.bumper\"/>"
        "<Sequence _onHalted=\"t := t .. 'o'\"><Script code=\"t := 't'\"/>"
        "<Leaf id='b' script='R' _onHalted=\"t := t .. 'i'\"/></Sequence></ReactiveFallback>"));
    ScriptRun run(program);
    run.step();
    run.host.bumper = true;
    CHECK(run.step() == Status::success);
    CHECK(variable(run, "t").as_text() == "tio");
}

TEST_CASE("halt: _onHalted runs for every node, and twice for those that ran") {
    const Program program =
        loaded(tree_file("<Sequence><Script code='h := 0'/><Leaf script='R' _onHalted='h += 100'/>"
                         "<Leaf script='R' _onHalted='h += 1'/></Sequence>"));
    ScriptRun run(program);
    run.step();
    run.halt();
    CHECK(print(variable(run, "h")) == "201");
    CHECK(run.statuses() == "-----");
    CHECK(run.step() == Status::running);
}

// Scripts -----------------------------------------------------------------------------------------

TEST_CASE("Script: succeeds, also when it is empty, ScriptCondition answers with its value") {
    CHECK(ticks("<Script code=''/>", 1) == "SUCCESS");
    CHECK(ticks("<ScriptCondition code='1 &lt; 2'/>", 1) == "SUCCESS");
    CHECK(ticks("<ScriptCondition code='1 &gt; 2'/>", 1) == "FAILURE");
    CHECK(ticks("<ScriptCondition code=\"'RED' == 1\"/>", 1) == "SUCCESS");
    CHECK(ticks("<ScriptCondition code='GREEN == 2'/>", 1) == "SUCCESS");
}

TEST_CASE("Script: an error ends the run with a fault at the node, in the tick it happened") {
    const Program program = loaded(tree_file("\n  <Script name='set' code=\"a := 'x' - 1\"/>\n"));
    ScriptRun run(program);
    CHECK(run.step() == Status::idle);
    CHECK(run.state.fault.kind == Fault::Kind::expression);
    CHECK(describe_fault(program, run.state) ==
          "test:2:4: error: set: operator - does not take text and real (tick 1)");
}

// Subtrees ----------------------------------------------------------------------------------------

TEST_CASE("SubTree: passes the status of its tree, which has variables of its own") {
    const Program program = loaded(tree_file(
        "<Sequence><Script code='v := 1'/><SubTree ID='Sub' p='{v}' q='7'/><Echo id='m' in='{q}'/>"
        "</Sequence>",
        "<BehaviorTree ID='Sub'><Sequence><Echo id='p' in='{p}'/><Echo id='q' in='{q}'/>"
        "<Echo id='v' in='{v}'/></Sequence></BehaviorTree>"));
    ScriptRun run(program);
    CHECK(run.step() == Status::failure);
    CHECK(run.take_events() == "p=1 q=7 v=ERR");
}

TEST_CASE("SubTree: conditions see the names of the tree around it") {
    const Program program = loaded(tree_file(
        "<Sequence><Script code='v := 1'/><SubTree ID='Sub' v='0' _skipIf='v == 1'/></Sequence>",
        "<BehaviorTree ID='Sub'><Leaf id='a' script='S'/></BehaviorTree>"));
    ScriptRun run(program);
    CHECK(run.step() == Status::success);
    CHECK(run.take_events().empty());
}

TEST_CASE("SubTree: is halted through, and starts again at its first node") {
    const Program program =
        loaded(tree_file("<ReactiveFallback><Cond id='c' script='FFSF'/><SubTree ID='Sub'/>"
                         "</ReactiveFallback>",
                         "<BehaviorTree ID='Sub'><Sequence><Leaf id='a' script='S'/><Leaf id='b' "
                         "script='R'/></Sequence></BehaviorTree>"));
    ScriptRun run(program);
    std::string all;
    for (int i = 0; i < 4; ++i) {
        run.step();
        all += run.take_events() + " / ";
    }
    CHECK(all == "c:FAILURE a:SUCCESS b:RUNNING / c:FAILURE b:RUNNING / c:SUCCESS b:HALT / "
                 "c:FAILURE a:SUCCESS b:RUNNING / ");
}

TEST_CASE("tree: elapsed() counts the ticks since the tree or subtree around it was entered") {
    const Program program =
        loaded(tree_file("<Sequence><Leaf script='RRS'/><SubTree ID='Sub'/></Sequence>",
                         "<BehaviorTree ID='Sub'><Sequence><Leaf script='RS'/><Script code='@t := "
                         "elapsed()'/></Sequence></BehaviorTree>"));
    ScriptRun run(program);
    const StepOptions half{.dt = 0.5};
    for (int i = 0; i < 3; ++i) {
        CHECK(run.step(half) == Status::running);
    }
    CHECK(run.step(half) == Status::success);
    CHECK(print(variable(run, "t")) == "1.0");
}

}  // namespace trellis::test
