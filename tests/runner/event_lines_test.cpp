// Events as JSON Lines: every kind.
// SPDX-License-Identifier: MIT
#include "runner/event_lines.h"

#include "runner/behaviour.h"
#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("event lines: members by kind, and kinds without a line") {
    const RoombaRegistry registry;
    Diagnostics diagnostics;
    const auto program = load({"a.scxml", two_states}, registry, diagnostics);
    REQUIRE(program);
    const auto line = [&](const TraceEvent& event) {
        std::string out;
        append_event_line(out, *program, event);
        return out;
    };
    using Kind = TraceEvent::Kind;
    CHECK(line({.tick = 3, .kind = Kind::tick, .row = {3}, .to = Status::failure}) ==
          R"({"tick": 3, "event": "tick", "row": 3, "name": "SetVelocity", "status": "FAILURE"}
)");
    CHECK(line({.tick = 3, .kind = Kind::halt, .row = {3}}) ==
          R"({"tick": 3, "event": "halt", "row": 3, "name": "SetVelocity"}
)");
    CHECK(line({.tick = 3, .kind = Kind::skip, .row = {3}}) ==
          R"({"tick": 3, "event": "skip", "row": 3, "name": "SetVelocity"}
)");
    CHECK(line({.tick = 3, .kind = Kind::status, .row = {3}, .to = Status::running}) ==
          R"({"tick": 3, "event": "status", "row": 3, "name": "SetVelocity", "from": "IDLE", )"
          R"("to": "RUNNING"}
)");
    CHECK(line({.tick = 3, .kind = Kind::leave, .row = {1}}) ==
          R"({"tick": 3, "event": "leave", "row": 1, "name": "go"}
)");
    CHECK(line({.tick = 3, .kind = Kind::error, .row = {1}, .text = "a \"b\""}) ==
          R"({"tick": 3, "event": "error", "row": 1, "name": "go", "text": "a \"b\""}
)");
    CHECK(line({.tick = 3, .kind = Kind::status, .row = {1}, .to = Status::running}) == "");
    CHECK(line({.tick = 3, .kind = Kind::event, .row = {0}, .event = {0}}) == "");
}
