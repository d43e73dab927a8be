// Building, walking, copying and comparing documents; places inside decoded values.
// SPDX-License-Identifier: MIT
#include "load/document.h"

#include "load/random_document.h"
#include "load/xml.h"

#include <doctest/doctest.h>

#include <string>

using namespace trellis;

namespace {

Document sample() {  // <a x="1" y="2"><b><c/></b><d/></a>
    Document d;
    const ElementId a = d.open({}, "a", {0, 1, 2});
    d.add_attribute(a, "x", "1", {0, 1, 4}, {0, 1, 7});
    d.add_attribute(a, "y", "2", {0, 1, 10}, {0, 1, 13}, true);
    const ElementId b = d.open(a, "b", {});
    d.close(d.open(b, "c", {}));
    d.close(b);
    d.close(d.open(a, "d", {}));
    d.close(a);
    return d;
}

std::string names(const Document& d, ElementId e) {
    std::string out;
    for (const ElementId c : d.children(e)) {
        out += d.name(c);
    }
    return out;
}

/// Line and column of byte `offset` of a value that begins at `begin`, as "2:5".
std::string place(std::string_view source, Document::Spelling spelling, Where begin,
                  std::size_t offset) {
    const Where w = where_in(source, spelling, begin, offset);
    return std::to_string(w.line) + ":" + std::to_string(w.column);
}

constexpr auto xml = Document::Spelling::xml;
constexpr auto json = Document::Spelling::json;

}  // namespace

TEST_CASE("document: children are walked in order, whatever is inside them") {
    const Document d = sample();
    CHECK(names(d, d.root()) == "bd");
    CHECK(names(d, {1}) == "c");
    CHECK(names(d, {2}) == "");
    CHECK(d.child_count(d.root()) == 2);
    CHECK(d.at({2}).parent == ElementId{1});
    CHECK_FALSE(d.at(d.root()).parent);
    CHECK(d.at({1}).end == ElementId{3});
}

TEST_CASE("document: attributes are found by name and keep their order") {
    const Document d = sample();
    CHECK(d.value(d.root(), "x") == "1");
    CHECK(d.value(d.root(), "z") == "");
    CHECK(d.value(d.root(), "z", "none") == "none");
    CHECK(d.find(d.root(), "z") == nullptr);
    REQUIRE(d.find(d.root(), "y") != nullptr);
    CHECK(d.find(d.root(), "y")->bare);
    CHECK(d.find(d.root(), "y")->value_where == Where{0, 1, 13});
    CHECK(d.attributes_of({1}).begin() == d.attributes_of({1}).end());
}

TEST_CASE("document: a repeated attribute is found among few and among many") {
    for (const int n : {2, 40}) {
        Document d;
        const ElementId e = d.open({}, "a", {});
        for (int i = 0; i < n; ++i) {
            d.add_attribute(e, "x" + std::to_string(i), "", {}, {});
        }
        CHECK(d.repeated(e) == nullptr);
        d.add_attribute(e, "x1", "", {}, {});
        CHECK(d.repeated(e) == &d.attributes.back());
    }
}

TEST_CASE("document: the kind of a file is told by its root") {
    const auto kind = [](std::string_view root) {
        Document d;
        d.close(d.open({}, root, {}));
        return file_kind(d);
    };
    CHECK(kind("root") == FileKind::tree);
    CHECK(kind("scxml") == FileKind::machine);
    CHECK_FALSE(kind("html"));
    CHECK_FALSE(file_kind(Document()));
}

TEST_CASE("document: same content whatever the places, the spelling and the strings' layout") {
    Document a = sample();
    Document b = sample();
    b.strings.insert(0, "unused");
    for (Element& e : b.elements) {
        e.name.begin += 6;
    }
    for (Attribute& x : b.attributes) {
        x.name.begin += 6;
        x.value.begin += 6;
        x.where = {};
    }
    b.spelling = Document::Spelling::json;
    CHECK(same_content(a, b));
    b.attributes[1].value = b.attributes[0].value;
    CHECK_FALSE(same_content(a, b));
    b = sample();
    b.elements[3].doc = b.add_string("more");
    CHECK_FALSE(same_content(a, b));
    b = sample();
    b.elements[2].end = {4};  // <d> inside <c>
    b.elements[3].parent = {2};
    CHECK_FALSE(same_content(a, b));
    CHECK_FALSE(same_content(a, Document()));
}

