// Steps that only change states give what whole steps give. A traced step is never such a step, so
// two runs of the same machine, one of them traced, are compared cycle by cycle: random statecharts
// without content, and those of all kinds.
// SPDX-License-Identifier: MIT
#include "exec/step.h"
#include "support/loading.h"
#include "support/machine_story.h"
#include "support/random_machine.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

namespace trellis::test {
namespace {

/// Counts the transitions of the traced run.
class Transitions final : public TraceSink {
public:
    void on(const TraceEvent& what) override {
        count += what.kind == TraceEvent::Kind::transition ? 1U : 0U;
    }
    std::size_t count = 0;
};

/// A statechart of states, compound or parallel, that only lead to each other.
class Chart {
public:
    explicit Chart(Random& random) : random_(random) {}

    std::string text(int states) {
        last_ = states;
        std::string out;
        while (made_ < last_) {
            out += state(4);
        }
        return machine_file(out);
    }

private:
    bool one_in(int n) { return random_.whole(1, n) == 1; }
    std::string name(std::int64_t number) { return 's' + std::to_string(number); }

    std::string state(int depth) {
        const std::string id = name(made_++);
        const bool parallel = depth > 0 && one_in(6);
        std::string out = (parallel ? "<parallel id='" : "<state id='") + id + "'>";
        for (std::int64_t n = random_.whole(0, 3); n > 0; --n) {
            out += transition();
        }
        if (parallel || (depth > 0 && one_in(3))) {
            for (std::int64_t n = random_.whole(1, 3); n > 0 && (parallel || made_ < last_); --n) {
                out += state(depth - 1);
            }
        }
        return out + (parallel ? "</parallel>" : "</state>");
    }
    std::string transition() {
        static constexpr const char* events[] = {"a", "b", "c", "a.b", "*", "a c"};
        std::string out = "<transition event='" + std::string(events[random_.whole(0, 5)]) + '\'';
        if (one_in(4)) { out += " cond='_x.bumper'"; }
        if (one_in(8)) { out += " type='internal'"; }
        // states that come later may not be made: the last number is made in any case
        if (!one_in(8)) { out += " target='" + name(random_.whole(0, last_ - 1)) + '\''; }
        return out + "/>";
    }

    Random& random_;
    std::int64_t made_ = 0, last_ = 0;
};

struct Count {
    std::size_t machines = 0, plain = 0, transitions = 0;
};

void compare(const std::string& text, Random& random, Count& count) {
    CAPTURE(text);
    const Program program = loaded(text);
    ++count.machines;
    count.plain += program.takes_plain_events ? 1U : 0U;
    ScriptRun quick(program);
    ScriptRun slow(program);
    Transitions transitions;
    for (int i = 0; i < 30; ++i) {
        quick.host.bumper = slow.host.bumper = random.whole(0, 1) == 1;
        for (std::int64_t n = random.whole(0, 2); n > 0; --n) {
            const std::string event = random_event(random);
            send(program, quick.state, event);
            send(program, slow.state, event);
        }
        const Status status = quick.step();
        REQUIRE(slow.step({.dt = 1.0, .trace = &transitions}) == status);
        REQUIRE(same(program, quick.state, slow.state));
        if (status != Status::running) { break; }
    }
    count.transitions += transitions.count;
}

}  // namespace

TEST_CASE("plain events: random charts that only change states do so in the same way") {
    Random random(std::int64_t{60});
    Count count;
    for (int i = 0; i < 1000; ++i) {
        const std::string text = Chart(random).text(static_cast<int>(random.whole(1, 25)));
        Diagnostics diagnostics;
        // a transition may have targets that its parallel state does not allow
        if (!load({"chart", text}, script_registry(), diagnostics)) { continue; }
        compare(text, random, count);
    }
    CHECK(count.machines > 900);
    CHECK(count.plain == count.machines);
    CHECK(count.transitions > 10'000);
}

TEST_CASE("plain events: random machines of all kinds do the same with and without") {
    Random random(std::int64_t{61});
    Count count;
    for (int i = 0; i < 300; ++i) {
        compare(random_machine(random, static_cast<int>(random.whole(1, 12))), random, count);
    }
    CHECK(count.plain < count.machines);
}

TEST_CASE("plain events: an event is sent by its number as by its name") {
    const Program program = loaded(machine_file("<state id='a'><transition event='go.on' "
                                                "target='b'/></state><state id='b'/>"));
    CHECK_FALSE(find_event(program, "gone"));
    CHECK_FALSE(find_event(program, "go.on.now"));
    ScriptRun by_name(program);
    ScriptRun by_number(program);
    send(program, by_name.state, "go.on");
    send(program, by_number.state, find_event(program, "go.on"));
    by_name.step();
    by_number.step();
    CHECK(same(program, by_name.state, by_number.state));
    CHECK(by_name.statuses() == "R-R");
}

TEST_CASE("plain events: content, guards that need code and final states are left to the rest") {
    const Program program = loaded(machine_file(
        "<datamodel><data id='n' expr='0'/></datamodel>"
        "<state id='a'><transition event='go' cond='n &gt; 1' target='end'/>"
        "<transition event='go' target='a'><assign location='n' expr='n + 1'/></transition>"
        "<transition event='move' target='b'/></state>"
        "<state id='b'><onexit><assign location='n' expr='n + 1'/></onexit>"
        "<transition event='move' target='a'/></state><final id='end'/>"));
    CHECK(program.takes_plain_events);
    ScriptRun run(program);
    for (const char* event : {"move", "go", "move", "move", "move", "go"}) {
        send(program, run.state, event);
    }
    // b ignores the first go, and is left twice
    CHECK(run.step() == Status::success);
    CHECK(run.state.slots[0].number() == 2.0);
}

}  // namespace trellis::test
