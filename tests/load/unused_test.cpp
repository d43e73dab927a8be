// Trees and parameters that nothing uses: what is said, and what is not, because it may be meant.
// Exact messages.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis::test {
namespace {

const std::string leaf = "<Leaf script='S'/>";

std::string tree(const std::string& id, const std::string& root) {
    return "<BehaviorTree ID='" + id + "'>" + root + "</BehaviorTree>\n";
}

std::string file(const std::string& trees) {
    return "<root BTCPP_format='4' main_tree_to_execute='Main'>\n" + trees + "</root>";
}

/// A main tree that is the SubTree "S" with these attributes, and what "S" is.
std::string use(const std::string& attributes, const std::string& root,
                const std::string& more = {}) {
    return complaints(
        file(tree("Main", "<SubTree ID='S' " + attributes + "/>") + tree("S", root) + more));
}

}  // namespace

TEST_CASE("unused: trees to which nothing leads from the main tree, each") {
    CHECK(complaints(file(tree("Main", "<SubTree ID='A'/>") + tree("A", leaf) +
                          tree("B", "<SubTree ID='C'/>") + tree("C", leaf))) ==
          "4:2: unused-tree: the tree \"B\" is never used: no SubTree leads to it from \"Main\"\n"
          "5:2: unused-tree: the tree \"C\" is never used: no SubTree leads to it from \"Main\"\n");
    CHECK(complaints(file(tree("Main", "<SubTree ID='A'/>") + tree("A", "<SubTree ID='B'/>") +
                          tree("B", leaf))) == "");
}

TEST_CASE("unused: trees are not told of where another may be run, or where there are errors") {
    const std::string two = tree("Main", leaf) + tree("Other", leaf);
    CHECK(complaints(file(two), {.main_tree = "Main"}) == "");
    CHECK(complaints("<root BTCPP_format='4'>" + tree("Main", leaf) + "</root>") == "");
    CHECK(complaints(file(tree("Main", "<SubTree ID='Othr'/>") + tree("Other", leaf))) ==
          "2:38: unknown-tree: there is no tree \"Othr\"; did you mean \"Other\"?\n");
    Texts texts;
    texts.add("library.xml", "<root BTCPP_format='4'>" + two.substr(two.find('\n') + 1) +
                                 tree("Third", leaf) + "</root>");
    CHECK(complaints(file("<include path='library.xml'/>" + tree("Main", "<SubTree ID='Third'/>")),
                     {.reader = &texts}) == "");
}

TEST_CASE("unused: a parameter that nothing in the tree means") {
    CHECK(use("speed='0.5'", leaf) ==
          "2:41: unused-parameter: nothing in the tree \"S\" uses \"speed\"\n");
    CHECK(use("speed='{v}' _autoremap='true'", leaf) ==
          "2:41: unused-parameter: nothing in the tree \"S\" uses \"speed\"\n");
    CHECK(use("name='n' _skipIf='false' _note='x'", leaf) == "");
}

TEST_CASE("unused: a misspelt parameter, with the name that the tree uses") {
    CHECK(
        use("sped='1'", "<Sequence><Script code='speed := 2'/><GetInt in='{speed}'/></Sequence>") ==
        "2:41: unused-parameter: nothing in the tree \"S\" uses \"sped\"; did you mean "
        "\"speed\"?\n");
    CHECK(use("sped='1'", "<ScriptCondition code='speed &gt; 1'/>") ==
          "2:41: unused-parameter: nothing in the tree \"S\" uses \"sped\"; did you mean "
          "\"speed\"?\n"
          "3:45: never-set: nothing gives the variable \"speed\" a value; did you mean "
          "\"sped\"?\n");
    CHECK(use("p='1' sped='{v}'", "<Echo in='{p}'/>",
              "<TreeNodesModel><SubTree ID='S'><input_port name='speed' default='1'/></SubTree>"
              "</TreeNodesModel>") ==
          "2:47: unused-parameter: nothing in the tree \"S\" uses \"sped\"; did you mean "
          "\"speed\"?\n");
}

