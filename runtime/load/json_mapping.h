// What the two mappings between JSON and documents share: elements with attributes, docs and texts,
// out of and into JSON values. Included by the json_*.cpp files only. Covered by
// tests/load/json_trees_test.cpp and json_machines_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"
#include "load/json_tree.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// Names of members: tables and arguments.
using Names = std::span<const std::string_view>;
bool contains(Names names, std::string_view name);
/// Whether a member is for other programs ("$schema"): it is passed over.
inline bool is_foreign(std::string_view key) {
    return key.starts_with('$');
}

/// Makes a document from JSON values, in document order.
class ElementReader {
public:
    using Kind = JsonTree::Kind;

    ElementReader(const JsonTree& json, Diagnostics& diagnostics, const DocumentLimits& limits);

    const JsonTree& json() const { return json_; }
    const Document& document() const { return document_; }
    /// The document, or none if there was an error.
    std::optional<Document> take();

    /// Opens an element, or makes an error if `name` is no name or the limits are reached; what is
    /// inside may be added all the same.
    ElementId open(ElementId parent, std::string_view name, Where where);
    void close(ElementId e);

    /// Takes text or a list of pieces of text as the element's text, and text as its doc.
    void set_text(ElementId e, JsonId value);
    void set_doc(ElementId e, JsonId value);
    /// Takes a member as an attribute. Its value is text, a number, true, false or null; with
    /// `list` also an array of texts, which become one with blanks between.
    void add_attribute(ElementId e, std::string_view name, JsonId member, bool list = false);
    /// Takes text that is no member: what the JSON leaves unsaid.
    void add_attribute(ElementId e, std::string_view name, std::string_view value, Where where) {
        document_.add_attribute(e, name, value, where, where);
    }
    /// Makes an error if two attributes of `e` have one name: they came from different objects.
    void check_unique(ElementId e);
    /// Opens the elements that `fragment` spells in XML inside `e`.
    void add_xml(ElementId e, JsonId fragment);

    /// The member, which must be an array: an error if it is none, none if there is no such member.
    JsonId array_member(JsonId object, std::string_view key);
    /// Whether the value is of that kind; if not, an error: "\"trees\" must be an array, found …".
    bool expect(JsonId value, Kind kind);
    /// Makes a structural error "json-type" or "json-member" at the value or at its key.
    void fail_type(JsonId value, std::string message);
    void fail_member(JsonId value, std::string message);
    /// `"trees"`, or `a value of "trees"` inside the array.
    std::string title(JsonId value) const;
    /// "a number", "text", "an array", …: of the value.
    std::string_view article(JsonId value) const;

private:
    const JsonTree& json_;
    Diagnostics& diagnostics_;
    DocumentLimits limits_;
    Document document_;
    std::size_t errors_before_;
    std::uint32_t depth_ = 0;
};

/// The one array or object that is being filled, and what is written into it.
class ElementWriter {
public:
    using Kind = JsonTree::Kind;

    explicit ElementWriter(const Document& document) : document_(document) {}

    const Document& document() const { return document_; }
    JsonTree take() { return std::move(json_); }

    JsonId open(JsonId parent, std::string_view key, Kind kind) {
        return json_.add(parent, key, kind);
    }
    void close(JsonId v) { json_.close(v); }
    void add_text(JsonId parent, std::string_view key, std::string_view text) {
        json_.add(parent, key, Kind::string, text);
    }
    /// As a number, true or false if `text` is the shortest spelling of one, else as text.
    void add_bare(JsonId parent, std::string_view key, std::string_view text);
    /// The "doc" of an element, with the docs that were carried to it; nothing if it has none.
    void add_doc(JsonId object, ElementId e);
    /// Keeps the doc of an element that gets no object of its own, for the next add_doc().
    void carry_doc(ElementId e);

private:
    const Document& document_;
    JsonTree json_;
    std::string carried_;
};

/// Whether the text is true, false or a number in the one spelling that JSON libraries give it:
/// no exponent, no superfluous zero, at most 15 digits (all of which a double keeps).
bool is_bare(std::string_view text);

// The mappings ------------------------------------------------------------------------------------

std::optional<Document> tree_from_json(const JsonTree& json, Diagnostics& diagnostics,
                                       const DocumentLimits& limits);
std::optional<Document> machine_from_json(const JsonTree& json, Diagnostics& diagnostics,
                                          const DocumentLimits& limits);
JsonTree tree_to_json(const Document& document);
JsonTree machine_to_json(const Document& document);

}  // namespace trellis
