// XML in and out of a Document. The reader accepts a text exactly when it is well-formed XML 1.0 in
// UTF-8 without a document type definition, within the limits; which elements make sense is not
// known here (grammar.h). Covered by tests/load/xml_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trellis {

/// The document that `text` spells, or none and an error at the first place that is not
/// well-formed; takes time proportional to the text and never recurses. `file` is the text's index
/// in `diagnostics`.
///
/// Comments directly before an element become its doc, each without the blanks around it, several
/// joined by line feeds; comments behind the last child are added to their parent's doc, comments
/// around the root to the root's. Processing instructions are passed over. Line ends become line
/// feeds; a line feed or tab in an attribute value stays one, as in BehaviorTree.CPP. A name with a
/// prefix that no xmlns declares is a warning, as in xmllint.
///
/// Errors: "xml-syntax", "duplicate-attribute", "entity", "doctype", "encoding", "character",
/// "too-large". Warning: "unbound-prefix".
std::optional<Document> read_xml(std::string_view text, std::uint32_t file,
                                 Diagnostics& diagnostics, const DocumentLimits& limits = {});

/// The document as XML, ready to be read and edited: two spaces of indentation, an element on one
/// line if it fits in 100 columns, otherwise one attribute per line; docs as comments before their
/// element. read_xml() gives the same content again; written once more, the text is the same.
///
/// "--" may not stand in a comment: a doc's "--" is written "-\-" ("-\-" becomes "-\\-", and so
/// on), which read_xml() undoes. An element with text is written without line breaks around its
/// children, so that the text is kept exactly. The names must be XML names, and all strings UTF-8
/// without the characters that XML forbids, as those of every document that was read are.
std::string write_xml(const Document& document);
/// One element and what is inside, without the XML declaration and the final line feed.
std::string write_xml(const Document& document, ElementId element);

}  // namespace trellis
