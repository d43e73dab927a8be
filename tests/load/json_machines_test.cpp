// Machines in JSON: every form, the way from XML and back, the W3C pairs, what a mistake is told.
// SPDX-License-Identifier: MIT
#include "load/json.h"
#include "load/json_documents.h"
#include "load/random_document.h"
#include "load/xml.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using namespace trellis;
using namespace trellis::test;

namespace {

Document from_json(std::string_view text) {
    return test::from_json(text, FileKind::machine);
}

std::string faults(std::string_view text) {
    return json_faults(text, FileKind::machine);
}

Document machine(std::string_view inside) {
    return from_xml("<scxml xmlns='http://www.w3.org/2005/07/scxml'>" + std::string(inside) +
                    "</scxml>");
}

Document without_docs(Document d) {
    for (Element& e : d.elements) {
        e.doc = {};
    }
    return d;
}

}  // namespace

TEST_CASE("json machines: every form reads as the XML that says the same") {
    const Document json = from_json(R"json({
  "doc": "all of it", "name": "m", "initial": ["a", "b"], "version": 1.0,
  "data": [{"id": "x", "expr": "1"}, {"id": "y", "text": "[1, 2]"},
           {"id": "z", "xml": "<book title='t'><p/></book>"}],
  "scripts": [{"text": "x = 2"}],
  "states": [
    {"id": "a",
     "onentry": [[{"raise": "e"}, {"log": "x"}], [{"script": "y = 1"}, {"cancel": "s"}]],
     "onexit": [{"assign": {"location": "x", "expr": "2"}}],
     "initialTransition": {"target": "a1", "do": [{"raise": {"event": "f"}}]},
     "invoke": [{"type": "scxml", "params": [{"name": "p", "expr": "1"}],
                 "content": {"scxml": {"states": [{"kind": "final", "id": "sub"}]}},
                 "finalize": [{"assign": {"location": "x", "expr": "_event.data"}}]}],
     "transitions": [{"event": ["e", "f.*"], "target": "b", "cond": "x > 1", "do": [
       {"if": [{"cond": "x", "do": [{"raise": {"event": "1"}}]}, {"cond": "y", "do": []},
               {"do": [{"foreach": {"array": "l", "item": "i", "do": [{"log": {"expr": "i"}}]}}]}]},
       {"send": {"event": "s", "content": "hello"}},
       {"x:move": {"{urn:x}speed": "1"}}]}],
     "states": [{"kind": "history", "id": "h", "type": "deep"}, {"kind": "parallel", "id": "a1"}],
     "xmlns:x": "urn:x"},
    {"kind": "final", "id": "b", "donedata": {"params": [{"name": "r", "location": "x"}]}}]
})json");
    const Document xml = from_xml(R"xml(<!-- all of it -->
<scxml xmlns="http://www.w3.org/2005/07/scxml" name="m" initial="a b" version="1.0">
  <datamodel>
    <data id="x" expr="1"/>
    <data id="y">[1, 2]</data>
    <data id="z"><book title="t"><p/></book></data>
  </datamodel>
  <script>x = 2</script>
  <state id="a" xmlns:x="urn:x">
    <onentry><raise event="e"/><log expr="x"/></onentry>
    <onentry><script>y = 1</script><cancel sendid="s"/></onentry>
    <onexit><assign location="x" expr="2"/></onexit>
    <initial><transition target="a1"><raise event="f"/></transition></initial>
    <invoke type="scxml">
      <param name="p" expr="1"/>
      <content><scxml><final id="sub"/></scxml></content>
      <finalize><assign location="x" expr="_event.data"/></finalize>
    </invoke>
    <transition event="e f.*" target="b" cond="x > 1">
      <if cond="x"><raise event="1"/><elseif cond="y"/><else/>
        <foreach array="l" item="i"><log expr="i"/></foreach></if>
      <send event="s"><content>hello</content></send>
      <x:move x:speed="1"/>
    </transition>
    <history id="h" type="deep"/>
    <parallel id="a1"/>
  </state>
  <final id="b"><donedata><param name="r" location="x"/></donedata></final>
</scxml>)xml");
    CHECK(write_xml(json) == write_xml(xml));
    CHECK(same_content(json, xml));
    CHECK(same_content(from_json(write_json(xml, FileKind::machine)), xml));
    CHECK(same_content(canonical(xml, FileKind::machine), xml));
}

