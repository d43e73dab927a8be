// Pictures of trees as a whole: recorded ones, highlights, escaping, and sizes nobody should draw.
// SPDX-License-Identifier: MIT
#include "drawing/samples.h"
#include "load/xml.h"
#include "runner/drawing/drawing.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("tree_drawing: the lab's tree looks as recorded") {
    check_pictures("roomba_tree.xml");
}

TEST_CASE("tree_drawing: SubTrees open in frames as recorded") {
    check_pictures("primitives.xml");
}

TEST_CASE("tree_drawing: nodes of every kind look as recorded") {
    check_pictures("every_kind.xml");
}

TEST_CASE("tree_drawing: a tree of sixty nodes looks as recorded") {
    check_pictures("big_tree.xml");
}

TEST_CASE("tree_drawing: a terminal without Unicode gets ASCII") {
    const Document document = document_of(R"(<root><BehaviorTree ID="Mäh"><Sequence>
        <Inverter><A/></Inverter><B x="é"/></Sequence></BehaviorTree></root>)");
    DrawingOptions options;
    options.ascii = true;
    CHECK(draw(document, DrawingFormat::text, options) == "M\\u{e4}h\n"
                                                          "-> Sequence\n"
                                                          "|- ! Inverter\n"
                                                          "|  `- [] A\n"
                                                          "`- [] B  x = \\u{e9}\n");
}

TEST_CASE("tree_drawing: a highlight colours its node and adds its note") {
    const Document document =
        document_of("<root><BehaviorTree><Sequence><A/><B/></Sequence></BehaviorTree></root>");
    const std::array highlights{Highlight{{3}, DrawingStatus::running, "tick 7"},
                                Highlight{{4}, DrawingStatus::skipped, ""}};
    DrawingOptions options;
    options.highlights = highlights;
    CHECK(draw(document, DrawingFormat::text, options) == "→ Sequence\n"
                                                          "├─ □ A  [running]  tick 7\n"
                                                          "└─ □ B  [skipped]\n");
    const std::string svg = draw(document, DrawingFormat::svg, options);
    CHECK(svg.find("class=\"shape action running\"") != std::string::npos);
    CHECK(svg.find(">tick 7</text>") != std::string::npos);
    CHECK(svg.find("class=\"shape action skipped\"") != std::string::npos);
    CHECK(draw(document, DrawingFormat::dot, options)
              .find("label=<<b>A</b><br/>tick 7>, fillcolor=\"#ffe8ad\"") != std::string::npos);
}

TEST_CASE("tree_drawing: any name is spelled so that SVG and DOT stay well-formed") {
    const Document document =
        document_of("<root><BehaviorTree ID=\"&lt;&quot;&amp;\\\"><A name=\"]]&gt;&lt;/text&gt;&#9;"
                    "&#x202E;&quot;&gt;\\\"/></BehaviorTree></root>");
    const std::string svg = draw(document, DrawingFormat::svg);
    document_of(svg);  // fails the test unless it is well-formed
    CHECK(svg.find(">]]&gt;&lt;/text&gt; ⟨U+202E⟩&quot;&gt;\\</text>") != std::string::npos);
    const std::string dot = draw(document, DrawingFormat::dot);
    CHECK(dot.find("digraph \"<\\\"&\\\\\" {") != std::string::npos);
    CHECK(dot.find("label=<<b>]]&gt;&lt;/text&gt; ⟨U+202E⟩&quot;&gt;\\</b><br/>A>") !=
          std::string::npos);
}

TEST_CASE("tree_drawing: sideways, parents stand left of their children") {
    const Document document =
        document_of("<root><BehaviorTree><Sequence><A/><B/></Sequence></BehaviorTree></root>");
    DrawingOptions options;
    options.sideways = true;
    const std::string svg = draw(document, DrawingFormat::svg, options);
    CHECK(svg.find("<rect x=\"0\" y=\"22\"") != std::string::npos);
    CHECK(draw(document, DrawingFormat::dot, options).find("rankdir=LR") != std::string::npos);
}

TEST_CASE("tree_drawing: a hundred thousand nodes and chains of trees are drawn") {
    std::string text = "<root><BehaviorTree ID=\"Main\"><Sequence>";
    for (int i = 0; i < 1000; ++i) {
        text += "<Fallback>";
        for (int k = 0; k < 98; ++k)
            text += "<Go to=\"here\"/>";
        text += "<SubTree ID=\"T0\"/></Fallback>";
    }
    text += "</Sequence></BehaviorTree>";
    for (int i = 0; i < 600; ++i)
        text += "<BehaviorTree ID=\"T" + std::to_string(i) + "\"><SubTree ID=\"T" +
                std::to_string(i + 1) + "\"/></BehaviorTree>";
    const Document document = document_of(text + "</root>");
    for (const DrawingFormat format : {DrawingFormat::svg, DrawingFormat::dot, DrawingFormat::text})
        CHECK(draw(document, format).size() > 1'000'000);
}

TEST_CASE("drawing: a document that is neither a tree nor a machine has no picture") {
    CHECK(draw(document_of("<world/>"), DrawingFormat::svg).empty());
    CHECK(draw(document_of("<root/>"), DrawingFormat::text).empty());
    document_of(draw(document_of("<root/>"), DrawingFormat::svg));
}
