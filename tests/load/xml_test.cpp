// Reading XML (verdicts, places, comments, text, faults) and writing it; the verdicts are
// xmllint's and the contents tinyxml2's, each where that library can tell.
// SPDX-License-Identifier: MIT
#include "load/xml.h"

#include "load/random_document.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <tinyxml2.h>

using namespace trellis;

namespace {

std::optional<Document> read(std::string_view text, const DocumentLimits& limits = {}) {
    Diagnostics diagnostics;
    diagnostics.add_file("f.xml", text);
    return read_xml(text, 0, diagnostics, limits);
}

/// The first finding, without its line and caret.
std::string fault(std::string_view text, const DocumentLimits& limits = {}) {
    Diagnostics diagnostics;
    diagnostics.add_file("f.xml", text);
    const auto document = read_xml(text, 0, diagnostics, limits);
    CHECK(document.has_value() == diagnostics.ok());
    if (diagnostics.all().empty()) { return "none"; }
    const std::string out = diagnostics.render(diagnostics.all()[0]);
    return out.substr(6, out.find('\n') - 6);
}

struct Verdict {
    bool well_formed;  // xmllint --noout (libxml2 2.9.14) exits 0
    std::string_view text;
};

// clang-format off
const Verdict verdicts[] = {
    {true, "<a:b/>"},
    {true, "<a x:y=\"1\"/>"},
    {true, "<:a/>"},
    {true, "<a:b:c xmlns:a=\"u\"/>"},
    {false, "<r><?xml version=\"1.0\"?></r>"},
    {false, "<r><?XML x?></r>"},
    {true, "<r><?pi x?><a/></r>"},
    {true, "<!-- c --><?xml-model x?><r/>"},
    {true, "<?xml version=\"1.1\"?><r/>"},
    {false, "<?xml version=\"2.0\"?><r/>"},
    {false, "<?xml encoding=\"UTF-8\"?><r/>"},
    {false, "<?xml version=\"1.0\" standalone=\"maybe\"?><r/>"},
    {true, "<?xml version='1.0' encoding='UTF-8' standalone='yes'?><r/>"},
    {false, "<?xml version='1.0' standalone='yes' encoding='UTF-8'?><r/>"},
    {false, "<?xml version=\"1.0\"encoding=\"UTF-8\"?><r/>"},
    {false, "<?xml version=\"1.0\" ><r/>"},
    {true, "<?xml version = \"1.0\" ?><r/>"},
    {true, "<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n<r/>"},
    {false, "<?xml version=\"1.0\" encoding=\"UTF-8\" foo=\"1\"?><r/>"},
    {false, " <?xml version=\"1.0\"?><r/>"},
    {true, "<?xml-stylesheet href=\"x\"?><r/>"},
    {false, "<r>]]></r>"},
    {true, "<r>a &gt; b ]]&gt; </r>"},
    {false, "<r><!-- a -- b --></r>"},
    {false, "<r><!-- a ---></r>"},
    {true, "<!----><r/>"},
    {false, "<!---><r/>"},
    {false, "<r><!-></r>"},
    {false, "<r><!- - x --></r>"},
    {false, "<r><!-- never closed</r>"},
    {true, "<r xmlns:a=\"u\" xmlns:b=\"u\" a:x=\"1\" b:x=\"2\"/>"},
    {false, "<r>&#0;</r>"},
    {false, "<r>&#1;</r>"},
    {true, "<r>&#x1F600;</r>"},
    {false, "<r>&#xD800;</r>"},
    {false, "<r>&#xFFFE;</r>"},
    {false, "<r>&#x;</r>"},
    {false, "<r>&#X41;</r>"},
    {false, "<r>&#99999999999;</r>"},
    {false, "<r>&#65</r>"},
    {false, "<r>&lt</r>"},
    {false, "<r>&;</r>"},
    {false, "<r>&lt ;</r>"},
    {false, "<r a=\"&foo;\"/>"},
    {false, "<r a=\"&\"/>"},
    {true, "<r a=\"a>b\"/>"},
    {false, "<r a=\"a<b\"/>"},
    {true, "<r a=\"&lt;&#10;\"/>"},
    {true, "<r\ta='1'\n\tb=\"2\"/>"},
    {true, "<r a =\"1\" b= \"2\"/>"},
    {true, "<r a='\"' b=\"'\"/>"},
    {false, "<r a=\"1\"b=\"2\"/>"},
    {false, "<r a/>"},
    {false, "<r a=1/>"},
    {false, "<r a=\"1></r>"},
    {false, "<r a=\"1\" / b=\"2\">"},
    {false, "<r a=\"1\"\n a=\"2\"/>"},
    {false, "<r a1=\"\" a2=\"\" a3=\"\" a4=\"\" a5=\"\" a6=\"\" a7=\"\" a8=\"\" a9=\"\" b1=\"\" b2=\"\" b3=\"\" b4=\"\" a1=\"\"/>"},
    {false, "< r/>"},
    {false, "<r/ >"},
    {true, "<r></r >"},
    {false, "<r></r x=\"1\">"},
    {false, "<r></r"},
    {false, "<r a=\"x"},
    {false, "<"},
    {false, "</r>"},
    {false, "<r>"},
    {false, "<r><a></r></a>"},
    {true, "<r/><!-- x --><?p?>"},
    {false, "<r/>x"},
    {false, "<r/><s/>"},
    {false, "<r/></r>"},
    {false, "x<r/>"},
    {true, "\xef\xbb\xbf" "<r/>"},
    {true, "\xef\xbb\xbf" "<?xml version=\"1.0\"?><r/>"},
    {true, "<r><![CDATA[ ]] > <&]]></r>"},
    {false, "<r><![CDATA[ </r>"},
    {false, "<r><![cdata[x]]></r>"},
    {false, "<![CDATA[x]]><r/>"},
    {false, "<r/>&#32;"},
    {false, "<1a/>"},
    {false, "<-a/>"},
    {true, "<a.-_1/>"},
    {true, "<\xc3\xa9" "/>"},
    {false, "<\xc3\x97" "/>"},
    {true, "<r \xc3\xa9" "=\"1\"/>"},
    {false, "<r>\x01" "</r>"},
    {true, "<r>\x7f\xc2\x80" "</r>"},
    {false, "<r>\xef\xbf\xbe" "</r>"},
    {false, "<r>\xc3" "</r>"},
    {false, "<r>\xed\xa0\x80" "</r>"},
    {false, "<r>\xc0\x80" "</r>"},
    {false, "<r>\xf4\x90\x80\x80" "</r>"},
    {true, "<r><?p?></r>"},
    {false, "<r><?p x? ></r>"},
    {false, "<r><? p?></r>"},
    {false, "<r><?1p?></r>"},
    {false, "<?p?x?><r/>"},
    {false, "<r><!ELEMENT a ANY></r>"},
    {false, "<p:a xmlns:p=\"u\"></q:a>"},
    {false, ""},
    {false, " \n"},
    {false, "<!-- only -->"},
};
// clang-format on

/// The text that starts at a place, to compare with what should stand there.
std::string_view at(std::string_view text, Where where) {
    std::size_t line = 0;
    for (std::uint32_t n = 1; n < where.line; ++n) {
        line = text.find('\n', line) + 1;
    }
    return text.substr(line + where.column - 1);
}

void check_places(std::string_view text) {
    const auto d = read(text);
    REQUIRE(d);
    for (std::uint32_t e = 0; e < d->elements.size(); ++e) {
        CHECK(at(text, d->elements[e].where).starts_with(d->name({e})));
        CHECK(text[static_cast<std::size_t>(at(text, d->elements[e].where).data() - text.data()) -
                   1] == '<');
        for (const Attribute& a : d->attributes_of({e})) {
            CHECK(at(text, a.where).starts_with(d->string(a.name)));
            const std::string_view value = at(text, a.value_where);
            const char quote = value.data()[-1];
            CHECK((quote == '"' || quote == '\''));
            // decoding never changes the first plain characters
            const std::string_view plain = d->string(a.value);
            CHECK(value.substr(0, value.find_first_of("&\r")).substr(0, plain.size()) ==
                  plain.substr(0, value.find_first_of("&\r")));
        }
    }
}

/// The element as tinyxml2 reads it, against ours from `e` on; the text is compared only where
/// tinyxml2 keeps all of it (it drops blanks beside elements and CDATA).
void compare(const tinyxml2::XMLElement& theirs, const Document& ours, ElementId e) {
    CHECK(theirs.Name() == ours.name(e));
    const tinyxml2::XMLAttribute* attribute = theirs.FirstAttribute();
    for (const Attribute& a : ours.attributes_of(e)) {
        REQUIRE(attribute != nullptr);
        CHECK(attribute->Name() == ours.string(a.name));
        CHECK(attribute->Value() == ours.string(a.value));
        CHECK(static_cast<std::uint32_t>(attribute->GetLineNum()) >= ours.at(e).where.line);
        attribute = attribute->Next();
    }
    CHECK(attribute == nullptr);
    const tinyxml2::XMLElement* child = theirs.FirstChildElement();
    if (child == nullptr && theirs.GetText() != nullptr &&
        theirs.FirstChild() == theirs.LastChild()) {
        CHECK(theirs.GetText() == ours.text(e));
    }
    for (const ElementId c : ours.children(e)) {
        REQUIRE(child != nullptr);
        compare(*child, ours, c);
        child = child->NextSiblingElement();
    }
    CHECK(child == nullptr);
}

}  // namespace