TEST_CASE("document: a copied subtree has the same content, inside another element or as a root") {
    test::Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Document d = test::random_document(random);
        Document copy;
        copy_subtree(d, d.root(), copy, {});
        CHECK(same_content(d, copy));

        Document outer;
        const ElementId root = outer.open({}, "outer", {});
        outer.close(outer.open(root, "first", {}));
        const ElementId inner = copy_subtree(d, {1}, outer, root);
        outer.close(root);
        CHECK(outer.at(inner).parent == root);
        Document alone, taken;
        copy_subtree(d, {1}, alone, {});
        copy_subtree(outer, inner, taken, {});
        CHECK(same_content(alone, taken));
    }
}

TEST_CASE("document: a place inside an XML value walks over entities and line ends") {
    const std::string_view source = "<a\n  code=\"a &lt; b\r\n &#x1F600; c\"/>";
    const Where begin{0, 2, 9};
    CHECK(place(source, xml, begin, 0) == "2:9");
    CHECK(place(source, xml, begin, 2) == "2:11");
    CHECK(place(source, xml, begin, 3) == "2:15");
    CHECK(place(source, xml, begin, 6) == "3:1");
    CHECK(place(source, xml, begin, 7) == "3:2");
    CHECK(place(source, xml, begin, 9) == "3:2");  // within the smiley's four bytes
    CHECK(place(source, xml, begin, 11) == "3:11");
    CHECK(place(source, xml, begin, 12) == "3:12");
    CHECK(place(source, xml, begin, 999) == "3:16");  // stops at the end of the source
    CHECK(place(source, xml, {}, 5) == "0:0");
}

TEST_CASE("document: a place inside XML text walks over comments and CDATA, up to a tag") {
    const std::string_view source = "<s>a<!-- no -->b<![CDATA[<&]]>c<?no?>d<x/>e</s>";
    const Where begin{0, 1, 4};
    const std::size_t at[] = {4, 16, 26, 27, 31, 38};
    for (std::size_t i = 0; i < std::size(at); ++i) {
        CHECK(where_in(source, xml, begin, i) == Where{0, 1, static_cast<std::uint32_t>(at[i])});
    }
    CHECK(place(source, xml, begin, 6) == "1:39");
    CHECK(place(source, xml, begin, 7) == "1:39");
    CHECK(place("<s><![CDATA[a<b]]>c</s>", xml, {0, 1, 13}, 3) == "1:19");
}

TEST_CASE("document: a place inside a JSON string walks over escapes") {
    const std::string_view source = "{\n \"code\": \"a\\n\\u00e9\\ud83d\\ude00é\\\"b\"}";
    const Where begin{0, 2, 11};
    CHECK(place(source, json, begin, 0) == "2:11");
    CHECK(place(source, json, begin, 1) == "2:12");
    CHECK(place(source, json, begin, 2) == "2:14");
    CHECK(place(source, json, begin, 4) == "2:20");
    CHECK(place(source, json, begin, 8) == "2:32");
    CHECK(place(source, json, begin, 10) == "2:34");
    CHECK(place(source, json, begin, 11) == "2:36");
    CHECK(place("\"\\", json, {0, 1, 2}, 5) == "1:3");
}

TEST_CASE("document: the place of every character of every value is where a reader finds it") {
    test::Random random(2);
    for (int i = 0; i < 200; ++i) {
        const std::string source = write_xml(test::random_document(random));
        Diagnostics diagnostics;
        const auto d = read_xml(source, 0, diagnostics);
        REQUIRE(d);
        for (const Attribute& a : d->attributes) {
            // one past the value is its closing quote, which opened just before its first character
            const Where end = where_in(source, xml, a.value_where, a.value.size);
            std::size_t line = 0;
            for (std::uint32_t n = 1; n < end.line; ++n) {
                line = source.find('\n', line) + 1;
            }
            const Where open = a.value_where;
            REQUIRE(open.line == end.line);
            CHECK(source[line + end.column - 1] == source[line + open.column - 2]);
        }
    }
}
