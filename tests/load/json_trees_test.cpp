// Tree files in JSON: every form, the way from XML and back, what a mistake is told.
// SPDX-License-Identifier: MIT
#include "load/json.h"
#include "load/json_documents.h"
#include "load/random_document.h"
#include "load/xml.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

Document from_json(std::string_view text) {
    return test::from_json(text, FileKind::tree);
}

std::string faults(std::string_view text) {
    return json_faults(text, FileKind::tree);
}

/// Name, attributes and text of each element, sorted: what no change of order alters.
std::vector<std::string> inventory(const Document& d) {
    std::vector<std::string> out;
    for (std::uint32_t e = 0; e < d.elements.size(); ++e) {
        std::string one = std::string(d.name({e})) + "\n" + std::string(d.text({e}));
        for (const Attribute& a : d.attributes_of({e})) {
            one += "\n" + std::string(d.string(a.name)) + "=" + std::string(d.string(a.value));
        }
        out.push_back(one);
    }
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

TEST_CASE("json trees: the example of the format reads as the XML that says the same") {
    const std::string_view json = R"json({ "BTCPP_format": 4, "main_tree_to_execute": "Roomba",
  "doc": "the lab's tree", "$schema": "trees.json",
  "include": ["escape.json", {"path": "nav.xml", "ros_pkg": "nav2"}],
  "trees": [
    { "ID": "Roomba", "root":
      { "type": "Fallback", "name": "root", "children": [
        { "type": "Sequence", "name": "clean", "children": [
          { "type": "MoveForward", "speed": 0.5, "duration": 3.0 },
          { "type": "MoveInSpiral", "_skipIf": "@docked", "speed": "{v}" } ] },
        { "type": "SubTree", "ID": "Escape", "_autoremap": true } ] } } ],
  "models": [ { "kind": "Action", "ID": "MoveForward", "ports": [
      { "direction": "input", "name": "speed", "type": "double", "default": "0.5", "description": "m/s" } ] } ] })json";
    const Document xml = from_xml(R"xml(<!-- the lab's tree -->
<root BTCPP_format="4" main_tree_to_execute="Roomba">
  <include path="escape.json"/>
  <include path="nav.xml" ros_pkg="nav2"/>
  <BehaviorTree ID="Roomba">
    <Fallback name="root">
      <Sequence name="clean">
        <MoveForward speed="0.5" duration="3.0"/>
        <MoveInSpiral _skipIf="@docked" speed="{v}"/>
      </Sequence>
      <SubTree ID="Escape" _autoremap="true"/>
    </Fallback>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="MoveForward">
      <input_port name="speed" type="double" default="0.5">m/s</input_port>
    </Action>
  </TreeNodesModel>
</root>)xml");
    const Document read = from_json(json);
    CHECK(same_content(read, xml));
    CHECK(read.spelling == Document::Spelling::json);
    CHECK(same_content(from_json(write_json(xml, FileKind::tree)), xml));
}

TEST_CASE("json trees: a document is written one node per line where it fits") {
    const Document xml = from_xml(
        "<root BTCPP_format='4'><include path='a.xml'/><BehaviorTree ID='Main'><!-- go -->"
        "<Sequence><Script code='a := 1'/><MoveForward name='forward' speed='0.5' duration='3.0' "
        "_skipIf='@docked || @charging'/></Sequence></BehaviorTree><TreeNodesModel><Action ID='M'/>"
        "</TreeNodesModel></root>");
    CHECK(write_json(xml, FileKind::tree) == R"json({
  "BTCPP_format": 4,
  "include": ["a.xml"],
  "trees": [
    {
      "ID": "Main",
      "root": {
        "type": "Sequence",
        "doc": "go",
        "children": [
          { "type": "Script", "code": "a := 1" },
          {
            "type": "MoveForward",
            "name": "forward",
            "speed": 0.5,
            "duration": 3.0,
            "_skipIf": "@docked || @charging"
          }
        ]
      }
    }
  ],
  "models": [{ "kind": "Action", "ID": "M" }]
}
)json");
}

