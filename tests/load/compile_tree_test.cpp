// Trees to programs: what names refer to, what is found wrong when loading, and the rows that come
// out of it. Exact messages.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis::test {
namespace {

std::string trees(const std::string& main, const std::string& more = {}) {
    return "<root BTCPP_format='4' main_tree_to_execute='Main'>\n<BehaviorTree ID='Main'>\n" +
           main + "\n</BehaviorTree>\n" + more + "</root>";
}

}  // namespace

TEST_CASE("compile tree: rows are the nodes in document order, a subtree one interval") {
    const Program program =
        loaded(trees("<Sequence name='s'><SubTree ID='Sub'/><Leaf name='l' script='S'/></Sequence>",
                     "<BehaviorTree ID='Sub'><Inverter><Cond script='F'/></Inverter>"
                     "</BehaviorTree>"));
    std::string rows;
    for (std::uint32_t n = 0; n < program.rows.size(); ++n) {
        rows += std::string(op_table()[program.rows[n].op].name) + ' ' + program.names[n] + ' ' +
                std::to_string(program.rows[n].end.index) + '\n';
    }
    CHECK(rows == "tree Main 6\nsequence s 6\nsubtree Sub 5\ninverter Inverter 5\n"
                  "condition Cond 5\naction l 6\n");
}

TEST_CASE("compile tree: an unknown tree, with the one that was meant") {
    CHECK(complaints(trees("<SubTree ID='Escap'/>",
                           "<BehaviorTree ID='Escape'><Leaf script='S'/></BehaviorTree>")) ==
          "3:14: unknown-tree: there is no tree \"Escap\"; did you mean \"Escape\"?\n");
}

TEST_CASE("compile tree: a tree that contains itself, with the chain") {
    CHECK(complaints(trees("<SubTree ID='A'/>",
                           "<BehaviorTree ID='A'><SubTree ID='B'/></BehaviorTree>\n"
                           "<BehaviorTree ID='B'><SubTree ID='A'/></BehaviorTree>\n")) ==
          "6:35: tree-recursion: a tree cannot contain itself: A uses B uses A\n");
}

TEST_CASE("compile tree: includes are found, once each, and cycles are errors with the chain") {
    Texts texts;
    texts.add("a.xml", "<root BTCPP_format='4'><include path='b.xml'/></root>");
    texts.add("b.xml", "<root BTCPP_format='4'><BehaviorTree ID='B'><Leaf script='S'/>"
                       "</BehaviorTree></root>");
    texts.add("loop.xml", "<root BTCPP_format='4'><include path='loop.xml'/></root>");
    const std::string main = "<BehaviorTree ID='Main'><SubTree ID='B'/></BehaviorTree>";
    const std::string begin = "<root BTCPP_format='4' main_tree_to_execute='Main'>";
    CHECK(loaded(begin + "<include path='a.xml'/><include path='b.xml'/>" + main + "</root>",
                 {.reader = &texts})
              .rows.size() == 3);
    CHECK(complaints(begin + "<include path='loop.xml'/>" + main + "</root>", {.reader = &texts})
              .find("include-cycle: loop.xml includes loop.xml") != std::string::npos);
    CHECK(complaints(begin + "<include path='none.xml'/>" + main + "</root>", {.reader = &texts})
              .find("unreadable-file: cannot read \"none.xml\"") != std::string::npos);
}

TEST_CASE("compile tree: what includes name obeys the limits together") {
    const std::string head = "<root BTCPP_format='4'>";
    const std::string leaf = "<BehaviorTree ID='B'><Leaf script='S'/></BehaviorTree></root>";
    Texts texts;
    texts.add("small.xml", head + "</root>");
    texts.add("leaf.xml", head + leaf);
    const std::string small = "<include path='small.xml'/>";
    CHECK(complaints(head + small + small + small + leaf, {.reader = &texts, .includes = 2}) ==
          "1:93: too-large: the included files are more than 2\n");
    CHECK(loaded(head + small + small + leaf, {.reader = &texts, .includes = 2}).rows.size() == 2);
    texts.add("long.xml", head + std::string(300, ' ') + "</root>");
    const std::string longer = "<include path='long.xml'/>";
    CHECK(complaints(head + longer + longer + leaf, {.reader = &texts, .limits = {.bytes = 500}}) ==
          "1:65: too-large: the included files are more than 500 bytes in all\n");
    CHECK(complaints(head + small + "<include path='leaf.xml'/>" + leaf,
                     {.reader = &texts, .limits = {.elements = 8}})
              .find("too-large: the file has more than") != std::string::npos);
}

