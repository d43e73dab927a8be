// Commands and their expected output as documents show them (tests/project/transcript.h).
// SPDX-License-Identifier: MIT
#include "project/transcript.h"

#include <doctest/doctest.h>

using trellis::test::commands_of;
using trellis::test::output_matches;

TEST_CASE("transcript: each command has the lines below it") {
    const auto commands = commands_of("$ echo a\na\n$ trellis run \\\n    x.xml\n\nb\n$ true\n");
    REQUIRE(commands.size() == 3);
    CHECK(commands[0].text == "echo a");
    CHECK(commands[0].expected == "a\n");
    CHECK(commands[1].text == "trellis run \\\n    x.xml");
    CHECK(commands[1].expected == "\nb\n");
    CHECK(commands[2].expected == "");
    CHECK(commands_of("echo $HOME\n").empty());
}

TEST_CASE("transcript: output is compared line by line") {
    CHECK(output_matches("a\nb\n", "a\nb\n"));
    CHECK(output_matches("a\n\n", "a"));
    CHECK(output_matches("", "\n"));
    CHECK_FALSE(output_matches("a\n", "a\nb\n"));
    CHECK_FALSE(output_matches("a\nb\n", "a\n"));
    CHECK_FALSE(output_matches("a \n", "a\n"));
    CHECK_FALSE(output_matches("", "a\n"));
}

TEST_CASE("transcript: an ellipsis stands for lines or for the rest of one") {
    CHECK(output_matches("a\n…\nd\n", "a\nb\nc\nd\n"));
    CHECK(output_matches("a\n…\nd\n", "a\nd\n"));
    CHECK(output_matches("…\n", ""));
    CHECK(output_matches("took …\n", "took 3 s\n"));
    CHECK_FALSE(output_matches("took …\n", "gave 3 s\n"));
    CHECK_FALSE(output_matches("a\n…\nd\n", "a\nb\nc\n"));
}
