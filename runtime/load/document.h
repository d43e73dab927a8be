// A behaviour file as data, whatever it was written in: elements in document order, their
// attributes, their places. XML and JSON are two spellings of it (xml.h, json.h); what the names
// mean is not known here (grammar.h). Covered by tests/load/document_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "load/diagnostics.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

using ElementId = Id<struct ElementTag>;

/// A piece of Document::strings. Keeps its meaning while the document is copied or moved.
struct Piece {
    std::uint32_t begin = 0;
    std::uint32_t size = 0;
};

struct Attribute {
    Piece name;         // as written, with its namespace prefix
    Piece value;        // decoded: entities and escapes replaced
    Where where;        ///< of the name
    Where value_where;  ///< of the value's first character, inside the quotes
    /// JSON only: the value was written as a number, true, false or null (else a string).
    bool bare = false;
};

struct Element {
    Piece name;
    Piece doc;    ///< the comments directly before it (XML), its "doc" (JSON); empty if none
    Piece text;   ///< character data directly inside it, all pieces joined; empty if only blanks
    Where where;  ///< of the name (XML), of the value of "type" or of the brace (JSON)
    Where text_where;  ///< of the first character of `text`
    ElementId parent;  ///< none for the root
    ElementId end;     ///< one past the last element inside this one
    std::uint32_t first_attribute = 0;
    std::uint32_t attribute_count = 0;
};

/// Elements in document order: the subtree of element e is the interval [e, end(e)). Regular: may
/// be copied, holds no pointers, refers to no other object.
class Document {
public:
    /// How it was written; decides how where_in() finds a character.
    enum class Spelling : std::uint8_t { xml, json };

    Spelling spelling = Spelling::xml;
    /// The text that was read (XML; else nothing), then every name, value and text that does not
    /// stand in it as it is.
    std::string strings;
    std::vector<Element> elements;
    std::vector<Attribute> attributes;  ///< those of one element are neighbours, in written order

    bool empty() const { return elements.empty(); }
    ElementId root() const { return {0}; }
    const Element& at(ElementId e) const { return elements[e.index]; }
    std::string_view string(Piece p) const { return {strings.data() + p.begin, p.size}; }
    std::string_view name(ElementId e) const { return string(at(e).name); }
    std::string_view doc(ElementId e) const { return string(at(e).doc); }
    std::string_view text(ElementId e) const { return string(at(e).text); }

    /// The attributes of `e`, in written order: for (const Attribute& a : doc.attributes_of(e)).
    struct AttributeRange {
        const Attribute* first;
        const Attribute* last;
        const Attribute* begin() const { return first; }
        const Attribute* end() const { return last; }
    };
    AttributeRange attributes_of(ElementId e) const {
        const Attribute* first = attributes.data() + at(e).first_attribute;
        return {first, first + at(e).attribute_count};
    }
    /// The attribute of that name, or null.
    const Attribute* find(ElementId e, std::string_view attribute) const;
    /// Its value, or `otherwise`. The view lives as long as this document.
    std::string_view value(ElementId e, std::string_view attribute,
                           std::string_view otherwise = {}) const;

    /// The second of two attributes of `e` that have the same name, or null.
    const Attribute* repeated(ElementId e) const;

    /// The children of `e`, in document order: for (ElementId c : doc.children(e)).
    class ChildRange {
    public:
        class Iterator {
        public:
            Iterator(const Document* document, ElementId at) : document_(document), at_(at) {}
            ElementId operator*() const { return at_; }
            Iterator& operator++() {
                at_ = document_->at(at_).end;
                return *this;
            }
            friend bool operator!=(const Iterator& a, const Iterator& b) { return a.at_ != b.at_; }

        private:
            const Document* document_;
            ElementId at_;
        };
        ChildRange(const Document* document, ElementId first, ElementId last)
            : document_(document), first_(first), last_(last) {}
        Iterator begin() const { return {document_, first_}; }
        Iterator end() const { return {document_, last_}; }

    private:
        const Document* document_;
        ElementId first_, last_;
    };
    ChildRange children(ElementId e) const { return {this, {e.index + 1}, at(e).end}; }
    std::size_t child_count(ElementId e) const;

    // Building ----------------------------------------------------------------------------------

    Piece add_string(std::string_view s);
    /// The piece of `strings` that `s`, a view into the text at their start, is.
    static Piece piece_of(std::string_view text, std::string_view s) {
        return {static_cast<std::uint32_t>(s.data() - text.data()),
                static_cast<std::uint32_t>(s.size())};
    }
    /// Opens an element inside `parent` (none for the root). Add its attributes before its first
    /// child, and close() it after its last.
    ElementId open(ElementId parent, Piece name, Where where);
    ElementId open(ElementId parent, std::string_view name, Where where) {
        return open(parent, add_string(name), where);
    }
    void add_attribute(ElementId e, Piece name, Piece value, Where where, Where value_where,
                       bool bare = false);
    void add_attribute(ElementId e, std::string_view name, std::string_view value, Where where,
                       Where value_where, bool bare = false) {
        const Piece piece = add_string(name);
        add_attribute(e, piece, add_string(value), where, value_where, bare);
    }
    void close(ElementId e) {
        elements[e.index].end = {static_cast<std::uint32_t>(elements.size())};
    }
};

/// The place of byte `offset` of the decoded value that begins at `begin` in `source`: entities,
/// comments and CDATA (XML) and escapes (JSON) are walked over, so that an error inside an
/// expression has its column. Stops at the end of the source and, in XML, at a tag. Takes time
/// proportional to the source: for errors only.
Where where_in(std::string_view source, Document::Spelling spelling, Where begin,
               std::size_t offset);

/// What a file describes; decides how it is written in JSON (json.h).
enum class FileKind : std::uint8_t { tree, machine };

/// The kind that the root's name tells: <root> of a tree file, <scxml> of a machine; none if it is
/// neither.
std::optional<FileKind> file_kind(const Document& document);

/// Appends a copy of the subtree of `e` to `to`, inside `parent` (none for the root), and returns
/// its root there. `to` must be another document.
ElementId copy_subtree(const Document& from, ElementId e, Document& to, ElementId parent);

/// Equal but for the places, the spelling and the layout of `strings`: the same names, values,
/// texts and docs in the same order. What "lossless" means in the tests of the converters.
bool same_content(const Document& a, const Document& b);

/// Limits on what is read; more is a diagnostic. They bound the time, memory and stack of a load: a
/// file of nothing but elements or attributes is refused before it takes 200 MB.
struct DocumentLimits {
    std::size_t bytes = std::size_t{64} << 20;  ///< of text; never more than 2 GiB
    std::uint32_t depth = 256;                  ///< nested elements, as in BehaviorTree.CPP
    std::uint32_t elements = 1'100'000;
    std::uint32_t attributes = 2'000'000;
    std::uint32_t values = 2'500'000;  ///< of JSON: numbers, texts, arrays, objects
};

}  // namespace trellis
