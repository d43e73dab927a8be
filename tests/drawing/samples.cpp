// Reading samples, making machines, comparing pictures.
// SPDX-License-Identifier: MIT
#include "drawing/samples.h"

#include "load/xml.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

namespace trellis::test {

Document document_of(std::string_view xml) {
    Diagnostics diagnostics;
    const std::uint32_t file = diagnostics.add_file("sample", xml);
    std::optional<Document> document = read_xml(xml, file, diagnostics);
    REQUIRE_MESSAGE(document, diagnostics.render());
    return std::move(*document);
}

Document sample(std::string_view name) {
    return document_of(read_file(std::filesystem::path(TRELLIS_SOURCE_DIR) / "tests" / "drawing" /
                                 "samples" / name));
}

std::string random_machine(unsigned seed, unsigned states) {
    std::mt19937 random(seed);
    const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    std::string text = "<scxml name=\"random\">";
    unsigned open = 0;
    for (unsigned i = 0; i < states; ++i) {
        text += "<state id=\"s" + std::to_string(i) + "\">";
        if (below(3) == 0)
            text += "<onentry><log expr=\"here" + std::to_string(i) + "\"/></onentry>";
        for (unsigned t = below(4); t > 0; --t)
            text += "<transition event=\"event" + std::to_string(below(20)) + "\"" +
                    (below(3) == 0 ? " cond=\"elapsed() &gt; limit\"" : "") + " target=\"s" +
                    std::to_string(below(states)) + "\"/>";
        if (open < 3 && below(4) == 0 && i + 1 < states) {
            ++open;
            continue;
        }
        text += "</state>";
        for (; open > 0 && below(3) == 0; --open)
            text += "</state>";
    }
    for (; open > 0; --open)
        text += "</state>";
    return text + "</scxml>";
}

void check_pictures(std::string_view name, const DrawingOptions& options) {
    const Document document = sample(name);
    struct Picture {
        DrawingFormat format;
        std::string_view extension;
    };
    for (const auto& [format, extension] : {Picture{DrawingFormat::svg, ".svg"},
                                            {DrawingFormat::dot, ".dot"},
                                            {DrawingFormat::text, ".txt"}}) {
        const std::filesystem::path golden =
            std::filesystem::path(TRELLIS_SOURCE_DIR) / "tests" / "golden" / "drawings" /
            (std::string(name.substr(0, name.find('.'))) + std::string(extension));
        const std::string picture = draw(document, format, options);
        if (std::getenv("TRELLIS_UPDATE_GOLDENS") != nullptr) {
            std::ofstream(golden, std::ios::binary) << picture;
            continue;
        }
        INFO(golden.string());
        const std::string recorded = read_file(golden);
        const auto found = lines_of(picture), expected = lines_of(recorded);
        for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
            INFO("line ", i + 1);
            REQUIRE(found[i] == expected[i]);
        }
        CHECK(found.size() == expected.size());
    }
}

}  // namespace trellis::test