TEST_CASE("xml: a text is read exactly when xmllint calls it well-formed") {
    for (const Verdict& v : verdicts) {
        Diagnostics diagnostics;
        const auto d = read_xml(v.text, 0, diagnostics);
        CHECK_MESSAGE(d.has_value() == v.well_formed, v.text);
        CHECK_MESSAGE(d.has_value() == diagnostics.ok(), v.text);
        if (d) { CHECK(same_content(*d, read(write_xml(*d)).value())); }
    }
}

TEST_CASE("xml: faults say what was found, what was expected and where") {
    CHECK(fault("") == "1:1: error: the file is empty: expected an element [xml-syntax]");
    CHECK(fault(" \n ") == "2:2: error: the file is empty: expected an element [xml-syntax]");
    CHECK(fault("<!-- x -->\n") ==
          "2:1: error: expected an element, found the end of the file [xml-syntax]");
    CHECK(fault("hello") ==
          "1:1: error: expected \"<\" and the root element, found \"hello\" [xml-syntax]");
    CHECK(fault("<a>\n  <b>\n  </c>\n</a>") ==
          "3:3: error: expected </b> for the <b> of line 2, found </c> [xml-syntax]");
    CHECK(fault("<a>\n <b>\n") ==
          "2:3: error: <b> is never closed: expected </b> before the end of the file [xml-syntax]");
    CHECK(fault("<a/></b>") == "1:5: error: </b> closes nothing: no element is open [xml-syntax]");
    CHECK(fault("<a/>\n<b/>") == "2:1: error: expected one root element, found a second one after "
                                 "</a> [xml-syntax]");
    CHECK(fault("<a/> x") ==
          "1:6: error: expected the end of the file after </a>, found \"x\" [xml-syntax]");
    CHECK(fault("<a b/>") ==
          "1:5: error: expected \"=\" and a quoted value after \"b\", found \"/\" [xml-syntax]");
    CHECK(fault("<a b=1/>") ==
          "1:6: error: expected the value of \"b\" in quotes, found \"1\" [xml-syntax]");
    CHECK(fault("<a b='1'c='2'/>") ==
          "1:9: error: expected a blank before the attribute, found \"c\" [xml-syntax]");
    CHECK(fault("<a b='1\n  c=\"2\">\n<d/></a>") ==
          "3:1: error: \"<\" in the value of \"b\": write \"&lt;\", or close the quote before it "
          "[xml-syntax]");
    CHECK(fault("<a b='1/>") == "1:6: error: the value of \"b\" has no closing quote [xml-syntax]");
    CHECK(fault("<a <b/></a>") ==
          "1:4: error: expected an attribute, \">\" or \"/>\" in <a>, found \"<\" [xml-syntax]");
    CHECK(fault("<a>1 < 2</a>") ==
          "1:7: error: expected the name of an element after \"<\" (a \"<\" in text is written "
          "\"&lt;\"), found a blank [xml-syntax]");
    CHECK(fault("<a><!-- x -- y --></a>") ==
          "1:11: error: \"--\" may not stand inside a comment [xml-syntax]");
    CHECK(fault("<a><![CDATA[</a>") ==
          "1:4: error: the CDATA section is never closed with \"]]>\" [xml-syntax]");
    CHECK(fault("<a>]]></a>") == "1:4: error: \"]]>\" may stand only at the end of a CDATA "
                                 "section; write \"]]&gt;\" [xml-syntax]");
    CHECK(fault("\n<?xml version='1.0'?><a/>") ==
          "2:1: error: the XML declaration may stand only at the very beginning of the file "
          "[xml-syntax]");
}

