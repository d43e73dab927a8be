// Reading with Diagnostics of its own.
// SPDX-License-Identifier: MIT
#include "load/json_documents.h"

#include "load/json.h"
#include "load/xml.h"

#include <doctest/doctest.h>

#include <optional>

namespace trellis::test {

Document from_xml(std::string_view text) {
    Diagnostics diagnostics;
    diagnostics.add_file("f.xml", text);
    const std::optional<Document> document = read_xml(text, 0, diagnostics);
    REQUIRE_MESSAGE(document, diagnostics.render());
    return *document;
}

Document from_json(std::string_view text, FileKind kind) {
    Diagnostics diagnostics;
    diagnostics.add_file("f.json", text);
    const std::optional<Document> document = read_json(text, 0, kind, diagnostics);
    REQUIRE_MESSAGE(document, diagnostics.render());
    return *document;
}

std::string json_faults(std::string_view text, FileKind kind) {
    Diagnostics diagnostics;
    diagnostics.add_file("f.json", text);
    const std::optional<Document> document = read_json(text, 0, kind, diagnostics);
    CHECK(document.has_value() == diagnostics.ok());
    std::string out;
    for (const Diagnostic& d : diagnostics.all()) {
        const std::string one = diagnostics.render(d);
        out += one.substr(7, one.find('\n') - 6);
    }
    return out;
}

}  // namespace trellis::test
