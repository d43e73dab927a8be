// Building, searching and comparing documents, and finding a character of a value in its source.
// Covered by tests/load/document_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/document.h"

#include "load/text.h"

#include <algorithm>

namespace trellis {

const Attribute* Document::find(ElementId e, std::string_view attribute) const {
    for (const Attribute& a : attributes_of(e)) {
        if (string(a.name) == attribute) { return &a; }
    }
    return nullptr;
}

std::string_view Document::value(ElementId e, std::string_view attribute,
                                 std::string_view otherwise) const {
    const Attribute* const a = find(e, attribute);
    return a == nullptr ? otherwise : string(a->value);
}

const Attribute* Document::repeated(ElementId e) const {
    const AttributeRange all = attributes_of(e);
    constexpr std::uint32_t few = 12;  // up to here comparing all pairs is faster than sorting
    if (at(e).attribute_count <= few) {
        for (const Attribute& a : all) {
            for (const Attribute* b = all.begin(); b != &a; ++b) {
                if (string(a.name) == string(b->name)) { return &a; }
            }
        }
        return nullptr;
    }
    std::vector<const Attribute*> sorted;
    for (const Attribute& a : all) {
        sorted.push_back(&a);
    }
    const auto name = [this](const Attribute* a) { return string(a->name); };
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Attribute* a, const Attribute* b) { return name(a) < name(b); });
    const auto same = std::adjacent_find(
        sorted.begin(), sorted.end(),
        [&](const Attribute* a, const Attribute* b) { return name(a) == name(b); });
    return same == sorted.end() ? nullptr : *(same + 1);
}

std::size_t Document::child_count(ElementId e) const {
    std::size_t n = 0;
    for ([[maybe_unused]] const ElementId child : children(e)) {
        ++n;
    }
    return n;
}

Piece Document::add_string(std::string_view s) {
    const Piece piece{static_cast<std::uint32_t>(strings.size()),
                      static_cast<std::uint32_t>(s.size())};
    strings += s;
    return piece;
}

ElementId Document::open(ElementId parent, Piece name, Where where) {
    const ElementId e{static_cast<std::uint32_t>(elements.size())};
    Element element;
    element.name = name;
    element.where = where;
    element.parent = parent;
    element.end = {e.index + 1};
    element.first_attribute = static_cast<std::uint32_t>(attributes.size());
    elements.push_back(element);
    return e;
}

void Document::add_attribute(ElementId e, Piece name, Piece value, Where where, Where value_where,
                             bool bare) {
    attributes.push_back({name, value, where, value_where, bare});
    ++elements[e.index].attribute_count;
}

std::optional<FileKind> file_kind(const Document& document) {
    if (document.empty()) { return std::nullopt; }
    if (document.name(document.root()) == "root") { return FileKind::tree; }
    if (document.name(document.root()) == "scxml") { return FileKind::machine; }
    return std::nullopt;
}

ElementId copy_subtree(const Document& from, ElementId e, Document& to, ElementId parent) {
    const auto first = static_cast<std::uint32_t>(to.elements.size());
    for (std::uint32_t i = e.index; i < from.at(e).end.index; ++i) {
        const Element& source = from.elements[i];
        const ElementId inside =
            i == e.index ? parent : ElementId{source.parent.index - e.index + first};
        const ElementId copy = to.open(inside, from.string(source.name), source.where);
        to.elements[copy.index].doc = to.add_string(from.string(source.doc));
        to.elements[copy.index].text = to.add_string(from.string(source.text));
        to.elements[copy.index].text_where = source.text_where;
        to.elements[copy.index].end = {source.end.index - e.index + first};
        for (const Attribute& a : from.attributes_of({i})) {
            to.add_attribute(copy, from.string(a.name), from.string(a.value), a.where,
                             a.value_where, a.bare);
        }
    }
    return {first};
}

bool same_content(const Document& a, const Document& b) {
    const auto same_attribute = [&](const Attribute& x, const Attribute& y) {
        return a.string(x.name) == b.string(y.name) && a.string(x.value) == b.string(y.value);
    };
    if (a.elements.size() != b.elements.size()) { return false; }
    for (std::uint32_t i = 0; i < a.elements.size(); ++i) {
        const Element& x = a.elements[i];
        const Element& y = b.elements[i];
        const auto xs = a.attributes_of({i});
        const auto ys = b.attributes_of({i});
        if (a.string(x.name) != b.string(y.name) || a.string(x.doc) != b.string(y.doc) ||
            a.string(x.text) != b.string(y.text) || x.end != y.end || x.parent != y.parent ||
            !std::equal(xs.begin(), xs.end(), ys.begin(), ys.end(), same_attribute)) {
            return false;
        }
    }
    return true;
}