TEST_CASE("xml: faults in references, attributes and namespaces have their own ids") {
    CHECK(fault("<a b='x && y'/>") ==
          "1:9: error: \"&\" begins no entity; write \"&amp;\" [xml-syntax]");
    CHECK(fault("<a>&nbsp;</a>") == "1:4: error: the entity \"&nbsp;\" is unknown; XML has &lt; "
                                    "&gt; &amp; &quot; and &apos; [entity]");
    CHECK(fault("<a>&#0;</a>") == "1:4: error: \"&#0;\" is no character of XML [entity]");
    CHECK(fault("<a>&#x;</a>") == "1:4: error: expected a character reference such as \"&#10;\" or "
                                  "\"&#x1F600;\" [xml-syntax]");
    CHECK(fault("<a b='1'\n   c='2' b='3'/>") ==
          "2:10: error: the attribute \"b\" is given twice in <a> [duplicate-attribute]");
    CHECK(fault("<a>\n<m:b/></a>") ==
          "2:2: warning: no xmlns:m declares the prefix of \"m:b\" [unbound-prefix]");
    CHECK(fault("<a m:b=''/>") ==
          "1:4: warning: no xmlns:m declares the prefix of \"m:b\" [unbound-prefix]");
    CHECK(fault("<a><b xmlns:m='u'/><m:c/></a>") ==
          "1:21: warning: no xmlns:m declares the prefix of \"m:c\" [unbound-prefix]");
    CHECK(fault("<m:a m:b='' xmlns:m='u' xml:space='preserve'/>") == "none");
    CHECK(fault("<!DOCTYPE a [<!ENTITY b 'c'>]><a/>") ==
          "1:1: error: document type definitions are not read: remove it [doctype]");
}