TEST_CASE("json machines: a machine is written in natural keys") {
    const Document d = machine("<state id='a'><!-- why --><transition event='e' target='b'>"
                               "<raise event='f'/></transition></state><final id='b'/>");
    CHECK(write_json(d, FileKind::machine) == R"json({
  "states": [
    {
      "id": "a",
      "transitions": [
        { "doc": "why", "event": "e", "target": "b", "do": [{ "raise": { "event": "f" } }] }
      ]
    },
    { "kind": "final", "id": "b" }
  ]
}
)json");
}

TEST_CASE("json machines: the kind of a JSON file is told by its members") {
    const auto kind = [](std::string_view text) {
        Diagnostics diagnostics;
        return json_kind(parse_json(text, 0, diagnostics).value());
    };
    CHECK(kind("{\"states\": []}") == FileKind::machine);
    CHECK(kind("{\"initial\": \"a\"}") == FileKind::machine);
    CHECK(kind("{\"BTCPP_format\": 4}") == FileKind::tree);
    CHECK_FALSE(kind("{}"));
    CHECK_FALSE(kind("[]"));
}

TEST_CASE("json machines: the canonical form orders children by kind and moves docs inside") {
    const Document d = from_xml(
        "<scxml a='1' xmlns='http://www.w3.org/2005/07/scxml'><state id='s'/><!--d--><datamodel>"
        "<!--x--><data id='x'/></datamodel><transition/><datamodel><data id='y'/></datamodel>"
        "<!--e--><onentry><if cond='1'/></onentry><onexit id='odd'/><x:y/></scxml>");
    CHECK(write_xml(canonical(d, FileKind::machine)) == R"xml(<?xml version="1.0" encoding="UTF-8"?>
<scxml xmlns="http://www.w3.org/2005/07/scxml" a="1">
  <datamodel>
    <!-- d
x -->
    <data id="x"/>
    <data id="y"/>
  </datamodel>
  <onentry>
    <!-- e -->
    <if cond="1"/>
  </onentry>
  <transition/>
  <state id="s"/>
  <onexit id="odd"/>
  <x:y/>
</scxml>
)xml");
}

TEST_CASE("json machines: attributes of other namespaces are written with their namespace") {
    const Document d = machine("<state xmlns:p='urn:p' xmlns:q='urn:p' q:a='1' p:b='2' r:c='3' "
                               "xml:lang='en'/>");
    const std::string json = write_json(d, FileKind::machine);
    // p is not the innermost prefix for urn:p, and r is not declared: they stay as they are
    for (const std::string_view member :
         {"\"{urn:p}a\": \"1\"", "\"p:b\": \"2\"", "\"r:c\": \"3\"", "\"xml:lang\""}) {
        CHECK_MESSAGE(json.find(member) != std::string::npos, json);
    }
    CHECK(same_content(from_json(json), d));
    CHECK(same_content(
        from_json(
            "{\"states\": [{\"{urn:n}a\": \"1\", \"{urn:n}b\": \"2\", \"{urn:m}c\": \"3\"}]}"),
        machine("<state xmlns:ns1='urn:n' ns1:a='1' ns1:b='2' xmlns:ns2='urn:m' ns2:c='3'/>")));
}

TEST_CASE("json machines: random machines in canonical form survive the way through JSON") {
    test::Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const Document d = test::random_machine(random);
        const std::string text = write_json(d, FileKind::machine);
        const Document back = from_json(text);
        REQUIRE_MESSAGE(same_content(back, d), write_xml(d), write_xml(back), text);
        REQUIRE(write_json(back, FileKind::machine) == text);
    }
}

TEST_CASE("json machines: any document whose root is <scxml> has one canonical form") {
    test::Random random(10);
    for (int i = 0; i < 1000; ++i) {
        Document d = test::random_document(random);
        d.elements[0].name = d.add_string("scxml");
        const Document back = from_json(write_json(d, FileKind::machine));
        REQUIRE(back.elements.size() == d.elements.size());
        REQUIRE(same_content(back, canonical(d, FileKind::machine)));
        REQUIRE(same_content(back, canonical(back, FileKind::machine)));
    }
}

