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

namespace {

const char* const fallback_tree = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Fallback name="either">
      <Sequence name="first"><MoveForward duration="0.05"/><Script code=""/></Sequence>
      <GoBack/>
    </Fallback>
  </BehaviorTree>
</root>
)";

}  // namespace

TEST_CASE("show: what each node did at a tick of a trace") {
    MemoryFiles files;
    files.content["a.xml"] = fallback_tree;
    REQUIRE(run_words(files, {"run", "a.xml", "--ticks", "6", "--trace", "t.jsonl"}).exit ==
            Exit::yes);
    const auto text = [&](const char* tick) {
        const Ran ran =
            run_words(files, {"show", "a.xml", "--trace", "t.jsonl", "--tick", tick, "--ascii"});
        CHECK(ran.err == "");
        return ran.out;
    };
    CHECK(text("0") == "tick 0 of 6, 0.000 s\n\n"
                       "Main\n"
                       "? either (Fallback)  [idle]\n"
                       "|- -> first (Sequence)  [idle]\n"
                       "|  |- [] MoveForward  duration = 0.05  [idle]\n"
                       "|  `- [] Script  [idle]\n"
                       "`- [] GoBack  [idle]\n");
    CHECK(text("1") == "tick 1 of 6, 0.017 s\n\n"
                       "Main\n"
                       "? either (Fallback)  [running]\n"
                       "|- -> first (Sequence)  [running]\n"
                       "|  |- [] MoveForward  duration = 0.05  [running]\n"
                       "|  `- [] Script  [idle]\n"
                       "`- [] GoBack  [idle]\n");
    CHECK(text("4") == "tick 4 of 6, 0.067 s\n\n"
                       "Main\n"
                       "? either (Fallback)  [success]\n"
                       "|- -> first (Sequence)  [success]\n"
                       "|  |- [] MoveForward  duration = 0.05  [success]\n"
                       "|  `- [] Script  [success]\n"
                       "`- [] GoBack  [idle]\n");
    CHECK(text("5") == "tick 5 of 6, 0.083 s\n\n" + text("1").substr(text("1").find("Main")));
}

TEST_CASE("show: what a run never reached") {
    MemoryFiles files;
    files.content = {{"a.xml", fallback_tree}, {"a.scxml", two_states}};
    run_words(files, {"run", "a.xml", "--ticks", "6", "--trace", "t.jsonl"});
    const Ran tree = run_words(files, {"show", "a.xml", "--trace", "t.jsonl", "--coverage"});
    CHECK(tree.out == "what 6 ticks never reached\n\n"
                      "Main\n"
                      "? either (Fallback)\n"
                      "├─ → first (Sequence)\n"
                      "│  ├─ □ MoveForward  duration = 0.05\n"
                      "│  └─ □ Script\n"
                      "└─ □ GoBack  [idle]  never reached\n");
    run_words(files, {"run", "a.scxml", "--ticks", "2", "--trace", "m.jsonl"});
    const Ran machine = run_words(files, {"show", "a.scxml", "--trace", "m.jsonl", "--coverage"});
    CHECK(machine.out.find("→ done  tick [elapsed() > 0.04]  [idle]  never taken\n") !=
          std::string::npos);
    CHECK(machine.out.find("done  [idle]  never reached\n") != std::string::npos);
}

TEST_CASE("show: states and transitions at a tick of a trace, in every format") {
    MemoryFiles files;
    files.content["a.scxml"] = two_states;
    run_words(files, {"run", "a.scxml", "--trace", "t.jsonl"});
    const Ran ran = run_words(files, {"show", "a.scxml", "--trace", "t.jsonl", "--text", "--svg",
                                      "a.svg", "--dot", "a.dot"});
    CHECK(ran.out.starts_with("tick 4 of 4, 0.067 s\n\n"));
    CHECK(ran.out.find("→ done  tick [elapsed() > 0.04]  [active]\n") != std::string::npos);
    CHECK(ran.out.find("□ go  [idle]\n") != std::string::npos);
    CHECK(ran.out.find("◉ done  [active]\n") != std::string::npos);
    CHECK(files.content["a.svg"].find("active") != std::string::npos);
    CHECK(files.content["a.dot"].find("penwidth=3") != std::string::npos);
}

TEST_CASE("show: traces that cannot be shown") {
    MemoryFiles files;
    files.content = {{"a.xml", fallback_tree}, {"b.xml", forward_tree}, {"c.jsonl", "{}\n"}};
    run_words(files, {"run", "a.xml", "--ticks", "6", "--trace", "t.jsonl"});
    Ran ran = run_words(files, {"show", "b.xml", "--trace", "t.jsonl"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "trellis: the trace was not recorded from b.xml: it has 6 rows, the behaviour "
                     "2\n");
    ran = run_words(files, {"show", "a.xml", "--trace", "t.jsonl", "--tick", "7"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "trellis: t.jsonl ends with tick 6\n");
    ran = run_words(files, {"show", "a.xml", "--trace", "c.jsonl"});
    CHECK(ran.exit == Exit::file);
    CHECK(run_words(files, {"show", "a.xml", "--trace", "none.jsonl"}).exit == Exit::file);
    ran = run_words(files, {"show", "a.xml", "--coverage"});
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: --tick and --coverage need --trace FILE.jsonl\n");
}