TEST_CASE("xml: encodings other than UTF-8 and forbidden characters are refused") {
    using namespace std::string_view_literals;
    CHECK(fault("<?xml version='1.0' encoding='latin1'?><a/>") ==
          "1:31: error: the encoding is \"latin1\", expected \"UTF-8\" [encoding]");
    CHECK(fault("\xFF\xFE<\0a\0"sv) == "1:1: error: the file is UTF-16, expected UTF-8 [encoding]");
    CHECK(fault("\0\0\xFE\xFF\0\0\0<"sv) ==
          "1:1: error: the file is UTF-32, expected UTF-8 [encoding]");
    CHECK(fault("<\0a\0"sv) == "1:1: error: the file is UTF-16, expected UTF-8 [encoding]");
    CHECK(fault("<a>\n caf\xE9 </a>") ==
          "2:5: error: the file is not UTF-8: found the byte 0xE9 [encoding]");
    CHECK(fault("<a>\0</a>"sv) ==
          "1:4: error: the character U+0000 is not allowed in a file [character]");
    CHECK(fault("<a b='\x1B'/>") ==
          "1:7: error: the character U+001B is not allowed in a file [character]");
    CHECK(fault("<?xml version='1.0' encoding='US-ASCII'?><a/>") == "none");
}

TEST_CASE("xml: more than the limits is an error, however deep or long") {
    std::string deep;
    for (int i = 0; i < 100000; ++i) {
        deep += "<a>";
    }
    CHECK(fault(deep) == "1:769: error: elements are nested more than 256 deep [too-large]");
    CHECK(fault("<a><b/></a>", {.depth = 1}) ==
          "1:4: error: elements are nested more than 1 deep [too-large]");
    CHECK(fault("<a><b/></a>", {.elements = 1}) ==
          "1:4: error: the file has more than 1 elements [too-large]");
    CHECK(fault("<a><b/></a>", {.bytes = 5}) ==
          "1:1: error: the file has 11 bytes, the limit is 5 [too-large]");
    CHECK(read("<a><b/></a>", {.bytes = 11, .depth = 2, .elements = 2}));
}

