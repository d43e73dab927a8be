// Every kind of finding that checking a document against the grammar makes, with its place and
// exact text. Rendered with carets, over files of both spellings: faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/check.h"

#include "load/xml.h"
#include "support/example_registry.h"

#include <doctest/doctest.h>

using namespace trellis;

namespace {

/// The findings about an XML text: "line:column message [id]" a line, "~" before what is not
/// structural, "?" before warnings.
std::string findings(std::string_view text, const Grammar& grammar) {
    Diagnostics diagnostics;
    const std::uint32_t file = diagnostics.add_file("", text);
    if (const auto document = read_xml(text, file, diagnostics)) {
        check(*document, grammar, diagnostics);
    }
    diagnostics.sort();
    std::string out;
    for (const Diagnostic& d : diagnostics.all()) {
        if (d.severity == Diagnostic::Severity::warning) {
            out += "? ";
        } else if (!d.structural) {
            out += "~ ";
        }
        out += std::to_string(d.where.line) + ":" + std::to_string(d.where.column) + " " +
               d.message + " [" + d.id + "]\n";
    }
    return out;
}

std::string tree(std::string_view node) {
    Registry registry;
    test::register_examples(registry);
    return findings("<root BTCPP_format='4'><BehaviorTree ID='A'>\n" + std::string(node) +
                        "\n</BehaviorTree></root>",
                    tree_grammar(registry));
}

std::string machine(std::string_view content) {
    return findings("<scxml xmlns='http://www.w3.org/2005/07/scxml' version='1.0'>\n" +
                        std::string(content) + "\n</scxml>",
                    machine_grammar());
}

}  // namespace

TEST_CASE("check: a good tree and a good machine have no findings") {
    CHECK(tree("<Sequence><MoveForward speed='{v}' _skipIf='x'/><SubTree ID='B' any='thing'/>"
               "<Action ID='Say' message='hi'/></Sequence>") == "");
    CHECK(machine("<state id='a'><transition event='tick' target='a'><log expr='1'/></transition>"
                  "</state>") == "");
}

TEST_CASE("check: unknown nodes and attributes come with a suggestion") {
    CHECK(tree("<Sequnce><MoveForward sped='1'/></Sequnce>") ==
          "2:2 unknown node \"Sequnce\"; did you mean \"Sequence\"? [unknown-node]\n"
          "2:23 MoveForward has no attribute \"sped\"; did you mean \"speed\"? "
          "[unknown-attribute]\n");
    CHECK(tree("<MoveForward sped='1'/>") == "2:14 MoveForward has no attribute \"sped\"; did you "
                                             "mean \"speed\"? [unknown-attribute]\n");
    CHECK(tree("<MoveForward _skipif='x'/>") ==
          "? 2:14 \"_skipif\" is ignored; did you mean \"_skipIf\"? [ignored-attribute]\n");
}

TEST_CASE("check: values have types, units and ranges") {
    CHECK(tree("<MoveForward speed='fast'/>") == "2:21 \"speed\": expected a number in m/s or a "
                                                 "{key}, found \"fast\" [bad-value]\n");
    CHECK(tree("<Measure distance='3' sensor='FRNT'/>") ==
          "2:20 \"distance\": expected a {key}, found \"3\" [bad-value]\n"
          "2:31 \"sensor\": expected an integer or a {key}, found \"FRNT\"; did you mean "
          "\"FRONT\"? [bad-value]\n");
    CHECK(tree("<Say message='x' times='9999999999'/>") ==
          "~ 2:25 \"times\": 9999999999 does not fit 32 bits [out-of-range]\n");
}

TEST_CASE("check: numbers of children, with the place of the first that is too many") {
    CHECK(tree("<Sequence/>") == "2:2 Sequence takes at least 1 child, found 0 [child-count]\n");
    CHECK(tree("<Repeat num_cycles='2'><Bumped/><Bumped/></Repeat>") ==
          "2:34 Repeat takes 1 child, found 2 [child-count]\n");
    CHECK(tree("<Bumped><Bumped/></Bumped>") ==
          "2:10 Bumped takes no children, found 1 [child-count]\n");
}

TEST_CASE("check: what must be given") {
    CHECK(tree("<Repeat><Say/></Repeat>") ==
          "2:2 Repeat needs the attribute \"num_cycles\", an integer or a {key} "
          "[missing-attribute]\n"
          "2:10 Say needs the attribute \"message\" [missing-attribute]\n");
    CHECK(machine("<state><transition/></state><final><onentry><assign location='x'/></onentry>"
                  "</final>") == "~ 2:9 <transition> needs event, cond or target [missing-part]\n"
                                 "~ 2:46 <assign> needs expr or text [missing-part]\n");
}

