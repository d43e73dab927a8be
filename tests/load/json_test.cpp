// JSON text to values and back: places, faults, limits, layout. What the values mean is the
// business of json_trees_test.cpp and json_machines_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/json_tree.h"
#include "load/random_document.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace trellis;

namespace {

using Kind = JsonTree::Kind;

std::optional<JsonTree> parse(std::string_view text, const DocumentLimits& limits = {}) {
    Diagnostics diagnostics;
    diagnostics.add_file("f.json", text);
    return parse_json(text, 0, diagnostics, limits);
}

/// The first finding, without its line and caret.
std::string fault(std::string_view text, const DocumentLimits& limits = {}) {
    Diagnostics diagnostics;
    diagnostics.add_file("f.json", text);
    const auto json = parse_json(text, 0, diagnostics, limits);
    CHECK(json.has_value() == diagnostics.ok());
    if (diagnostics.all().empty()) { return "none"; }
    const std::string out = diagnostics.render(diagnostics.all()[0]);
    return out.substr(7, out.find('\n') - 7);
}

/// Key, text and places of each value: "key@1:2=text@1:8 …".
std::string listed(const JsonTree& json) {
    const auto place = [](Where w) {
        return w.line == 0 ? std::string()
                           : "@" + std::to_string(w.line) + ":" + std::to_string(w.column);
    };
    std::string out;
    for (const JsonValue& v : json.values) {
        out += std::string(json.string(v.key)) + place(v.key_where) + "=" +
               std::string(json.string(v.text)) + place(v.where) + " ";
    }
    return out;
}

}  // namespace

TEST_CASE("json: every key and value has its place") {
    const auto json =
        parse("\xEF\xBB\xBF{ \"a\" : 1.50 ,\r\n\t\"b\":[true,null , \"x\\ny\",-1e3],\"c\":{}}\n");
    REQUIRE(json);
    CHECK(listed(*json) == "=@1:4 a@1:7=1.50@1:12 b@2:3=@2:6 =true@2:7 =null@2:12 =x\ny@2:20 "
                           "=-1e3@2:26 c@2:33=@2:36 ");
}

TEST_CASE("json: values know their kind, their parent and what is inside") {
    const auto json = parse("{\"a\":[1,[2]],\"\":false}");
    REQUIRE(json);
    CHECK(json->kind({0}) == Kind::object);
    CHECK(json->kind({1}) == Kind::array);
    CHECK(json->at({1}).end == JsonId{5});
    CHECK(json->at({4}).parent == JsonId{3});
    CHECK(json->member({0}, "a") == JsonId{1});
    CHECK(json->member({0}, "") == JsonId{5});
    CHECK_FALSE(json->member({0}, "b"));
    CHECK_FALSE(json->member({1}, "a"));
    CHECK(json->has_children({3}));
    CHECK_FALSE(json->has_children({2}));
}

TEST_CASE("json: numbers keep their spelling and strings are decoded") {
    const auto json =
        parse("[0, -0, 1.0, 1E+2, 12345678901234567890123, \"\\u00e9\\ud83d\\ude00\"]");
    REQUIRE(json);
    std::string texts;
    for (const JsonValue& v : json->values) {
        texts += std::string(json->string(v.text)) + " ";
    }
    CHECK(texts == " 0 -0 1.0 1E+2 12345678901234567890123 é😀 ");
}

TEST_CASE("json: faults say what was found, what was expected and where") {
    CHECK(fault("") == "1:1: error: the file is empty: expected an object [json-syntax]");
    CHECK(fault("{\"a\" 1}") ==
          "1:6: error: expected \":\" after the member's name, found \"1\" [json-syntax]");
    CHECK(fault("{\"a\": }") == "1:7: error: expected a value, found \"}\" [json-syntax]");
    CHECK(fault("{\"a\": 1\n \"b\": 2}") ==
          "2:2: error: expected \",\" or \"}\", found \"\"\" [json-syntax]");
    CHECK(fault("[1 2]") == "1:4: error: expected \",\" or \"]\", found \"2\" [json-syntax]");
    CHECK(fault("[1}") == "1:3: error: expected \",\" or \"]\", found \"}\" [json-syntax]");
    CHECK(fault("{a: 1}") == "1:2: error: expected a member's name in double quotes or \"}\", "
                             "found \"a\" [json-syntax]");
    CHECK(fault("{\"a\": 1, b: 2}") ==
          "1:10: error: expected a member's name in double quotes, found \"b\" [json-syntax]");
    CHECK(fault("[1,\n]") == "1:3: error: no comma may stand before \"]\" [json-syntax]");
    CHECK(fault("{\"a\": 1,}") == "1:8: error: no comma may stand before \"}\" [json-syntax]");
    CHECK(fault("[,1]") == "1:2: error: expected a value or \"]\", found \",\" [json-syntax]");
    CHECK(fault("[1,,2]") == "1:4: error: expected a value, found \",\" [json-syntax]");
    CHECK(fault("[1") ==
          "1:3: error: expected \",\" or \"]\", found the end of the file [json-syntax]");
    CHECK(fault("{} x") == "1:4: error: expected the end of the file, found \"x\" [json-syntax]");
    CHECK(fault("{} {}") == "1:4: error: expected the end of the file, found \"{\" [json-syntax]");
    CHECK(fault("[True]") == "1:2: error: expected a value or \"]\", found \"True\" [json-syntax]");
    CHECK(fault("<root/>") == "1:1: error: expected a value, found \"<\" [json-syntax]");
}

