// Writing, and reading what was written.
// SPDX-License-Identifier: MIT
#include "runner/respelled.h"

#include "load/json.h"
#include "load/load.h"
#include "load/xml.h"

namespace trellis {

namespace {

/// Whether reading `text` gives the document that it was written from.
bool says_the_same(const Document& document, FileKind kind, Document::Spelling spelling,
                   const std::string& text) {
    Diagnostics diagnostics;
    const std::optional<Document> again = read({"", text}, diagnostics);
    if (!again || !diagnostics.ok()) { return false; }
    return spelling == Document::Spelling::xml ? same_content(*again, document)
                                               : same_content(*again, canonical(document, kind));
}

}  // namespace

std::optional<std::string> respelled(const Document& document, FileKind kind,
                                     Document::Spelling spelling) {
    std::string text =
        spelling == Document::Spelling::xml ? write_xml(document) : write_json(document, kind);
    if (!says_the_same(document, kind, spelling, text)) { return {}; }
    return text;
}

}  // namespace trellis