TEST_CASE("unused: whatever means a parameter uses it") {
    for (const char* const attributes : {"p='1'", "p='{v}'", "p='json:[1]'"}) {
        const std::string given = attributes;
        CHECK(use(given, "<Echo in='{p}'/>") == "");
        CHECK(use(given, "<Echo in='{=}' _skipIf='false'/>").find("unused") != std::string::npos);
        CHECK(use(given, "<Script code='p := 2'/>").find("unused") == std::string::npos);
        CHECK(use(given, "<SetBlackboard value='1' output_key='p'/>") == "");
        CHECK(use(given, "<SkipUnlessUpdated entry='p'>" + leaf + "</SkipUnlessUpdated>") == "");
        CHECK(use(given, "<UnsetBlackboard key='p'/>").find("unused") == std::string::npos);
    }
    for (const char* const condition : {"_skipIf", "_onHalted", "_post", "_while"}) {
        CHECK(use("p='1'", "<Leaf script='S' " + std::string(condition) + "='p == 1'/>") == "");
    }
}

TEST_CASE("unused: a parameter that a subtree inside is given, or means by _autoremap, is used") {
    CHECK(use("p='1'", "<SubTree ID='T' q='{p}'/>", tree("T", "<Echo in='{q}'/>")) == "");
    CHECK(use("p='1'", "<SubTree ID='T' q='{p}'/>", tree("T", leaf)) ==
          "3:38: unused-parameter: nothing in the tree \"T\" uses \"q\"\n");
    for (const char* const given : {"p='1'", "p='{v}'"}) {
        CHECK(use(given, "<SubTree ID='T' _autoremap='1'/>", tree("T", "<Echo in='{p}'/>")) == "");
        CHECK(use(given, "<SubTree ID='T' _autoremap='1'/>", tree("T", "<Echo in='{q}'/>")) ==
              "2:41: unused-parameter: nothing in the tree \"S\" uses \"p\"\n");
    }
}

TEST_CASE("unused: a key that is in a variable may be any parameter") {
    CHECK(use("p='1' k='p'", "<SetBlackboard value='2' output_key='{k}'/>") == "");
    CHECK(use("p='1' k='p'", "<UnsetBlackboard key='{k}'/>") == "");
}

TEST_CASE("unused: what a model declares for a tree is not told of") {
    CHECK(
        use("p='1'", leaf,
            "<TreeNodesModel><SubTree ID='S'><input_port name='p'/></SubTree></TreeNodesModel>") ==
        "");
}

TEST_CASE("unused: a tree that is used in several places is told of at each, once") {
    const std::string twice = "<SubTree ID='Twice'/>";
    CHECK(complaints(file(tree("Main", "<Sequence>" + twice + twice + "</Sequence>") +
                          tree("Twice", "<SubTree ID='S' p='1'/>") + tree("S", leaf))) ==
          "3:42: unused-parameter: nothing in the tree \"S\" uses \"p\"\n");
}

TEST_CASE("unused: a param of a tree that a machine runs") {
    Texts texts;
    texts.add("t.xml", "<root BTCPP_format='4'>" + tree("T", "<Echo in='{speed}'/>") + "</root>");
    const std::string head = "<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0' "
                             "datamodel='script'><state id='a'>\n<invoke type='tree' src='t.xml'>";
    CHECK(complaints(head + "<param name='sped' expr='1'/></invoke></state></scxml>",
                     {.reader = &texts}) ==
          "2:46: unused-parameter: nothing in the tree uses \"sped\"; did you mean \"speed\"?\n");
    CHECK(complaints(head + "<param name='speed' expr='1'/></invoke></state></scxml>",
                     {.reader = &texts}) == "");
}

}  // namespace trellis::test
