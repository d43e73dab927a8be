// Leaves as the interpreter calls them: fresh on entry, inputs before a tick, outputs after it, and
// what a leaf may not return.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

namespace trellis::test {
namespace {

struct Log {
    std::string text;
};

/// Counts its ticks since it was entered.
struct Counter {
    std::int32_t ticks = 0;
    std::int32_t until = 3;
    Status tick(Log& log, const Tick&) {
        log.text += std::to_string(++ticks) + ' ';
        return ticks < until ? Status::running : Status::success;
    }
};

/// Reads an in/out port and writes it only when it is 5 or more.
struct Adder {
    Out<std::int32_t> total;
    Status tick(Log& log, const Tick&) {
        log.text += std::to_string(total.value) + ' ';
        if (total.value >= 5) { total = total.value + 1; }
        return Status::success;
    }
};

struct Wrong {
    bool idle = false;
    Status tick(Log&, const Tick&) const { return idle ? Status::idle : Status::running; }
};

struct NoHost {
    Status tick(const Tick& t) const { return t.count < 2 ? Status::running : Status::success; }
};

const Registry& leaves() {
    static Registry registry;
    if (registry.leaves().empty()) {
        registry.add<Counter, Log>("Counter", "count")
            .state(&Counter::ticks)
            .input("until", &Counter::until);
        registry.add<Adder, Log>("Adder", "add").inout("total", &Adder::total);
        registry.add<Wrong, Log>("Wrong", "answer wrongly").input("idle", &Wrong::idle);
        registry.add<Wrong, Log>("WrongSync", "run although synchronous")
            .input("idle", &Wrong::idle)
            .synchronous();
        registry.add<NoHost, Log>("NoHost", "needs no host");
    }
    return registry;
}

std::string tree(const std::string& root) {
    return "<root BTCPP_format='4'><BehaviorTree ID='T'>" + root + "</BehaviorTree></root>";
}

}  // namespace

TEST_CASE("leaves: a leaf is fresh each time it is entered, and keeps its members while it runs") {
    const Program program = loaded(tree("<Counter/>"), {}, leaves());
    State state = fresh_state(program);
    Log log;
    for (int i = 0; i < 5; ++i) {
        step(program, state, log);
    }
    CHECK(log.text == "1 2 3 1 2 ");
}

TEST_CASE("leaves: literal inputs are converted when loading, variables before each tick") {
    const Program program =
        loaded(tree("<Sequence><Script code=\"u := '2'\"/><Counter until='{u}'/></Sequence>"), {},
               leaves());
    State state = fresh_state(program);
    Log log;
    CHECK(step(program, state, log) == Status::running);
    CHECK(step(program, state, log) == Status::success);
}

TEST_CASE("leaves: an input that does not convert is a fault that names the port") {
    const Program program =
        loaded(tree("<Sequence><Script code='u := 2.5'/><Counter until='{v}'/></Sequence>"),
               {.given = {{"v", "zwei"}}}, leaves());
    State state = fresh_state(program);
    Log log;
    CHECK(step(program, state, log) == Status::idle);
    CHECK(state.fault.message == "input \"until\": \"zwei\" is not of type int");
}

TEST_CASE("leaves: an in/out port is written only in a tick that assigns it") {
    const Program program = loaded(tree("<Sequence><Adder total='{n}'/></Sequence>"),
                                   {.given = {{"n", "4"}}}, leaves());
    State state = fresh_state(program);
    Log log;
    step(program, state, log);
    CHECK(print(state.slots[0]) == "4");
    state.slots[0] = Value::integer(5);
    step(program, state, log);
    step(program, state, log);
    CHECK(log.text == "4 5 6 ");
    CHECK(print(state.slots[0]) == "7");
}

TEST_CASE("leaves: returning IDLE, or RUNNING from a synchronous leaf, is a fault") {
    struct {
        const char* root;
        const char* message;
    } const cases[] = {
        {"<Wrong idle='true'/>", "Wrong returned IDLE"},
        {"<WrongSync/>", "WrongSync must answer at once but returned RUNNING"},
    };
    for (const auto& [root, message] : cases) {
        const Program program = loaded(tree(root), {}, leaves());
        State state = fresh_state(program);
        Log log;
        CHECK(step(program, state, log) == Status::idle);
        CHECK(state.fault.kind == Fault::Kind::leaf_status);
        CHECK(state.fault.message == message);
    }
}

TEST_CASE("leaves: a leaf that needs no host runs with any") {
    const Program program = loaded(tree("<NoHost/>"), {}, leaves());
    State state = fresh_state(program);
    CHECK(step(program, state, {}) == Status::running);
    CHECK(step(program, state, {}) == Status::running);
    CHECK(step(program, state, {}) == Status::success);
}

TEST_CASE(
    "leaves: a leaf that was not reset repeats what it answered, a synchronous one is asked") {
    // the Repeat yields while its sibling keeps what it stored
    const Program program = loaded(tree("<Sequence><Leaf id='a' script='SF'/><Repeat "
                                        "num_cycles='2'><SyncLeaf id='b' script='S'/></Repeat>"
                                        "</Sequence>"));
    ScriptRun run(program);
    run.step();
    run.step();
    CHECK(run.take_events() == "a:SUCCESS b:SUCCESS b:SUCCESS");
}

}  // namespace trellis::test
