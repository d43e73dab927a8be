// What a trace sink is told, in order: statuses, leaves, states, transitions, events, logs, errors.
// SPDX-License-Identifier: MIT
#include "core/trace.h"

#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis::test {
namespace {

class Lines final : public TraceSink {
public:
    explicit Lines(const Program& program) : program_(program) {}

    void on(const TraceEvent& event) override {
        using Kind = TraceEvent::Kind;
        text += std::to_string(event.tick) + ' ' + std::string(name_of(event.kind));
        if (event.row) { text += ' ' + program_.names[event.row.index]; }
        if (event.kind == Kind::status) {
            text += ' ' + std::string(name_of(event.from)) + ' ' + std::string(name_of(event.to));
        }
        if (event.kind == Kind::tick) { text += ' ' + std::string(name_of(event.to)); }
        if (event.kind == Kind::event) { text += ' ' + program_.events[event.event.index].text; }
        if (event.kind == Kind::transition) {
            text += ' ' + std::to_string(event.transition.index);
        }
        if (!event.text.empty()) { text += " \"" + std::string(event.text) + '"'; }
        text += '\n';
    }

    std::string text;

private:
    const Program& program_;
};

}  // namespace

TEST_CASE("trace: a tree tells every change of a stored status and every leaf") {
    const Program program = loaded("<root BTCPP_format='4'><BehaviorTree ID='T'><ReactiveFallback>"
                                   "<Cond name='c' script='FS'/><Leaf name='l' script='R'/>"
                                   "</ReactiveFallback></BehaviorTree></root>");
    Lines lines(program);
    ScriptRun run(program);
    run.step({.dt = 1.0, .trace = &lines});
    CHECK(lines.text == "1 status T IDLE RUNNING\n"
                        "1 status ReactiveFallback IDLE RUNNING\n"
                        "1 tick c FAILURE\n"
                        "1 status c IDLE FAILURE\n"
                        "1 tick l RUNNING\n"
                        "1 status l IDLE RUNNING\n"
                        "1 status c FAILURE IDLE\n");
    lines.text.clear();
    run.step({.dt = 1.0, .trace = &lines});
    CHECK(lines.text == "2 tick c SUCCESS\n"
                        "2 status c IDLE SUCCESS\n"
                        "2 status c SUCCESS IDLE\n"
                        "2 halt l\n"
                        "2 status l RUNNING IDLE\n"
                        "2 status ReactiveFallback RUNNING SUCCESS\n"
                        "2 status ReactiveFallback SUCCESS IDLE\n"
                        "2 status T RUNNING SUCCESS\n"
                        "2 status T SUCCESS IDLE\n");
}

TEST_CASE("trace: a skipped node is told though its status stays") {
    const Program program =
        loaded("<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence><Leaf name='l' script='RK' "
               "_post='1'/><Script name='s' code='' _skipIf='true'/></Sequence></BehaviorTree>"
               "</root>");
    Lines lines(program);
    ScriptRun run(program);
    run.step({.dt = 1.0, .trace = &lines});
    lines.text.clear();
    run.step({.dt = 1.0, .trace = &lines});
    CHECK(lines.text == "2 tick l SKIPPED\n"
                        "2 skip l\n"
                        "2 skip s\n"
                        "2 halt l\n"
                        "2 status l RUNNING IDLE\n"
                        "2 skip Sequence\n"
                        "2 skip T\n");
}

TEST_CASE("trace: a machine tells states, transitions, events, logs and errors") {
    const Program program =
        loaded("<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0' name='m' "
               "datamodel='script'><state id='a'><transition event='e' target='b'><log label='l' "
               "expr=\"'v'\"/></transition></state><state id='b'><onentry><log expr='nosuch'/>"
               "</onentry></state></scxml>");
    Lines lines(program);
    ScriptRun run(program);
    run.start({.dt = 1.0, .trace = &lines});
    CHECK(lines.text == "0 status m IDLE RUNNING\n0 status a IDLE RUNNING\n0 enter a\n");
    lines.text.clear();
    send(program, run.state, "e");
    run.step({.dt = 1.0, .trace = &lines});
    CHECK(lines.text == "1 event m e\n"
                        "1 transition a 1\n"
                        "1 status a RUNNING IDLE\n"
                        "1 leave a\n"
                        "1 log m \"l: v\"\n"
                        "1 status b IDLE RUNNING\n"
                        "1 enter b\n"
                        "1 error m \"there is no variable \"nosuch\"\"\n"
                        "1 event m error.execution\n");
}

}  // namespace trellis::test