TEST_CASE("check: elements at the wrong place, text where none may be") {
    CHECK(tree("<BehaviorTree ID='B'><Bumped/></BehaviorTree>") ==
          "2:2 BehaviorTree may not stand directly inside BehaviorTree; expected a node "
          "[misplaced-element]\n");
    CHECK(tree("<Sequence>and<Bumped/></Sequence>") ==
          "2:11 Sequence takes no text, found \"and\" [unexpected-text]\n");
    CHECK(machine("<state><data id='x'/></state>") ==
          "2:9 <data> may not stand directly inside <state>; expected onentry, onexit, transition, "
          "initial, state, parallel, final, history, datamodel or invoke [misplaced-element]\n");
}

TEST_CASE("check: the long form is checked as the node it names") {
    CHECK(tree("<Action ID='Sai'/>") ==
          "~ 2:13 unknown node \"Sai\"; did you mean \"Say\"? [unknown-node]\n");
    CHECK(tree("<Action ID='Say' mesage='x' times='x'/>") ==
          "~ 2:2 Say needs the attribute \"message\" [missing-attribute]\n"
          "~ 2:18 Say has no attribute \"mesage\"; did you mean \"message\"? [unknown-attribute]\n"
          "~ 2:36 \"times\": expected an integer or a {key}, found \"x\" [bad-value]\n");
    CHECK(tree("<Control ID='Inverter'><Bumped/><Bumped/></Control>") ==
          "~ 2:34 Inverter takes 1 child, found 2 [child-count]\n");
}

TEST_CASE("check: machines inside <content> are checked as machines") {
    CHECK(machine("<state><invoke><content><scxml version='1.0'><stat/></scxml></content></invoke>"
                  "</state>") ==
          "~ 2:26 <scxml> needs <state>, <parallel> or <final> [missing-part]\n"
          "2:47 unknown element \"stat\"; did you mean \"state\"? [unknown-element]\n");
    CHECK(machine("<state><onentry><send event='e'><content><stat/></content></send></onentry>"
                  "</state>")
              .empty());
}

TEST_CASE("check: parts that exclude each other, branches after else") {
    CHECK(machine("<state initial='a'><initial><transition target='a'/></initial>"
                  "<state id='a'/></state>") ==
          "~ 2:21 <state> takes only one of initial and <initial> [conflicting-parts]\n");
    CHECK(machine("<final><onexit><if cond='x'><else/><elseif cond='y'/></if></onexit></final>") ==
          "~ 2:37 <elseif> may not stand after <else> [branch-after-else]\n");
}

TEST_CASE("check: names of other namespaces are passed over in machines") {
    CHECK(machine("<state xmlns:qt='urn:qt' qt:x='1'><qt:editorinfo a='b'><c/></qt:editorinfo>"
                  "<initial><qt:info/><transition target='b'/></initial></state>") == "");
    CHECK(
        machine("<state xmlns:s='http://www.w3.org/2005/07/scxml' s:id='a'><s:onentry/></state>") ==
        "2:50 <state> has no attribute \"s:id\"; it has id and initial [unknown-attribute]\n"
        "~ 2:60 expected <onentry> without a prefix, found <s:onentry> [prefixed-element]\n");
    CHECK(machine("<state><onentry xmlns=''/></state>") ==
          "2:9 <onentry> is not in the namespace http://www.w3.org/2005/07/scxml "
          "[wrong-namespace]\n");
}

TEST_CASE("check: the root decides what the file can be") {
    Registry registry;
    CHECK(findings("<rooot/>", tree_grammar(registry)) ==
          "1:2 expected <root> as the outermost element, found <rooot> [wrong-root]\n");
    CHECK(findings("<scxml version='1.0'><final/></scxml>", machine_grammar()) ==
          "1:2 expected xmlns=\"http://www.w3.org/2005/07/scxml\" [wrong-namespace]\n");
    CHECK(findings("<root/>", tree_grammar(registry)) ==
          "? 1:2 BTCPP_format is missing; the file is read as format 4 [format-version]\n");
    CHECK(findings("<root xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' "
                   "xsi:noNamespaceSchemaLocation='t.xsd' "
                   "BTCPP_format='4'/>",
                   tree_grammar(registry)) == "");
}
