// What the places of a program take a variable for, wherever remaps lead to it; and that the
// findings are about the same variables, whatever the order of the nodes and trees. Exact messages.
// SPDX-License-Identifier: MIT
#include "core/random.h"
#include "load/diagnostics.h"
#include "load/load.h"
#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace trellis::test {
namespace {

std::string trees(const std::string& main, const std::string& more = {}) {
    return "<root BTCPP_format='4' main_tree_to_execute='Main'>\n<BehaviorTree ID='Main'><Sequence>"
           "\n" +
           main + "</Sequence></BehaviorTree>\n" + more + "</root>";
}

std::string tree(const std::string& id, const std::string& nodes) {
    return "<BehaviorTree ID='" + id + "'><Sequence>\n" + nodes + "</Sequence></BehaviorTree>\n";
}

}  // namespace

TEST_CASE("variable types: ports of two types, the first of which is no text, do not load") {
    CHECK(complaints(trees("<PutInt value='1' out='{v}'/>\n<GetDouble in='{v}'/>\n")) ==
          "4:16: type-clash: \"v\" is double here, but int in line 3\n");
    CHECK(complaints(trees("<PutInt value='1' out='{v}'/>\n<GetStr in='{v}'/>\n")) ==
          "4:13: type-clash: \"v\" is std::string here, but int in line 3\n");
    CHECK(complaints(trees("<SubTree ID='S' v='1.5'/>\n", tree("S", "<GetInt in='{v}'/>"))) ==
          "6:13: type-clash: \"v\" is int here, but double in line 3\n");
}

TEST_CASE("variable types: a text first loads, as each reading converts it, with a warning") {
    const std::string file = trees("<PutStr value='x' out='{v}'/>\n<GetInt in='{v}'/>\n"
                                   "<GetDouble in='{v}'/>\n");
    CHECK(complaints(file) ==
          "4:13: type-clash: \"v\" is int here, but std::string in line 3\n"
          "5:16: type-clash: \"v\" is double here, but std::string in line 3\n");
    CHECK(loaded(file).rows.size() == 5);
}

TEST_CASE("variable types: through remaps, autoremaps and @ the variable is one") {
    CHECK(
        complaints(trees("<SubTree ID='Writes' out='{name}'/>\n<SubTree ID='Reads' n='{name}'/>\n",
                         tree("Writes", "<PutStr value='x' out='{out}'/>") +
                             tree("Reads", "<GetInt in='{n}'/>"))) ==
        "9:13: type-clash: \"name\" is int here, but std::string in line 7\n");
    CHECK(complaints(trees("<SubTree ID='A' _autoremap='true'/>\n<SubTree ID='B'/>\n",
                           tree("A", "<Script code=\"name := 'x'\"/>") +
                               tree("B", "<GetInt in='{@name}'/>"))) ==
          "7:15: type-clash: \"name\" is the text \"x\" here, but int in line 9\n");
}

TEST_CASE("variable types: a text that a script gives a variable of a port of numbers") {
    CHECK(complaints(trees("<Script code=\"a := 1; v := 'fast'\"/>\n<GetDouble in='{v}'/>\n")) ==
          "3:23: type-clash: \"v\" is the text \"fast\" here, but double in line 4\n");
    CHECK(complaints(
              trees("<SetBlackboard value='fast' output_key='v'/>\n<GetDouble in='{v}'/>\n")) ==
          "3:23: type-clash: \"v\" is the text \"fast\" here, but double in line 4\n");
    CHECK(complaints(trees("<SubTree ID='S' v='fast'/>\n", tree("S", "<GetDouble in='{v}'/>"))) ==
          "3:20: type-clash: \"v\" is the text \"fast\" here, but double in line 6\n");
    const std::string longer(50, 'x');
    CHECK(complaints(trees("<Script code=\"v := '" + longer + "'\"/>\n<GetInt in='{v}'/>\n")) ==
          "3:15: type-clash: \"v\" is a text here, but int in line 4\n");
}

TEST_CASE(
    "variable types: a text that spells a number, a truth value or an enumerator may be one") {
    for (const char* const text : {"12", "2abc", "true", "False", "RED"}) {
        CHECK(complaints(trees("<Script code=\"v := '" + std::string(text) +
                               "'\"/>\n<GetInt in='{v}'/>\n")) == "");
        CHECK(complaints(trees("<SetBlackboard value='" + std::string(text) +
                               "' output_key='v'/>\n<GetInt in='{v}'/>\n")) == "");
    }
    CHECK(complaints(trees("<SubTree ID='S' v='true'/>\n", tree("S", "<GetInt in='{v}'/>"))) == "");
}

TEST_CASE("variable types: scripts that give a variable a text and a number") {
    CHECK(complaints(trees("<Script code=\"v := 'a'\"/>\n<Script code='v := 1'/>\n")) ==
          "3:15: type-clash: \"v\" is the text \"a\" here, but a number in line 4\n");
    CHECK(complaints(trees("<Script code='v := 1 &lt; 2'/>\n<Script code=\"v = 'a'\"/>\n")) ==
          "4:15: type-clash: \"v\" is the text \"a\" here, but a number in line 3\n");
    CHECK(complaints(trees("<Script code=\"v := 'a'\"/>\n<Script code='v -= 1'/>\n")) ==
          "3:15: type-clash: \"v\" is the text \"a\" here, but a number in line 4\n");
    // joined texts are texts, and what is copied is not known
    CHECK(complaints(trees("<Script code=\"v := 'a'; w := 'b'\"/>\n"
                           "<Script code=\"v += 'c'; v = v .. 1; v = w\"/>\n")) == "");
}

