// Literals of JSON: what they give ports, parameters and entries, and every message.
// SPDX-License-Identifier: MIT
#include "load/json_literal.h"

#include "core/leaf.h"
#include "exec/step.h"
#include "load/json.h"
#include "load/load.h"
#include "load/xml.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

namespace trellis::test {
namespace {

/// A host that remembers the value a leaf was given last.
struct Seen {
    std::string value;
};

/// Takes a value of any type.
struct Take {
    const Value* goal = nullptr;
    bool tick(Seen& seen, const Tick&) {
        seen.value = goal != nullptr ? print(*goal) : "nothing";
        return goal != nullptr;
    }
};

/// Takes values of other types.
struct Typed {
    std::string_view text;
    double number = 0.0;
    bool tick(Seen& seen, const Tick&) {
        seen.value = text;
        return number == 0.0;
    }
};

const Registry& registry() {
    static const Registry& made = []() -> const Registry& {
        static Registry registry;
        registry.add<Take, Seen>("Take", "takes a value of any type").input("goal", &Take::goal);
        registry.add<Typed, Seen>("Typed", "takes values of other types")
            .input("text", &Typed::text)
            .input("number", &Typed::number);
        return registry;
    }();
    return made;
}

struct Loaded {
    Diagnostics diagnostics;
    std::optional<Program> program;
};

Loaded loaded(const std::string& nodes, const std::string& other = {}) {
    Loaded out;
    out.program =
        load({"tree.xml", "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n"
                          "<BehaviorTree ID=\"Main\"><Sequence>\n" +
                              nodes + "\n</Sequence></BehaviorTree>\n" + other + "</root>\n"},
             registry(), out.diagnostics);
    return out;
}

/// What the last Take of some nodes was given.
std::string given(const std::string& nodes, const std::string& other = {}) {
    const Loaded tree = loaded(nodes, other);
    if (!tree.program) { return tree.diagnostics.render(); }
    Seen seen;
    State state = fresh_state(*tree.program);
    if (step(*tree.program, state, seen) != Status::success) { return "no success"; }
    return seen.value;
}

std::string taken(const std::string& literal) {
    return given("<Take goal='" + literal + "'/>");
}

/// The first finding of a literal: "line:column id: message".
std::string fault(const std::string& literal) {
    const Loaded tree = loaded("<Take goal='" + literal + "'/>");
    REQUIRE(tree.diagnostics.all().size() == 1);
    const Diagnostic& d = tree.diagnostics.all()[0];
    return std::to_string(d.where.line) + ':' + std::to_string(d.where.column) + ' ' + d.id + ": " +
           d.message;
}

}  // namespace

TEST_CASE("json literals: a port of any type takes every kind of value") {
    CHECK(taken(R"(json:{"x": 1, "y": [2.5, true, null, "a"]})") ==
          R"({"x": 1, "y": [2.5, true, null, "a"]})");
    CHECK(taken("json:[]") == "[]");
    CHECK(taken("json:3") == "3");
    CHECK(taken("json:-3.0") == "-3.0");
    CHECK(taken("json:9223372036854775807") == "9223372036854775807");
    CHECK(taken("json:9223372036854775808") == "9.223372036854776e+18");
    CHECK(taken("json: \"a\\u00e9&lt;\" ") == "\"a\xC3\xA9<\"");
    CHECK(taken("jason:3") == "\"jason:3\"");
}

TEST_CASE("json literals: as parameters of subtrees and values of SetBlackboard they are entries") {
    const std::string sub = "<BehaviorTree ID='Sub'><Take goal='{g}'/></BehaviorTree>\n";
    CHECK(given("<SubTree ID='Sub' g='json:[1, {\"a\": 2}]'/>", sub) == R"([1, {"a": 2}])");
    CHECK(given("<SetBlackboard value='json:{\"a\": [1]}' output_key='g'/><Take goal='{g}'/>") ==
          R"({"a": [1]})");
    CHECK(given("<SetBlackboard value='json:{\"a\": [1]}' output_key='g'/>"
                "<Script code='h := g.a[0] + 1'/><Take goal='{h}'/>") == "2.0");
    CHECK(given("<SetBlackboard value='text' output_key='g'/>"
                "<SetBlackboard value='json:[1]' output_key='h'/>"
                "<SetBlackboard value='{h}' output_key='k'/><Take goal='{k}'/>") == "[1]");
}

TEST_CASE("json literals: other ports read the text, as BehaviorTree.CPP does") {
    CHECK(given("<Typed text='json:[1]'/>") == "json:[1]");
    const Loaded number = loaded("<Typed number='json:1'/>");
    REQUIRE(number.diagnostics.all().size() == 1);
    CHECK(number.diagnostics.all()[0].message ==
          "\"number\": expected a number or a {key}, found \"json:1\"");
}

TEST_CASE("json literals: a fault has its place inside the attribute") {
    CHECK(fault("json:{\"a\": }") == "3:24 json-syntax: expected a value, found \"}\"");
    CHECK(fault("json:") == "3:13 json-syntax: there is no value after json:");
    CHECK(fault("json:[1") ==
          "3:20 json-syntax: expected \",\" or \"]\", found the end of the literal");
    CHECK(fault("json:[1,\n 2,]") == "4:3 json-syntax: no comma may stand before \"]\"");
    CHECK(fault("json:{\"&lt;\": 1, x}") ==
          "3:30 json-syntax: expected a member's name in double quotes, found \"x\"");
    CHECK(fault("json:{\"a\": 1, \"a\": 2}") ==
          "3:28 duplicate-member: the member \"a\" is given twice, first in line 1");
    CHECK(fault("json:[1e999]") == "3:19 json-syntax: the number is too large");
    CHECK(fault("json:" + std::string(65, '[') + std::string(65, ']')) ==
          "3:82 too-large: values are nested more than 64 deep");
    CHECK(taken("json:" + std::string(64, '[') + std::string(64, ']')) ==
          std::string(64, '[') + std::string(64, ']'));
}

TEST_CASE("json literals: both spellings of a file keep them, and mean the same") {
    Diagnostics none;
    const std::string xml = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">"
                            "<Take goal='json:{\"a\": [1, \"&lt;\"]}'/></BehaviorTree></root>";
    const std::optional<Document> document = read({"a.xml", xml}, none);
    REQUIRE(document);
    const std::string json = write_json(*document, FileKind::tree);
    CHECK(json.find(R"("goal": "json:{\"a\": [1, \"<\"]}")") != std::string::npos);
    Diagnostics of_xml;
    Diagnostics of_json;
    const std::optional<Program> a = load({"a.xml", xml}, registry(), of_xml);
    const std::optional<Program> b = load({"a.json", json}, registry(), of_json);
    REQUIRE(a);
    REQUIRE(b);
    CHECK(*a == *b);
    std::string broken = json;
    broken.replace(broken.find("[1,"), 3, "[1 ");
    Diagnostics wrong;
    CHECK_FALSE(load({"a.json", broken}, registry(), wrong));
    CHECK(wrong.render().find("json-syntax") != std::string::npos);
}

}  // namespace trellis::test