TEST_CASE("json trees: values and names have their places") {
    const Document d =
        from_json("{\"trees\":[\n {\"root\":{\"type\":\"A\", \"x\":\"é\",\n\"y\":1.50}}]}");
    CHECK(d.at({2}).where == Where{0, 2, 19});
    REQUIRE(d.attributes.size() == 2);
    CHECK(d.attributes[0].where == Where{0, 2, 24});
    CHECK(d.attributes[0].value_where == Where{0, 2, 28});
    CHECK_FALSE(d.attributes[0].bare);
    CHECK(d.attributes[1].value_where == Where{0, 3, 5});
    CHECK(d.attributes[1].bare);
    CHECK(d.value({2}, "y") == "1.50");
}

TEST_CASE("json trees: only the one spelling of a number is written bare") {
    const auto written = [](std::string_view value) {
        const Document d = from_xml("<root><BehaviorTree><A x='" + std::string(value) +
                                    "'/></BehaviorTree></root>");
        const std::string out = write_json(d, FileKind::tree);
        const std::size_t begin = out.find("\"x\": ") + 5;
        return out.substr(begin, out.find(" }", begin) - begin);
    };
    for (const std::string_view bare : {"0", "7", "-3", "0.5", "-0.25", "3.0", "0.0001",
                                        "1234.5678", "123456789012345", "true", "false"}) {
        CHECK(written(bare) == bare);
    }
    for (const std::string_view text :
         {"", "007", "-0", "-0.0", "1.", ".5", "+1", "1.50", "1e3", "0.00001", "1234567890123456",
          "0.1234567890123456", "True", "null", " 1", "0x10", "NaN", "--1"}) {
        CHECK(written(text) == "\"" + std::string(text) + "\"");
    }
}

TEST_CASE("json trees: attributes that are called like members go into ports, in order") {
    const Document d = from_xml("<root><BehaviorTree><A a='1' type='2' b='3' doc='5' "
                                "ports='6'/></BehaviorTree></root>");
    const std::string out = write_json(d, FileKind::tree);
    CHECK(out.find(
              R"({ "type": "A", "a": 1, "ports": { "type": 2, "b": 3, "doc": 5, "ports": 6 } })") !=
          std::string::npos);
    CHECK(same_content(from_json(out), d));
}

TEST_CASE("json trees: what is not the dialect's survives") {
    const std::string_view xml =
        "<root>top<BehaviorTree "
        "ID='A'/><BehaviorTree>text<A/><B>b</B></BehaviorTree><TreeNodesModel>"
        "<Action ID='X'><MetadataFields><Metadata a='b'/></MetadataFields><input_port name='p'/>"
        "</Action><Action ID='Y' kind='z'/></TreeNodesModel><TreeNodesModel a='1'/>"
        "<!-- m --><Groot:meta><x/>y</Groot:meta></root>";
    const Document d = from_xml(xml);
    CHECK(same_content(from_json(write_json(d, FileKind::tree)), canonical(d, FileKind::tree)));
    CHECK(same_content(d, canonical(d, FileKind::tree)));
}

TEST_CASE("json trees: the canonical form orders the root's children by kind and loses nothing") {
    const Document d = from_xml("<root><!--models--><TreeNodesModel><!--a--><A/></TreeNodesModel>"
                                "<extra/><BehaviorTree ID='1'/><include path='p'/>"
                                "<BehaviorTree ID='2'/></root>");
    CHECK(write_xml(canonical(d, FileKind::tree)) == R"xml(<?xml version="1.0" encoding="UTF-8"?>
<root>
  <include path="p"/>
  <BehaviorTree ID="1"/>
  <BehaviorTree ID="2"/>
  <TreeNodesModel>
    <!-- models
a -->
    <A/>
  </TreeNodesModel>
  <extra/>
</root>
)xml");
}

TEST_CASE("json trees: random tree files in canonical form survive the way through JSON") {
    test::Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const Document d = test::random_tree_file(random);
        const std::string text = write_json(d, FileKind::tree);
        REQUIRE_MESSAGE(same_content(from_json(text), d), write_xml(d), text);
        REQUIRE(write_json(from_json(text), FileKind::tree) == text);
    }
}

TEST_CASE("json trees: any document whose root is <root> keeps all its elements through JSON") {
    test::Random random(9);
    for (int i = 0; i < 1000; ++i) {
        Document d = test::random_document(random);
        d.elements[0].name = d.add_string("root");
        const Document back = from_json(write_json(d, FileKind::tree));
        REQUIRE_MESSAGE(inventory(back) == inventory(d), write_xml(d));
        REQUIRE(same_content(back, canonical(d, FileKind::tree)));
        REQUIRE(same_content(back, canonical(back, FileKind::tree)));
    }
}