TEST_CASE("variable types: a text of a SubTree stays a text, whatever it spells") {
    const std::string sub = tree("S", "<Script code='flag := true'/>");
    CHECK(complaints(trees("<SubTree ID='S' flag='false'/>\n", sub)) ==
          "6:15: type-clash: \"flag\" is a number here, but the text \"false\" in line 3\n");
    CHECK(complaints(trees("<SubTree ID='S' flag='0'/>\n", sub)) == "");
}

TEST_CASE("variable types: a subtree that is used twice says it once, another file is named") {
    Texts texts;
    texts.add("reads.xml", "<root BTCPP_format='4'><BehaviorTree ID='Reads'>\n<GetInt in='{n}'/>"
                           "</BehaviorTree></root>");
    CHECK(complaints("<root BTCPP_format='4' main_tree_to_execute='M'><include path='reads.xml'/>\n"
                     "<BehaviorTree ID='M'><Sequence><PutStr value='x' out='{v}'/>\n"
                     "<SubTree ID='Reads' n='{v}'/><SubTree ID='Reads' n='{v}'/></Sequence>"
                     "</BehaviorTree></root>",
                     {.reader = &texts}) ==
          "2:13: type-clash: \"v\" is int here, but std::string in test, line 2\n");
}

TEST_CASE("variable types: numbers in a variable of texts, and untyped ports, clash with nothing") {
    CHECK(complaints(trees("<Script code='v := 1'/>\n<GetStr in='{v}'/>\n")) == "");
    CHECK(complaints(
              trees("<Script code=\"v := 'a'\"/>\n<Echo in='{v}'/>\n<GetStr in='{v}'/>\n")) == "");
}

namespace {

/// Some nodes that put something into variables or take it out, by way of subtrees or not.
std::vector<std::string> random_nodes(Random& random) {
    static const std::vector<std::string> all = {"<PutInt value='1' out='{@}'/>",
                                                 "<PutStr value='x' out='{@}'/>",
                                                 "<PutDouble value='1' out='{@}'/>",
                                                 "<GetInt in='{@}'/>",
                                                 "<GetStr in='{@}'/>",
                                                 "<GetDouble in='{@}'/>",
                                                 "<Script code=\"@ := 'a'\"/>",
                                                 "<Script code='@ := 1'/>",
                                                 "<Script code='@ = 2'/>",
                                                 "<ScriptCondition code='@ == 1'/>",
                                                 "<SubTree ID='PutsText' v='{@}'/>",
                                                 "<SubTree ID='GetsInt' v='{@}'/>",
                                                 "<SubTree ID='Gets_@' _autoremap='1'/>"};
    std::vector<std::string> nodes;
    for (int i = 0; i < 5; ++i) {
        const auto last = static_cast<std::int64_t>(all.size()) - 1;
        std::string node = all[static_cast<std::size_t>(random.whole(0, last))];
        const std::string name = random.whole(0, 1) == 0 ? "a" : "b";
        for (std::size_t at = node.find('@'); at != std::string::npos; at = node.find('@')) {
            node.replace(at, 1, name);
        }
        nodes.push_back(node);
    }
    return nodes;
}

/// The ids and variables of what is found, as "type-clash a".
std::set<std::string> findings(const std::vector<std::string>& nodes, bool trees_first) {
    std::string main = "<BehaviorTree ID='Main'><Sequence>";
    for (const std::string& node : nodes) {
        main += node + '\n';
    }
    main += "</Sequence></BehaviorTree>";
    const std::string more =
        tree("PutsText", "<PutStr value='x' out='{v}'/>") + tree("GetsInt", "<GetInt in='{v}'/>") +
        tree("Gets_a", "<GetDouble in='{a}'/>") + tree("Gets_b", "<Script code='b := 1'/>");
    const std::string said = complaints("<root BTCPP_format='4' main_tree_to_execute='Main'>" +
                                        (trees_first ? more + main : main + more) + "</root>");
    std::set<std::string> found;
    for (const char* const name : {"\"a\"", "\"b\""}) {
        for (const std::string id : {"type-clash", "never-set"}) {
            for (std::size_t at = said.find(id); at != std::string::npos;
                 at = said.find(id, at + 1)) {
                const std::string line = said.substr(at, said.find('\n', at) - at);
                if (line.find(name) < line.find(" here")) { found.insert(id + ' ' + name); }
            }
        }
    }
    return found;
}

}  // namespace

TEST_CASE("variable types: the order of nodes and of trees changes nothing in what is found") {
    Random random(20);
    std::size_t faulty = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<std::string> nodes = random_nodes(random);
        const std::set<std::string> expected = findings(nodes, false);
        faulty += expected.empty() ? 0 : 1;
        std::sort(nodes.begin(), nodes.end());
        for (int order = 0; order < 6; ++order) {
            std::rotate(nodes.begin(), nodes.begin() + 1, nodes.end());
            if (order % 2 == 0) { std::swap(nodes[1], nodes[3]); }
            CHECK_MESSAGE(findings(nodes, order < 3) == expected,
                          complaints(trees(nodes[0] + nodes[1] + nodes[2] + nodes[3] + nodes[4])));
        }
    }
    CHECK(faulty > 100);
}

}  // namespace trellis::test