namespace {

/// Where decoded text is in its source: `at` is the next byte to decode. Each advance() passes one
/// unit, which may be one byte or a whole entity, escape or line break, and says what it decodes
/// to.
struct SourceWalk {
    std::string_view source;
    std::size_t at = 0;
    bool in_cdata = false;  // XML only

    std::string_view rest() const { return source.substr(at); }

    /// Passes what stands for no text: comments, instructions and the edges of CDATA sections.
    void skip_markup() {
        while (true) {
            if (in_cdata) {
                if (!rest().starts_with("]]>")) { return; }
                in_cdata = false;
                at += 3;
            } else if (rest().starts_with("<![CDATA[")) {
                in_cdata = true;
                at += 9;
            } else if (rest().starts_with("<!--") || rest().starts_with("<?")) {
                const std::string_view close = rest()[1] == '!' ? "-->" : "?>";
                const std::size_t end = source.find(close, at + 2);
                at = end == std::string_view::npos ? source.size() : end + close.size();
            } else {
                return;
            }
        }
    }

    /// Bytes of decoded text that the next unit stands for; 0 at the end.
    std::size_t advance_xml() {
        if (at >= source.size() || (!in_cdata && source[at] == '<')) { return 0; }
        if (source[at] == '&' && !in_cdata) {
            const Reference reference = read_reference(rest());
            at += std::max<std::size_t>(reference.length, 1);
            return std::max<std::size_t>(utf8_size(reference.character), 1);
        }
        at += rest().starts_with("\r\n") ? 2 : 1;
        return 1;
    }

    std::size_t advance_json() {
        if (at >= source.size()) { return 0; }
        if (source[at] != '\\') {
            ++at;
            return 1;
        }
        const auto unit = [this] {  // the \uXXXX at `at`
            char32_t value = 0;
            for (const char c : rest().substr(2, 4)) {
                value = value * 16 + hex_digit(c);
            }
            return value;
        };
        if (!rest().starts_with("\\u")) {
            at = std::min(at + 2, source.size());
            return 1;
        }
        const bool pair = unit() >= 0xD800 && unit() < 0xDC00;
        const std::size_t size = pair ? 4 : utf8_size(unit());
        at = std::min(at + (pair ? 12 : 6), source.size());
        return size;
    }
};

std::size_t offset_of(std::string_view source, Where where) {
    std::size_t line_start = 0;
    for (std::uint32_t line = 1; line < where.line; ++line) {
        const std::size_t end = source.find('\n', line_start);
        if (end == std::string_view::npos) { return source.size(); }
        line_start = end + 1;
    }
    return std::min(line_start + where.column - 1, source.size());
}

}  // namespace

Where where_in(std::string_view source, Document::Spelling spelling, Where begin,
               std::size_t offset) {
    if (begin.line == 0 || begin.column == 0) { return begin; }
    const bool xml = spelling == Document::Spelling::xml;
    const std::size_t first = offset_of(source, begin);
    SourceWalk walk{source, first};
    walk.in_cdata = xml && source.substr(0, walk.at).ends_with("<![CDATA[");
    std::size_t decoded = 0;
    while (true) {
        if (xml) { walk.skip_markup(); }
        if (decoded >= offset) { break; }
        const std::size_t before = walk.at;
        const std::size_t size = xml ? walk.advance_xml() : walk.advance_json();
        if (size == 0) { break; }
        // inside a character that one entity or escape stands for: the place is the entity
        if (decoded + size > offset) {
            walk.at = before;
            break;
        }
        decoded += size;
    }

    const std::string_view passed = source.substr(first, walk.at - first);
    const auto lines = static_cast<std::uint32_t>(std::count(passed.begin(), passed.end(), '\n'));
    const auto behind = static_cast<std::uint32_t>(passed.size() - (passed.rfind('\n') + 1));
    return {begin.file, begin.line + lines, lines == 0 ? begin.column + behind : behind + 1};
}

}  // namespace trellis