TEST_CASE("xml: every name and value has its place, whatever the layout") {
    check_places("<a b='1'/>");
    check_places("\xEF\xBB\xBF<a b='1'/>");
    check_places(
        "<?xml version='1.0'?>\r\n<!-- c\r\n c -->\r\n<a\r\n\tb = \"1\"\r\n\t\tn:c='2'>"
        "<é ñ='€'  x=''/>\r\n<![CDATA[<no a='b'>]]><?pi a='b'?> &amp; <d\ne\n=\n'f'/></a>");
    check_places("<a x='1&amp;2\r\n&#10;' y='&lt;'><b   c=\"'\"  d='\"'></b\n></a>");
}

TEST_CASE("xml: the places of a small file, one by one") {
    const auto d = read("<a>\n  <b x='1'\n     y=\"&lt;\">t</b>\n</a>");
    REQUIRE(d);
    CHECK(d->elements[0].where == Where{0, 1, 2});
    CHECK(d->elements[1].where == Where{0, 2, 4});
    CHECK(d->attributes[0].where == Where{0, 2, 6});
    CHECK(d->attributes[0].value_where == Where{0, 2, 9});
    CHECK(d->attributes[1].where == Where{0, 3, 6});
    CHECK(d->attributes[1].value_where == Where{0, 3, 9});
    CHECK(d->elements[1].text_where == Where{0, 3, 15});
}

TEST_CASE("xml: comments become the doc of the element behind them, none is lost") {
    const auto d = read("<!-- one -->\n<!--two\n three--><a><!-- b --> text <b/><!----><c>"
                        "<!-- in c --></c><!-- end --></a><!-- after -->");
    REQUIRE(d);
    CHECK(d->doc({0}) == "one\ntwo\n three\nend\nafter");
    CHECK(d->doc({1}) == "b");
    CHECK(d->doc({2}) == "in c");
}

TEST_CASE("xml: text is all character data directly inside, or empty if it is blank") {
    const auto text = [](std::string_view xml) { return std::string(read(xml).value().text({0})); };
    CHECK(text("<a> x\r\n y </a>") == " x\n y ");
    CHECK(text("<a> \n\t</a>") == "");
    CHECK(text("<a>x <b>no</b> <!-- no --><![CDATA[&<\r]]><?no?>&amp;</a>") == "x  &<\n&");
    CHECK(text("<a><![CDATA[x]]> <![CDATA[y]]></a>") == "x y");
    CHECK(text("<a>&#13;&#10;é&#xe9;😀&#x1F600;.</a>") == "\r\néé😀😀.");
    CHECK(text("<a><b>x</b></a>") == "");
}

TEST_CASE("xml: line feeds and tabs in values are kept, as in BehaviorTree.CPP") {
    CHECK(read("<a b='x\r\n\ty'/>").value().value({0}, "b") == "x\n\ty");
}