TEST_CASE("compile tree: a variable that nothing sets is an error, with a suggestion") {
    CHECK(complaints(trees("<Sequence><Script code='speed := 1'/><Script code='a := sped'/>"
                           "</Sequence>")) ==
          "3:57: never-set: nothing gives the variable \"sped\" a value; did you mean "
          "\"speed\"?\n");
    CHECK(complaints(trees("<Repeat num_cycles='{n}'><Leaf script='S'/></Repeat>")) ==
          "3:21: never-set: nothing gives the variable \"n\" a value\n");
}

TEST_CASE("compile tree: parameters that a model asks for") {
    const std::string sub = "<BehaviorTree ID='S'><Echo in='{p}'/></BehaviorTree>"
                            "<TreeNodesModel><SubTree ID='S'><input_port name='p'/><input_port "
                            "name='q' default='3'/></SubTree></TreeNodesModel>";
    CHECK(complaints(trees("<SubTree ID='S'/>", sub)) ==
          "3:2: missing-parameter: the tree \"S\" needs the parameter \"p\"\n");
    CHECK(complaints(trees("<SubTree ID='S' _autoremap='true'/>", sub)).empty());
    CHECK(complaints(trees("<SubTree ID='S' p='1'/>", sub)).empty());
}

TEST_CASE("compile tree: the place of an error inside a script counts what entities spell") {
    CHECK(complaints(trees("<Script code=\"a := 1 &lt; &quot; 2\"/>")).starts_with("3:27: "));
    CHECK(complaints(trees("<Script\n  code='a := 1;\n  b := &amp;&amp; 2'/>"))
              .starts_with("5:8: script-syntax: "));
}

TEST_CASE("compile tree: which tree runs") {
    const std::string two = "<root BTCPP_format='4'><BehaviorTree ID='A'><Leaf script='S'/>"
                            "</BehaviorTree><BehaviorTree ID='B'><Leaf script='F'/></BehaviorTree>"
                            "</root>";
    CHECK(complaints(two) ==
          "1:2: no-main-tree: main_tree_to_execute must say which of the trees runs\n");
    CHECK(loaded(two, {.main_tree = "B"}).name({0}) == "B");
    CHECK(complaints(two, {.main_tree = "C"}) == "1:2: unknown-tree: there is no tree \"C\"\n");
}

TEST_CASE("compile tree: faults of trees that are never reached are told too") {
    CHECK(complaints(trees("<Leaf script='S'/>",
                           "<BehaviorTree ID='U'><SubTree ID='Nowhere'/></BehaviorTree>"))
              .find("unknown-tree: there is no tree \"Nowhere\"") != std::string::npos);
}

TEST_CASE("compile tree: remaps, _autoremap, = and @ lead to the variable that is meant") {
    const Program program = loaded(
        trees("<Sequence><Script code='v := 1; same := 2; auto := 3; @top := 4'/>"
              "<SubTree ID='S' p='{v}' same='{=}'/><SubTree ID='S2' _autoremap='true' own='9'/>"
              "</Sequence>",
              "<BehaviorTree ID='S'><Sequence><Echo id='p' in='{p}'/><Echo id='s' in='{same}'/>"
              "<Echo id='t' in='{@top}'/></Sequence></BehaviorTree>"
              "<BehaviorTree ID='S2'><Sequence><Echo id='a' in='{auto}'/><Echo id='o' "
              "in='{own}'/></Sequence></BehaviorTree>"));
    ScriptRun run(program);
    run.step();
    CHECK(run.take_events() == "p=1 s=2 t=4 a=3 o=9");
}

TEST_CASE("compile tree: a name that begins with _ is private, whatever _autoremap says") {
    const Program program = loaded(
        trees("<Sequence><Script code='_p := 1'/><ForceSuccess><SubTree ID='S' _autoremap='1'/>"
              "</ForceSuccess></Sequence>",
              "<BehaviorTree ID='S'><Echo id='e' in='{_p}'/></BehaviorTree>"));
    ScriptRun run(program);
    run.step();
    CHECK(run.take_events() == "e=ERR");
}

TEST_CASE("compile tree: the dump is readable and says what the rows do") {
    const std::string text =
        dump(loaded(trees("<Sequence><Script code='x := 1'/><Leaf id='a' script='S' "
                          "_skipIf='x == 1'/></Sequence>")));
    for (const char* part : {"tree \"Main\"", "sequence \"Sequence\"", "action \"Leaf\"",
                             "conditional", "_skipIf", "slots\n0  x scope 0"}) {
        CAPTURE(part);
        CHECK(text.find(part) != std::string::npos);
    }
}

}  // namespace trellis::test
