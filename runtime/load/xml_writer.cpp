// The XML writer. Covered by tests/load/xml_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/xml.h"

#include <algorithm>
#include <string>

namespace trellis {

namespace {

constexpr std::size_t line_columns = 100;
constexpr std::size_t indent_columns = 2;

/// A value in the quotes that need fewer escapes. What a reader would change or refuse is escaped:
/// line feeds and tabs too, which other readers turn into spaces.
void append_value(std::string& out, std::string_view value) {
    const bool single =
        value.find('"') != std::string_view::npos && value.find('\'') == std::string_view::npos;
    const char quote = single ? '\'' : '"';
    out += quote;
    for (const char c : value) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '"': out += single ? "\"" : "&quot;"; break;
        case '\n': out += "&#10;"; break;
        case '\t': out += "&#9;"; break;
        case '\r': out += "&#13;"; break;
        default: out += c;
        }
    }
    out += quote;
}

void append_text(std::string& out, std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '\r': out += "&#13;"; break;
        case '>': out += text.substr(0, i).ends_with("]]") ? "&gt;" : ">"; break;
        default: out += text[i];
        }
    }
}

/// A doc as a comment. Its lines are not indented anew: they would not be read back as they were.
void append_comment(std::string& out, std::string_view doc) {
    out += "<!-- ";
    for (std::size_t i = 0; i < doc.size(); ++i) {
        out += doc[i];
        if (doc[i] != '-') { continue; }
        const std::size_t next = doc.find_first_not_of('\\', i + 1);
        if (next != std::string_view::npos && doc[next] == '-') { out += '\\'; }
    }
    out += " -->";
}

std::size_t columns(std::string_view s) {
    return static_cast<std::size_t>(std::count_if(s.begin(), s.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

class XmlWriter {
public:
    explicit XmlWriter(const Document& document) : document_(document) {}

    /// Writes the subtree of `root`, closing each element where its interval ends.
    std::string write(ElementId root, std::string out) {
        out_ = std::move(out);
        struct Open {
            ElementId element;
            bool inside_text;
        };
        std::vector<Open> open;
        const std::uint32_t end = document_.at(root).end.index;
        for (std::uint32_t i = root.index; i <= end; ++i) {
            while (!open.empty() && document_.at(open.back().element).end.index == i) {
                const Open closed = open.back();
                open.pop_back();
                if (document_.text(closed.element).empty()) { break_line(open.size()); }
                out_ += "</" + std::string(document_.name(closed.element)) + ">";
            }
            if (i == end) { break; }
            const ElementId e{i};
            // beside text, blanks would become part of it
            const bool beside_text = !open.empty() && open.back().inside_text;
            write_start(e, open.size(), beside_text);
            if (document_.at(e).end.index > i + 1) {
                open.push_back({e, !document_.text(e).empty()});
            }
        }
        return std::move(out_);
    }

private:
    void break_line(std::size_t depth) {
        if (!out_.empty()) { out_ += '\n'; }
        out_.append(depth * indent_columns, ' ');
    }

    void write_start(ElementId e, std::size_t depth, bool beside_text) {
        const std::string_view doc = document_.doc(e);
        const std::string_view text = document_.text(e);
        if (!doc.empty()) {
            if (!beside_text) { break_line(depth); }
            append_comment(out_, doc);
        }
        if (!beside_text) { break_line(depth); }

        const bool leaf = document_.at(e).end.index == e.index + 1;
        std::string close = leaf && text.empty() ? "/>" : ">";
        append_text(close, text);
        if (leaf && !text.empty()) { close += "</" + std::string(document_.name(e)) + ">"; }
        write_attributes(e, depth, columns(close.substr(0, close.find('\n'))));
        out_ += close;
    }

    /// "<Name" and the attributes: on one line if that, indented and with `close_columns` behind
    /// it, fits; otherwise one per line, aligned behind the name.
    void write_attributes(ElementId e, std::size_t depth, std::size_t close_columns) {
        out_ += '<';
        out_ += document_.name(e);
        const std::size_t name_columns = columns(document_.name(e));
        const std::size_t begin = out_.size();
        for (const Attribute& a : document_.attributes_of(e)) {
            append_attribute(" ", a);
        }
        const std::size_t width = depth * indent_columns + 1 + name_columns +
                                  columns(std::string_view(out_).substr(begin)) + close_columns;
        if (width <= line_columns || document_.at(e).attribute_count < 2) { return; }

        out_.resize(begin);
        const std::string aligned =
            "\n" + std::string(depth * indent_columns + 1 + name_columns + 1, ' ');
        std::string_view before = " ";
        for (const Attribute& a : document_.attributes_of(e)) {
            append_attribute(before, a);
            before = aligned;
        }
    }

    void append_attribute(std::string_view before, const Attribute& a) {
        out_ += before;
        out_ += document_.string(a.name);
        out_ += '=';
        append_value(out_, document_.string(a.value));
    }

    const Document& document_;
    std::string out_;
};

}  // namespace

std::string write_xml(const Document& document) {
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
    if (document.empty()) { return out + "\n"; }
    return XmlWriter(document).write(document.root(), std::move(out)) + "\n";
}

std::string write_xml(const Document& document, ElementId element) {
    return XmlWriter(document).write(element, {});
}

}  // namespace trellis