TEST_CASE("json: what other notations allow is named") {
    CHECK(fault("[1, // one\n2]") ==
          "1:5: error: JSON has no comments; write a member \"doc\" [json-syntax]");
    CHECK(fault("/* x */ {}") ==
          "1:1: error: JSON has no comments; write a member \"doc\" [json-syntax]");
    CHECK(fault("{'a': 1}") == "1:2: error: text and names take double quotes [json-syntax]");
    CHECK(fault("[NaN]") == "1:2: error: JSON has no NaN and no Infinity [json-syntax]");
    CHECK(fault("[1, -Infinity]") == "1:5: error: JSON has no NaN and no Infinity [json-syntax]");
    CHECK(fault("[1.]") == "1:2: error: expected a number such as 12, -0.5 or 1e-3 [json-syntax]");
    CHECK(fault("{\"a\": +1}") ==
          "1:7: error: expected a number such as 12, -0.5 or 1e-3 [json-syntax]");
    CHECK(fault("[1e999]") == "1:2: error: the number is too large [json-syntax]");
}

TEST_CASE("json: faults inside a string have their own places") {
    CHECK(fault("[\"abc]") == "1:2: error: the string has no closing quote [json-syntax]");
    CHECK(fault("[\"ab\nc\"]") == "1:5: error: a string ends on its line; write \"\\n\" for a line "
                                  "feed [json-syntax]");
    CHECK(fault("[\"a\tb\"]") ==
          "1:4: error: the character U+0009 must be escaped in a string [json-syntax]");
    CHECK(fault("{\"a\": \"x\\qy\"}") ==
          "1:9: error: a string has no escape \"\\q\" [json-syntax]");
    CHECK(fault("{\"a\\x\": 1}") == "1:4: error: a string has no escape \"\\x\" [json-syntax]");
    CHECK(fault("[\"ab\\u0001\"]") ==
          "1:5: error: the character U+0001 is not allowed in a file [character]");
    CHECK(fault("[\"\\uffff\"]") ==
          "1:3: error: the character U+FFFF is not allowed in a file [character]");
}

TEST_CASE("json: a member given twice is an error that names both places") {
    CHECK(fault("{\"a\": 1,\n \"b\": 2,\n \"a\": 3}") ==
          "3:3: error: the member \"a\" is given twice, first in line 1 [duplicate-member]");
    CHECK(fault("[{\"a\": 1}, {\"a\": 2}]") == "none");
    CHECK(fault("{\"a\": {\"a\": 2}}") == "none");
}

TEST_CASE("json: encodings other than UTF-8 are refused") {
    using namespace std::string_view_literals;
    CHECK(fault("\xFF\xFE{\0"sv) == "1:1: error: the file is UTF-16, expected UTF-8 [encoding]");
    CHECK(fault("{\0}\0"sv) == "1:1: error: the file is UTF-16, expected UTF-8 [encoding]");
    CHECK(fault("[\"caf\xE9\"]") ==
          "1:6: error: the file is not UTF-8: found the byte 0xE9 [encoding]");
    CHECK(fault("[\0]"sv) ==
          "1:2: error: the character U+0000 is not allowed in a file [character]");
}

TEST_CASE("json: more than the limits is an error, however deep or long") {
    CHECK(fault(std::string(100000, '[')) ==
          "1:1029: error: values are nested more than 1028 deep [too-large]");
    CHECK(fault("[1,2,3]", {.bytes = 6}) ==
          "1:1: error: the file has 7 bytes, the limit is 6 [too-large]");
    CHECK(fault("[1,2,3,4,5,6,7,8]", {.values = 8}) ==
          "1:16: error: the file has more than 8 values [too-large]");
}

TEST_CASE("json: values are printed on one line where they fit") {
    const auto printed = [](std::string_view text) { return print_json(parse(text).value()); };
    CHECK(printed("{}") == "{}\n");
    CHECK(printed("[]") == "[]\n");
    CHECK(printed("[1,[],{\"a\":\"x\\\"\\\\\\n\\t\\ré\",\"b\":{}}]") ==
          "[1, [], { \"a\": \"x\\\"\\\\\\n\\t\\ré\", \"b\": {} }]\n");
    const std::string item = "\"" + std::string(40, 'x') + "\"";
    CHECK(printed("{\"a\":[" + item + "," + item + "],\"b\":1}") ==
          "{\n  \"a\": [" + item + ", " + item + "],\n  \"b\": 1\n}\n");
    CHECK(printed("[" + item + "," + item + "," + item + "]") ==
          "[\n  " + item + ",\n  " + item + ",\n  " + item + "\n]\n");
}

TEST_CASE("json: a line is at most 100 columns wide, and exactly 100 fit") {
    const auto lines = [](std::size_t size) {
        const std::string text = "[\"" + std::string(size, 'x') + "\", 1]";
        const std::string out = print_json(parse(text).value());
        return std::count(out.begin(), out.end(), '\n');
    };
    CHECK(lines(92) == 1);  // 99 columns, and one kept for a comma
    CHECK(lines(93) == 4);
}

TEST_CASE(
    "json: printed text is read as the same values, and mutated text never breaks the reader") {
    const std::string text = print_json(
        parse(
            "{\"type\":\"Sequence\",\"x\":0.5,\"y\":[true,null,-1e3,\"\\u00e9\\n\\ud83d\\ude00\"],"
            "\"children\":[{\"type\":\"A\",\"doc\":\"a "
            "\\\"b\\\"\"},{\"type\":\"B\",\"ports\":{}}]}")
            .value());
    CHECK(print_json(parse(text).value()) == text);
    test::Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const std::string bad = test::mutated(text, random);
        Diagnostics diagnostics;
        const auto json = parse_json(bad, 0, diagnostics);
        REQUIRE(json.has_value() == diagnostics.ok());
        if (json) { REQUIRE(parse(print_json(*json))); }
        for (const Diagnostic& d : diagnostics.all()) {
            REQUIRE(d.where.line != 0);
        }
    }
}
