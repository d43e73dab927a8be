// Pictures of machines as a whole: recorded ones, highlights, and sizes nobody should draw.
// SPDX-License-Identifier: MIT
#include "drawing/samples.h"
#include "runner/drawing/drawing.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("machine_drawing: the lab's machine looks as recorded") {
    check_pictures("roomba_machine.scxml");
}

TEST_CASE("machine_drawing: compound states look as recorded") {
    check_pictures("compound.scxml");
}

TEST_CASE("machine_drawing: regions and histories look as recorded") {
    check_pictures("parallel.scxml");
}

TEST_CASE("machine_drawing: a machine of twelve states looks as recorded") {
    check_pictures("twelve.scxml");
}

TEST_CASE("machine_drawing: states six deep look as recorded") {
    check_pictures("deep.scxml");
}

TEST_CASE("machine_drawing: highlights show the active state and the transition taken") {
    const Document document = document_of(
        R"(<scxml name="m"><state id="a"><transition event="e" target="b"/></state><final id="b"/></scxml>)");
    const std::array highlights{Highlight{{1}, DrawingStatus::active, "3.5 s"},
                                Highlight{{2}, DrawingStatus::success, ""}};
    DrawingOptions options;
    options.highlights = highlights;
    options.ascii = true;
    CHECK(draw(document, DrawingFormat::text, options) == "m\n"
                                                          "  * -> a\n"
                                                          "  [] a  [active]  3.5 s\n"
                                                          "      -> b  e  [success]\n"
                                                          "  (o) b\n");
    const std::string svg = draw(document, DrawingFormat::svg, options);
    CHECK(svg.find("class=\"shape state active\"") != std::string::npos);
    CHECK(svg.find("class=\"line success\"") != std::string::npos);
    CHECK(draw(document, DrawingFormat::dot, options).find("penwidth=3, color=\"#2b8a3e\"") !=
          std::string::npos);
}

TEST_CASE("machine_drawing: five hundred states are drawn") {
    const std::string svg = draw(document_of(random_machine(1, 500)), DrawingFormat::svg);
    CHECK(svg.find(">s499</text>") != std::string::npos);
    document_of(svg);
}

TEST_CASE("machine_drawing: too many long arrows are written into the states") {
    std::string text = "<scxml>";
    for (int i = 0; i < 3000; ++i)
        text += "<state id=\"s" + std::to_string(i) + "\"><transition event=\"e\" target=\"s" +
                std::to_string((i + 1) % 3000) + "\"/><transition event=\"f\" target=\"s" +
                std::to_string(2999 - i) + "\"/></state>";
    const std::string svg = draw(document_of(text + "</scxml>"), DrawingFormat::svg);
    CHECK(svg.find(">e → s1</text>") != std::string::npos);
}
