// The events before the first tick.
// SPDX-License-Identifier: MIT
#include "runner/start_events.h"

#include "runner/behaviour.h"
#include "runner/command.h"
#include "runner/event_lines.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

namespace {

struct Lines : TraceSink {
    const Program& program;
    std::string text;
    explicit Lines(const Program& p) : program(p) {}
    void on(const TraceEvent& event) override { append_event_line(text, program, event); }
};

}  // namespace

TEST_CASE("start events: the states that a machine enters, and what their content does") {
    const RoombaRegistry registry;
    Diagnostics diagnostics;
    const auto program = load({"a.scxml", two_states}, registry, diagnostics);
    REQUIRE(program);
    const Episode episode(*program, {});
    Lines lines(*program);
    trace_start(episode, lines);
    CHECK(lines.text ==
          R"({"tick": 0, "event": "enter", "row": 1, "name": "go"}
{"tick": 0, "event": "log", "row": 1, "name": "go", "text": "now: going"}
{"tick": 0, "event": "status", "row": 2, "name": "go.1", "from": "IDLE", "to": "RUNNING"}
)");
}

TEST_CASE("start events: a tree has none") {
    const RoombaRegistry registry;
    Diagnostics diagnostics;
    const auto program = load({"a.xml", forward_tree}, registry, diagnostics);
    REQUIRE(program);
    const Episode episode(*program, {});
    Lines lines(*program);
    trace_start(episode, lines);
    CHECK(lines.text == "");
}