TEST_CASE("xml: a document is written ready to be edited") {
    const auto d = read(
        "<root BTCPP_format='4'><!--the tree--><BehaviorTree ID='Main'><Sequence><A "
        "x='1' s='a\"b' t='&quot;&apos;'/><Script code=\"a:=1;&#10;b:='x' &lt; 2\"/></Sequence>"
        "</BehaviorTree><a>x&amp;y]]&gt;<b/><!-- in text --><c><d/></c></a><!--e--><e></e>"
        "<SubTreeWithALongName first_attribute='some value' second_attribute='some other value' "
        "third='33'/></root>");
    REQUIRE(d);
    CHECK(write_xml(*d) == R"xml(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4">
  <!-- the tree -->
  <BehaviorTree ID="Main">
    <Sequence>
      <A x="1" s='a"b' t="&quot;'"/>
      <Script code="a:=1;&#10;b:='x' &lt; 2"/>
    </Sequence>
  </BehaviorTree>
  <a>x&amp;y]]&gt;<b/><!-- in text --><c>
      <d/>
    </c></a>
  <!-- e -->
  <e/>
  <SubTreeWithALongName first_attribute="some value"
                        second_attribute="some other value"
                        third="33"/>
</root>
)xml");
    CHECK(write_xml(*d, {1}).starts_with("<!-- the tree -->\n<BehaviorTree ID=\"Main\">\n  <Seq"));
}

TEST_CASE("xml: double hyphens in a doc are written as a comment allows and read back") {
    for (const std::string_view doc :
         {"a--b", "---", "-\\-", "-\\\\--", "--", "a-", "-\\", "\\-"}) {
        Document d;
        const ElementId e = d.open({}, "a", {});
        d.elements[0].doc = d.add_string(doc);
        d.close(e);
        CHECK(read(write_xml(d)).value().doc({0}) == doc);
    }
    CHECK(read("<!-- a -\\- b --><a/>").value().doc({0}) == "a -- b");
}

TEST_CASE("xml: read(write(d)) is d for random documents, and written again the same text") {
    test::Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const Document d = test::random_document(random);
        const std::string text = write_xml(d);
        const auto again = read(text);
        REQUIRE_MESSAGE(again, text);
        REQUIRE_MESSAGE(same_content(d, *again), text);
        REQUIRE(write_xml(*again) == text);
    }
}

TEST_CASE("xml: mutated texts are read or refused with a place, never anything else") {
    test::Random random(4);
    for (int i = 0; i < 20000; ++i) {
        static const std::string text = write_xml(test::random_document(random));
        const std::string bad = test::mutated(text, random);
        Diagnostics diagnostics;
        const auto d = read_xml(bad, 0, diagnostics);
        REQUIRE(d.has_value() == diagnostics.ok());
        if (d) { REQUIRE(same_content(*d, read(write_xml(*d)).value())); }
        for (const Diagnostic& x : diagnostics.all()) {
            REQUIRE(x.where.line != 0);
        }
    }
}

TEST_CASE("xml: the conformance files are read as tinyxml2 reads them") {
    const std::filesystem::path folder = TRELLIS_CONFORMANCE_DIR;
    if (!std::filesystem::exists(folder)) {
        MESSAGE("skipped: no ", folder.string());
        return;
    }
    std::size_t compared = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".xml" && extension != ".scxml") { continue; }
        const std::string text = test::read_file(entry.path());
        tinyxml2::XMLDocument theirs;
        const bool accepted = theirs.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS;
        const auto ours = read(text);
        if (theirs.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) { continue; }
        if (!accepted || !ours) {
            CHECK_MESSAGE(accepted == ours.has_value(), entry.path().string());
            continue;
        }
        compare(*theirs.RootElement(), *ours, ours->root());
        ++compared;
    }
    CHECK(compared > 0);
    MESSAGE(compared, " files compared");
}
