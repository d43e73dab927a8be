// Files of events, read back: every event as it was, and what is no such file.
// SPDX-License-Identifier: MIT
#include "runner/recording.h"

#include "runner/behaviour.h"
#include "runner/command.h"
#include "runner/event_lines.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

namespace {

const std::string first_line = R"({"tick": 0, "event": "run", "row": 0, "name": "Main", )"
                               R"("file": "a.xml", "rows": 2, "dt": 0.5, "random": "seed 0"})"
                               "\n";

std::string errors_of(const std::string& text) {
    Diagnostics diagnostics;
    CHECK_FALSE(read_recording("t.jsonl", text, diagnostics));
    return diagnostics.all().empty() ? "" : diagnostics.all().front().message;
}

}  // namespace

TEST_CASE("recording: what is written is read") {
    MemoryFiles files;
    files.content["a.scxml"] = two_states;
    const RoombaRegistry registry;
    Diagnostics diagnostics;
    const auto program = load({"a.scxml", two_states}, registry, diagnostics);
    REQUIRE(program);
    CHECK(run_words(files, {"run", "a.scxml", "--trace", "t.jsonl"}).exit == Exit::yes);
    const std::string& text = files.content["t.jsonl"];
    const auto recording = read_recording("t.jsonl", text, diagnostics);
    REQUIRE(recording);
    CHECK(recording->file == "a.scxml");
    CHECK(recording->rows == program->rows.size());
    CHECK(recording->ticks == 4);
    CHECK(mismatch(*recording, *program) == "");
    std::string again;
    append_run_line(again, *program,
                    {.file = recording->file, .tree = {}, .dt = recording->dt, .random = "seed 0"});
    for (const TraceEvent& event : recording->events) {
        append_event_line(again, *program, event);
    }
    append_end_line(again, recording->ticks, "final: done");
    CHECK(again == text);
}

TEST_CASE("recording: files that are none") {
    CHECK(errors_of("") ==
          "expected a trace of events, as trellis run --trace FILE.jsonl writes it");
    CHECK(errors_of("tick,t,x\n") == "expected a JSON object");
    CHECK(errors_of(R"({"tick": 1, "event": "tick"})") ==
          "expected a first line that says which run it was, with \"event\": \"run\"");
    CHECK(errors_of(R"({"tick": 0, "event": "run", "name": "a", "file": "b", "rows": 1})") ==
          "expected a positive number \"dt\"");
    CHECK(errors_of(first_line + R"({"tick": 1, "event": "tik"})") == "there is no event \"tik\"");
    CHECK(errors_of(first_line + R"({"tick": 1, "event": "halt", "row": 2, "name": "a"})") ==
          "there is no row 2");
    CHECK(errors_of(first_line + R"({"tick": 1, "event": "halt", "row": -1, "name": "a"})") ==
          "expected a whole number \"row\"");
    CHECK(errors_of(first_line +
                    R"({"tick": 1, "event": "tick", "row": 1, "name": "a", "status": "DONE"})") ==
          "there is no status \"DONE\"");
    CHECK(errors_of(first_line + "{\"tick\": 2, \"event\": \"end\", \"text\": \"\"}\n"
                                 "{\"tick\": 1, \"event\": \"end\", \"text\": \"\"}\n") ==
          "ticks must not decrease");
}

TEST_CASE("recording: of another behaviour") {
    const RoombaRegistry registry;
    Diagnostics diagnostics;
    const auto program = load({"a.xml", forward_tree}, registry, diagnostics);
    REQUIRE(program);
    auto recording = read_recording(
        "t.jsonl", first_line + R"({"tick": 1, "event": "halt", "row": 1, "name": "Wait"})",
        diagnostics);
    REQUIRE(recording);
    CHECK(mismatch(*recording, *program) ==
          "its row 1 is called \"Wait\", that of the behaviour \"MoveForward\"");
    recording->rows = 5;
    CHECK(mismatch(*recording, *program) == "it has 5 rows, the behaviour 2");
}