TEST_CASE("json machines: the W3C tests say the same in both spellings") {
    const auto folder = std::filesystem::path(TRELLIS_CONFORMANCE_DIR) / "machines";
    if (!std::filesystem::exists(folder)) {
        MESSAGE("skipped: no ", folder.string());
        return;
    }
    std::size_t pairs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::filesystem::path json = entry.path();
        if (json.extension() != ".scxml" ||
            !std::filesystem::exists(json.replace_extension(".json"))) {
            continue;
        }
        // the recorded JSON keeps only the first comment, in one line
        const Document a = canonical(from_xml(test::read_file(entry.path())), FileKind::machine);
        const Document b = from_json(test::read_file(json));
        CHECK_MESSAGE(write_xml(without_docs(a)) == write_xml(without_docs(b)), json.string());
        CHECK(same_content(without_docs(a), without_docs(b)));
        CHECK(same_content(from_json(write_json(a, FileKind::machine)), a));
        ++pairs;
    }
    CHECK(pairs == 138);
}

TEST_CASE("json machines: faults of the mapping are structural and have places") {
    CHECK(faults("[]") == "1:1: error: the file must be an object, found an array [json-type]\n");
    CHECK(faults("{\"states\": [{\"kind\": \"finale\"}]}") ==
          "1:23: error: \"kind\" must be \"state\", \"parallel\", \"final\" or \"history\", found "
          "\"finale\"; did you mean \"final\"? [json-type]\n");
    CHECK(
        faults("{\"states\": [{\"transition\": []}]}") ==
        "1:28: error: \"transition\" cannot be an array in <state>; did you mean \"transitions\"? "
        "[json-type]\n");
    CHECK(faults("{\"states\": [{\"do\": []}]}") ==
          "1:15: error: \"do\" has no meaning in <state> [json-member]\n");
    CHECK(
        faults("{\"states\": [{\"onentry\": [[{\"raise\": {}, \"log\": {}}]]}]}") ==
        "1:27: error: an action has one member, such as {\"raise\": {\"event\": \"done\"}}, found "
        "2 [json-member]\n");
    CHECK(faults("{\"states\": [{\"onentry\": [[{\"send\": \"x\"}, {\"raise\": 1}, 5]]}]}") ==
          "1:37: error: \"send\" must be an object, found text [json-type]\n"
          "1:52: error: \"raise\" must be an object, found a number [json-type]\n"
          "1:56: error: each value of \"onentry\" must be an object, found a number [json-type]\n");
    CHECK(faults("{\"states\": [{\"onentry\": [[{\"if\": []}]]}]}") ==
          "1:34: error: \"if\" needs at least one branch, found none [json-type]\n");
    CHECK(faults("{\"initial\": [1]}") ==
          "1:14: error: each value of \"initial\" must be text, found a number [json-type]\n");
    CHECK(faults("{\"states\": [{\"xml\": \"<a>\"}]}") ==
          "1:22: error: \"xml\" must be XML: expected </a> for the <a> of line 1, found </xml> "
          "[json-type]\n");
    CHECK(faults("{\"states\": [{\"xml\": \"a\"}]}") ==
          "1:22: error: \"xml\" must be elements; text stands in \"text\" [json-type]\n");
    CHECK(faults("{\"{urn:x}a\": 1, \"xmlns:p\": \"urn:x\", \"p:a\": 2}") ==
          "1:38: error: the attribute \"p:a\" is given twice [json-member]\n");
}

TEST_CASE("json machines: mutated texts are read or refused, never anything else") {
    test::Random random(8);
    const std::string text = write_json(test::random_machine(random), FileKind::machine);
    for (int i = 0; i < 20000; ++i) {
        const std::string bad = test::mutated(text, random);
        Diagnostics diagnostics;
        const auto d = read_json(bad, 0, FileKind::machine, diagnostics);
        REQUIRE(d.has_value() == diagnostics.ok());
        if (d) { REQUIRE(same_content(from_json(write_json(*d, FileKind::machine)), *d)); }
    }
}
