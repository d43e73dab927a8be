// trellis show: which pictures are written where. The pictures themselves: tests/drawing.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("show: text on standard output unless files are asked for") {
    MemoryFiles files;
    files.content["a.scxml"] = two_states;
    Ran ran = run_words(files, {"show", "a.scxml"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out.find("→ done  tick [elapsed() > 0.04]\n") != std::string::npos);
    ran = run_words(files, {"show", "a.scxml", "--svg", "a.svg", "--dot", "a.dot"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out == "");
    CHECK(files.content["a.svg"].starts_with("<svg"));
    CHECK(files.content["a.dot"].starts_with("digraph"));
    CHECK(run_words(files, {"show", "a.scxml", "--dot", "-"}).out == files.content["a.dot"]);
}

TEST_CASE("show: ASCII only") {
    MemoryFiles files;
    files.content["a.scxml"] = two_states;
    for (const char c : run_words(files, {"show", "a.scxml", "--ascii"}).out) {
        REQUIRE(static_cast<unsigned char>(c) < 0x80);
    }
}

TEST_CASE("show: a tree with unknown leaves can be drawn") {
    MemoryFiles files;
    files.content["a.xml"] = broken_tree;
    const Ran ran = run_words(files, {"show", "a.xml"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out.find("Sequenc") != std::string::npos);
}

TEST_CASE("show: the compiled program, of a valid file") {
    MemoryFiles files;
    files.content = {{"a.xml", forward_tree}, {"b.xml", broken_tree}};
    CHECK(run_words(files, {"show", "a.xml", "--program"})
              .out.starts_with("rows\n0  tree \"Main\" end 2 arg 0\n"));
    CHECK(run_words(files, {"show", "b.xml", "--program"}).exit == Exit::no);
    CHECK(run_words(files, {"show", "a.xml", "--program", "--ascii"}).exit == Exit::usage);
}
