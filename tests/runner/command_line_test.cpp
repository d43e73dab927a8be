// The command line: help, version, suggestions, colour.
// SPDX-License-Identifier: MIT
#include "runner/command_line.h"

#include "runner/command.h"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace trellis;
using namespace trellis::test;

namespace {

std::string usage_message(const std::vector<std::string>& words) {
    MemoryFiles files;
    const Ran ran = run_words(files, words);
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.out == "");
    return ran.err;
}

/// A disk that breaks in a way nobody thought of.
class BrokenFiles : public Files {
public:
    std::optional<std::string> read(const std::string&, std::size_t, std::string&) override {
        throw std::logic_error("no such thing");
    }
    std::unique_ptr<OutputFile> create(const std::string&, std::string&) override {
        throw std::bad_alloc();
    }
    std::unique_ptr<GrowingFile> grow(const std::string&, std::string&) override {
        throw std::bad_alloc();
    }
    void remove(const std::string&) override {}
};

}  // namespace

TEST_CASE("command line: version and help are results") {
    MemoryFiles files;
    CHECK(run_words(files, {"--version"}).out.starts_with("trellis "));
    const Ran help = run_words(files, {"--help"});
    CHECK(help.exit == Exit::yes);
    CHECK(help.err == "");
    for (const char* command :
         {"run", "validate", "convert", "show", "compare", "sweep", "nodes", "schema", "trace"}) {
        CHECK(help.out.find(std::string("\n  ") + command) != std::string::npos);
        const Ran more = run_words(files, {command, "--help"});
        CHECK(more.exit == Exit::yes);
        CHECK(more.out.find(std::string("Usage: trellis ") + command) != std::string::npos);
        CHECK(more.out.find("Examples:\n  trellis ") != std::string::npos);
    }
}

TEST_CASE("command line: misspelt words get a suggestion") {
    CHECK(usage_message({"rnu"}) == "trellis: there is no command \"rnu\"; did you mean \"run\"?\n"
                                    "try: trellis --help\n");
    CHECK(usage_message({"trace", "dif"}) ==
          "trellis: there is no command \"dif\"; did you mean \"diff\"?\n"
          "try: trellis trace --help\n");
    CHECK(usage_message({"run", "--sed", "3", "a.xml"}) ==
          "trellis: trellis run has no option --sed; did you mean \"--seed\"?\n"
          "try: trellis run --help\n");
    CHECK(usage_message({"--versio"}) ==
          "trellis: trellis has no option --versio; did you mean \"--version\"?\n"
          "try: trellis --help\n");
    CHECK(usage_message({"run", "a.xml", "--format", "jsn"}) ==
          "trellis: --format: expected text|json, found \"jsn\"; did you mean \"json\"?\n"
          "try: trellis run --help\n");
}

TEST_CASE("command line: too little and too much") {
    CHECK(usage_message({}) == "trellis: which command?\ntry: trellis --help\n");
    CHECK(usage_message({"trace"}) == "trellis: which command?\ntry: trellis trace --help\n");
    CHECK(usage_message({"run"}) == "trellis: FILE is required\ntry: trellis run --help\n");
    CHECK(usage_message({"run", "a.xml", "b.xml"}) ==
          "trellis: there is no use for \"b.xml\" here\ntry: trellis run --help\n");
    CHECK(usage_message({"run", "a.xml", "--trace", "a.txt"}) ==
          "trellis: --trace: a trace is written as FILE.csv or FILE.jsonl, not as \"a.txt\"\n"
          "try: trellis run --help\n");
    CHECK(usage_message({"run", "a.xml", "--set", "a"}) ==
          "trellis: --set: expected name=value, found \"a\"\ntry: trellis run --help\n");
}

TEST_CASE("command line: colour follows --color, then the environment, then the terminal") {
    MemoryFiles files;
    files.content["a.xml"] = broken_tree;
    const auto coloured = [&](std::vector<std::string> more, const Terminal& terminal) {
        more.insert(more.begin(), {"validate", "a.xml"});
        return run_words(files, more, {}, terminal).err.find('\x1b') != std::string::npos;
    };
    CHECK_FALSE(coloured({}, {}));
    CHECK(coloured({}, {.is_terminal = true}));
    CHECK(coloured({}, {.clicolor_force = true}));
    CHECK_FALSE(coloured({}, {.is_terminal = true, .no_color = true, .clicolor_force = true}));
    CHECK(coloured({"--color", "always"}, {.no_color = true}));
    CHECK_FALSE(coloured({"--color=never"}, {.is_terminal = true}));
}

TEST_CASE("command line: what nobody thought of is an internal error") {
    BrokenFiles files;
    Ran ran = run_words(files, {"run", "a.xml"});
    CHECK(ran.exit == Exit::internal);
    CHECK(ran.err == "trellis: internal error: no such thing\n");
    ran = run_words(files, {"convert", "-", "a.json"}, forward_tree);
    CHECK(ran.exit == Exit::internal);
    CHECK(ran.err == "trellis: internal error: not enough memory\n");
}