TEST_CASE("json trees: the conformance trees keep all their elements through JSON") {
    const std::filesystem::path folder = std::filesystem::path(TRELLIS_CONFORMANCE_DIR) / "trees";
    if (!std::filesystem::exists(folder)) {
        MESSAGE("skipped: no ", folder.string());
        return;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".xml") { continue; }
        Diagnostics diagnostics;
        const auto d = read_xml(test::read_file(entry.path()), 0, diagnostics);
        if (!d || file_kind(*d) != FileKind::tree) { continue; }
        const Document back = from_json(write_json(*d, FileKind::tree));
        CHECK_MESSAGE(inventory(back) == inventory(*d), entry.path().string());
        CHECK(same_content(canonical(back, FileKind::tree), back));
    }
}

TEST_CASE("json trees: faults of the mapping are structural and have places") {
    CHECK(faults("[]") == "1:1: error: the file must be an object, found an array [json-type]\n");
    CHECK(faults("{\"trees\": {}}") ==
          "1:11: error: \"trees\" must be an array, found an object [json-type]\n");
    CHECK(faults("{\"trees\": [5, {\"root\": []}]}") ==
          "1:12: error: each value of \"trees\" must be an object, found a number [json-type]\n"
          "1:24: error: \"root\" must be an object, found an array [json-type]\n");
    CHECK(faults("{\"trees\": [{\"root\": {\"name\": \"x\"}}]}") ==
          "1:14: error: a node needs a \"type\", such as {\"type\": \"Sequence\"} [json-member]\n");
    CHECK(faults("{\"trees\": [{\"root\": {\"type\": 1}}]}") ==
          "1:30: error: \"type\" must be text, found a number [json-type]\n");
    CHECK(faults("{\"trees\": [{\"root\": {\"type\": \"A\", \"children\": 5}}]}") ==
          "1:47: error: \"children\" must be an array, found a number [json-type]\n");
    CHECK(faults("{\"trees\": [{\"root\": {\"type\": \"A\", \"x\": [1]}}]}") ==
          "1:40: error: \"x\" must be text, a number, true or false, found an array [json-type]\n");
    CHECK(faults("{\"trees\": [{\"root\": {\"type\": \"two words\"}}]}") ==
          "1:31: error: \"two words\" is no name of an element [bad-name]\n");
    CHECK(faults("{\"trees\": [{\"root\": {\"type\": \"A\", \"2\": 1}}]}") ==
          "1:36: error: \"2\" is no name of an attribute [bad-name]\n");
    CHECK(faults("{\"x\": 1, \"ports\": {\"x\": 2}}") ==
          "1:21: error: the attribute \"x\" is given twice [json-member]\n");
    CHECK(faults("{\"models\": [{\"ID\": \"A\"}]}") ==
          "1:13: error: a model needs a \"kind\": Action, Condition, Control, Decorator or SubTree "
          "[json-member]\n");
    CHECK(faults(
              "{\"models\": [{\"kind\": \"Action\", \"ports\": [{}, {\"direction\": \"in\"}]}]}") ==
          "1:42: error: a port needs a \"direction\": input, output or inout [json-member]\n"
          "1:61: error: \"direction\" must be \"input\", \"output\" or \"inout\" [json-type]\n");
    CHECK(faults("{\"doc\": 1}") ==
          "1:9: error: \"doc\" must be text, found a number [json-type]\n");
    Diagnostics diagnostics;
    (void)read_json("{\"trees\": 1}", 0, FileKind::tree, diagnostics);
    CHECK(diagnostics.structural());
}

TEST_CASE("json trees: nesting beyond the limit is an error") {
    std::string text = "{\"trees\": [{\"root\": ";
    for (int i = 0; i < 300; ++i) {
        text += "{\"type\": \"A\", \"children\": [";
    }
    for (int i = 0; i < 300; ++i) {
        text += "]}";
    }
    CHECK(faults(text + "}]}").find("elements are nested more than 256 deep [too-large]") !=
          std::string::npos);
}
