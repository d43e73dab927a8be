// trellis try: commands from standard input, with a robot and without.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const fallback_tree = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Fallback name="either">
      <Sequence name="first">
        <MoveForward/>
        <SetVelocity name="stop" linear="{speed}"/>
      </Sequence>
      <GoBack/>
    </Fallback>
  </BehaviorTree>
</root>
)";

const char* const door = R"(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0"
  datamodel="script">
  <datamodel><data id="opened" expr="0"/><data id="by" expr="'nobody'"/></datamodel>
  <state id="closed"><transition event="open" target="opening"><assign location="opened"
    expr="opened + 1"/><assign location="by" expr="_event.data"/></transition></state>
  <state id="opening"><onentry><log label="by" expr="by"/></onentry>
    <transition event="break" target="broken"/></state>
  <final id="broken"/>
</scxml>
)";

Ran try_out(const std::string& file, const std::string& text, std::vector<std::string> options,
            const std::string& commands) {
    MemoryFiles files;
    files.content[file] = text;
    options.insert(options.begin(), {"try", file});
    return run_words(files, options, commands);
}

}  // namespace

TEST_CASE("try: a tree whose leaves return what they are told") {
    const Ran ran = try_out("a.xml", fallback_tree,
                            {"--world", "none", "--outcomes", "MoveForward=RS", "--outcomes",
                             "stop=F", "--set", "speed=1", "--ascii"},
                            "tick\ntick\nstate\noutcomes\n");
    CHECK(ran.err == "");
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out == "tick 1  RUNNING  MoveForward RUNNING\n"
                     "tick 2  RUNNING  MoveForward SUCCESS, stop FAILURE, GoBack RUNNING\n"
                     "tick 2  RUNNING\n"
                     "Main\n"
                     "? either (Fallback)  [running]\n"
                     "|- -> first (Sequence)  [failure]\n"
                     "|  |- [] MoveForward  [success]\n"
                     "|  `- [] stop (SetVelocity)  linear = {speed}  [failure]\n"
                     "`- [] GoBack  [running]\n"
                     "GoBack\n");
}

TEST_CASE("try: back undoes ticks and assignments, halt and reset") {
    const Ran ran =
        try_out("a.xml", fallback_tree,
                {"--world", "none", "--outcomes", "MoveForward=RS", "--set", "speed=1.5"},
                "get speed\nset speed = 2\nget speed\ntick\nback 2\nget speed\n"
                "tick\ntick\nhalt\nreset\nvars\n");
    CHECK(ran.err == "");
    CHECK(ran.out == "1.5\n2.0\n"
                     "tick 1  RUNNING  MoveForward RUNNING\n"
                     "tick 0  IDLE\n"
                     "1.5\n"
                     "tick 1  RUNNING  MoveForward RUNNING\n"
                     "tick 2  RUNNING  MoveForward SUCCESS, stop RUNNING\n"
                     "tick 2  IDLE  stop halted\n"
                     "tick 0  IDLE\n"
                     "speed = 1.5\n");
}

TEST_CASE("try: with the robot, and some of its leaves told what to return") {
    const Ran ran = try_out("a.xml", fallback_tree, {"--set", "speed=1"},
                            "tick 100\npose\noutcomes MoveForward=F\ntick\n");
    CHECK(ran.err == "");
    CHECK(ran.out == "tick 1  RUNNING  MoveForward RUNNING\n"
                     "tick 100  RUNNING  MoveForward RUNNING\n"
                     "x 4.033333333333332 m, y 2.4 m, rotation 0.0 rad\n"
                     "tick 101  RUNNING  MoveForward FAILURE, GoBack RUNNING\n");
}

TEST_CASE("try: a machine that is sent events") {
    const Ran ran = try_out("a.scxml", door, {"--world", "none"},
                            "tick 2\nsend open 'Ann'\ntick\nvars\nsend break\ntick\ntick\n"
                            "back 2\nstate\n");
    CHECK(ran.err == "trellis: the machine has come to its end; try back or reset\n");
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out == "tick 1  closed\n"
                     "tick 2  closed\n"
                     "tick 3  opening  closed left, opening entered, log by: Ann\n"
                     "opened = 1.0\n"
                     "by = \"Ann\"\n"
                     "tick 4  broken  opening left, broken entered\n"
                     "tick 3  opening\n"
                     "tick 3  opening\n"
                     "machine\n"
                     "  ● → closed\n"
                     "  □ closed  [idle]\n"
                     "      → opening  open / opened = opened + 1; by = _event.data  [active]\n"
                     "  □ opening  [active]\n"
                     "      entry / log by by\n"
                     "      → broken  break\n"
                     "  ◉ broken  [idle]\n");
}

TEST_CASE("try: commands that make no sense do not end it, but are its exit code") {
    const auto said = [](const std::string& command) {
        const Ran ran = try_out("a.xml", fallback_tree, {"--set", "speed=1.5"}, command + "\n");
        CHECK(ran.exit == Exit::no);
        return ran.err;
    };
    CHECK(said("tik") == "trellis: there is no command \"tik\"; did you mean \"tick\"?\n");
    CHECK(said("xyzzy") == "trellis: there is no command \"xyzzy\"; try help\n");
    CHECK(said("tick 0") == "trellis: expected a whole number from 1 to 1000000, found \"0\"\n");
    CHECK(said("set speed") == "trellis: expected set NAME=VALUE, found \"speed\"\n");
    CHECK(said("set sped=1") ==
          "trellis: there is no variable \"sped\"; did you mean \"speed\"?\n");
    CHECK(said("set speed=fast") == "trellis: speed takes a number, found \"fast\"\n");
    CHECK(said("outcomes MoveForward=X") ==
          "trellis: expected letters of S, F, R and K, found \"X\"\n");
    CHECK(said("outcomes MoveForwrd=S") ==
          "trellis: there is no leaf \"MoveForwrd\"; did you mean \"MoveForward\"?\n");
    CHECK(said("send e") == "trellis: a tree takes no events; try set\n");
    CHECK(said("back 3") == "trellis: only 0 of 3 steps could be undone\n");
    CHECK(said("reset 3") == "trellis: reset takes nothing, found \"3\"\n");
    const Ran ran = try_out("a.xml", fallback_tree, {"--set", "speed=1"},
                            "# a comment\n\nwhat\ntick\nquit\ntick\n");
    CHECK(ran.out == "tick 1  RUNNING  MoveForward RUNNING\n");
}

TEST_CASE("try: a tick that fails leaves the session where it was") {
    const Ran ran = try_out("a.xml", R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
        <Script code="x += 1"/></BehaviorTree></root>)",
                            {"--set", "x=a"}, "tick\nstate\n");
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("error: Script: ") != std::string::npos);
    CHECK(ran.out.starts_with("tick 0  IDLE\n"));
}

TEST_CASE("try: wrong options, and standard input is for commands") {
    Ran ran = try_out("a.xml", fallback_tree, {"--set", "speed=1", "--outcomes", "Mov=S"}, "");
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: there is no leaf \"Mov\"\n");
    ran = try_out("a.xml", fallback_tree, {"--set", "speed=1", "--outcomes", "MoveForward"}, "");
    CHECK(ran.exit == Exit::usage);
    MemoryFiles files;
    ran = run_words(files, {"try", "-"});
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: the commands come from standard input: the behaviour must be a "
                     "file\n");
}
