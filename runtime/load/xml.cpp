// The XML reader: one pass over the text with an explicit stack, no tree in between.
//
// Why not tinyxml2, which BehaviorTree.CPP reads with: as packaged (9.0.0) it stops 100 elements
// deep, refuses processing instructions below the first line, drops blanks beside CDATA, and
// accepts stray ampersands, unknown entities, raw "<" in values, forbidden characters and two
// roots. A scan that finds all that is a reader already. Covered by tests/load/xml_test.cpp, which
// compares with tinyxml2 and xmllint.
// SPDX-License-Identifier: MIT
#include "load/xml.h"

#include "load/text.h"
#include "load/xml_cursor.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace trellis {

namespace {

class XmlReader : XmlCursor {
public:
    XmlReader(std::string_view source, std::uint32_t file, Diagnostics& to,
              const DocumentLimits& limits)
        : XmlCursor(source, file, to), limits_(limits) {}

    std::optional<Document> read() {
        const auto begin = check_text(text, limits_.bytes, Characters::xml, lines, diagnostics);
        if (!begin) { return std::nullopt; }
        at = *begin;
        reserve();
        document_.strings = text;
        if (!take_declaration()) { return std::nullopt; }
        while (at < text.size()) {
            if (!read_item()) { return std::nullopt; }
        }
        if (!check_end()) { return std::nullopt; }
        return std::move(document_);
    }

private:
    /// An element whose end tag has not come yet. The frames of one depth share their memory.
    struct Frame {
        ElementId element;
        std::string text;          // character data so far
        Where text_where;          // of its first character
        std::size_t bindings = 0;  // of prefixes_ that were there before it
    };

    /// Room for what a file as people write them has; counting what there is takes longer than
    /// making more room in the others. A large one gets room for all that it may hold: what is not
    /// used takes no memory, what is moved to more room takes it twice.
    void reserve() {
        const bool large = text.size() >= large_text;
        const std::size_t bytes_per_element = large ? 4 : 40;    // <a/>
        const std::size_t bytes_per_attribute = large ? 5 : 20;  // a="" and a blank
        document_.elements.reserve(
            std::min<std::size_t>(text.size() / bytes_per_element, limits_.elements));
        document_.attributes.reserve(
            std::min<std::size_t>(text.size() / bytes_per_attribute, limits_.attributes));
        if (large) { document_.strings.reserve(2 * text.size()); }  // nothing decodes to more
    }

    Piece piece_of(std::string_view s) const { return Document::piece_of(text, s); }

    // Content -------------------------------------------------------------------------------------

    bool read_item() {
        if (text[at] != '<') { return read_text(); }
        const char next = at + 1 < text.size() ? text[at + 1] : '\0';
        if (next == '/') { return read_end_tag(); }
        if (next == '?') { return skip_instruction(); }
        if (next != '!') { return read_start_tag(); }
        if (ahead("<!--")) { return read_comment(); }
        if (ahead("<![CDATA[")) { return read_cdata(); }
        if (ahead("<!DOCTYPE")) {
            return fail("doctype", at, "document type definitions are not read: remove it");
        }
        return fail_syntax("expected a comment \"<!--\" or \"<![CDATA[\" after \"<!\"");
    }

    bool outside_root() const { return depth_ == 0; }

    bool fail_outside() {
        if (document_.empty()) { return fail_expected("\"<\" and the root element"); }
        return fail_syntax("expected the end of the file after </" + root_name() + ">, found " +
                           found(rest()));
    }

    std::string root_name() const { return std::string(document_.name(document_.root())); }

    /// The character data of the open element, to which what stands at `from` is added.
    std::string& text_from(std::size_t from) {
        Frame& frame = frames_[depth_ - 1];
        if (frame.text.empty()) { frame.text_where = lines.at(from); }
        return frame.text;
    }

    bool read_text() {
        const std::size_t begin = at;
        // most text is the blanks between tags
        skip_blanks();
        if (!outside_root() && (at == text.size() || text[at] == '<')) {
            append_with_line_feeds(text_from(begin), text.substr(begin, at - begin));
            return true;
        }
        at = begin;
        const std::size_t end = std::min(text.find('<', at), text.size());
        const std::string_view piece = text.substr(begin, end - begin);
        if (outside_root()) {
            skip_blanks();
            return at == end || fail_outside();
        }
        if (const std::size_t cdata_end = piece.find("]]>"); cdata_end != std::string_view::npos) {
            at += cdata_end;
            return fail_syntax(
                "\"]]>\" may stand only at the end of a CDATA section; write \"]]&gt;\"");
        }
        return decode(end, text_from(begin));
    }

    /// Appends the text from here to `end`: references replaced, line ends normalised.
    bool decode(std::size_t end, std::string& to) {
        while (at < end) {
            const std::string_view left = text.substr(at, end - at);
            const std::string_view plain = left.substr(0, left.find('&'));
            append_with_line_feeds(to, plain);
            at += plain.size();
            if (at == end) { break; }
            const Reference reference = read_reference(left.substr(plain.size()));
            if (reference.character == 0) { return fail_reference(reference); }
            append_utf8(to, reference.character);
            at += reference.length;
        }
        return true;
    }

    bool fail_reference(const Reference& reference) {
        const std::string spelling = quoted(rest().substr(0, reference.length));
        if (reference.length == 0) {
            return fail_syntax(ahead("&#") ? "expected a character reference such as \"&#10;\" or "
                                             "\"&#x1F600;\""
                                           : "\"&\" begins no entity; write \"&amp;\"");
        }
        if (ahead("&#")) { return fail("entity", at, spelling + " is no character of XML"); }
        return fail("entity", at,
                    "the entity " + spelling +
                        " is unknown; XML has &lt; &gt; &amp; &quot; and &apos;");
    }

    bool read_cdata() {
        if (outside_root()) { return fail_outside(); }
        const std::size_t begin = at + 9;
        const std::size_t end = text.find("]]>", begin);
        if (end == std::string_view::npos) {
            return fail_syntax("the CDATA section is never closed with \"]]>\"");
        }
        // only line ends are normalised: an ampersand is itself
        append_with_line_feeds(text_from(begin), text.substr(begin, end - begin));
        at = end + 3;
        return true;
    }

    bool skip_instruction() {
        const std::size_t begin = at;
        at += 2;
        const std::string_view target = take_name();
        if (target.empty()) {
            return fail_expected("the name of a processing instruction after \"<?\"");
        }
        if (target.size() == 3 && (target[0] | 0x20) == 'x' && (target[1] | 0x20) == 'm' &&
            (target[2] | 0x20) == 'l') {
            at = begin;
            return fail_syntax(
                "the XML declaration may stand only at the very beginning of the file");
        }
        if (!ahead("?>") && !skip_blanks()) { return fail_expected("a blank or \"?>\""); }
        const std::size_t end = text.find("?>", at);
        if (end == std::string_view::npos) {
            at = begin;
            return fail_syntax("the processing instruction is never closed with \"?>\"");
        }
        at = end + 2;
        return true;
    }

    // Comments ------------------------------------------------------------------------------------

    bool read_comment() {
        const std::size_t begin = at + 4;
        const std::size_t end = text.find("--", begin);
        if (end == std::string_view::npos) {
            return fail_syntax("the comment is never closed with \"-->\"");
        }
        at = end;
        if (!ahead("-->")) { return fail_syntax("\"--\" may not stand inside a comment"); }
        at += 3;
        add_doc(text.substr(begin, end - begin));
        return true;
    }

    /// Adds a comment to docs_. "-\-" stands for "--": of the backslashes between two hyphens, one
    /// is the writer's.
    void add_doc(std::string_view comment) {
        const std::string doc = normal_doc(comment);
        if (doc.empty()) { return; }
        if (!docs_.empty()) { docs_ += '\n'; }
        for (std::size_t i = 0; i < doc.size(); ++i) {
            docs_ += doc[i];
            if (doc[i] != '-') { continue; }
            const std::size_t hyphen = doc.find_first_not_of('\\', i + 1);
            if (hyphen != std::string::npos && hyphen > i + 1 && doc[hyphen] == '-') { ++i; }
        }
    }

    /// Adds docs_ to the doc of an element that has been opened.
    void append_docs(ElementId e) {
        if (docs_.empty()) { return; }
        std::string doc(document_.doc(e));
        if (!doc.empty()) { doc += '\n'; }
        document_.elements[e.index].doc = document_.add_string(doc + docs_);
        docs_.clear();
    }

    // Tags ----------------------------------------------------------------------------------------

    /// Whether one more element may begin here; an error if not.
    bool check_limits() {
        if (outside_root() && !document_.empty()) {
            return fail_syntax("expected one root element, found a second one after </" +
                               root_name() + ">");
        }
        if (document_.elements.size() >= limits_.elements) {
            return fail("too-large", at,
                        "the file has more than " + std::to_string(limits_.elements) + " elements");
        }
        if (depth_ >= limits_.depth) {
            return fail("too-large", at,
                        "elements are nested more than " + std::to_string(limits_.depth) + " deep");
        }
        return true;
    }

    ElementId open_element(std::string_view name, std::size_t offset) {
        if (depth_ == frames_.size()) { frames_.emplace_back(); }
        const ElementId parent = outside_root() ? ElementId{} : frames_[depth_ - 1].element;
        const ElementId e = document_.open(parent, piece_of(name), lines.at(offset));
        Frame& frame = frames_[depth_++];
        frame.element = e;
        frame.text.clear();
        frame.bindings = bound_.size();
        append_docs(e);
        return e;
    }

    bool read_start_tag() {
        if (!check_limits()) { return false; }
        const std::size_t name_at = ++at;
        const std::string_view name = take_name();
        if (name.empty()) {
            return fail_expected("the name of an element after \"<\" (a \"<\" in text is written "
                                 "\"&lt;\")");
        }
        const ElementId e = open_element(name, name_at);
        while (true) {
            const bool blank = skip_blanks();
            if (ahead(">")) {
                ++at;
                return check_attributes(e);
            }
            if (ahead("/>")) {
                at += 2;
                if (!check_attributes(e)) { return false; }
                close_element();
                return true;
            }
            if (!read_attribute(e, blank)) { return false; }
        }
    }

    bool read_attribute(ElementId e, bool after_blank) {
        const std::size_t begin = at;
        const std::string_view name = take_name();
        if (name.empty()) {
            return fail_expected("an attribute, \">\" or \"/>\" in <" +
                                 std::string(document_.name(e)) + ">");
        }
        if (!after_blank) {
            at = begin;
            return fail_expected("a blank before the attribute");
        }
        const auto raw = take_value(name);
        if (!raw) { return false; }
        const std::size_t past = at;
        const std::size_t value_at = past - 1 - raw->text.size();
        Piece value = piece_of(raw->text);
        if (!raw->plain) {
            at = value_at;
            value.begin = static_cast<std::uint32_t>(document_.strings.size());
            if (!decode(past - 1, document_.strings)) { return false; }
            at = past;
            value.size = static_cast<std::uint32_t>(document_.strings.size()) - value.begin;
        }
        if (document_.attributes.size() >= limits_.attributes) {
            return fail("too-large", begin,
                        "the file has more than " + std::to_string(limits_.attributes) +
                            " attributes");
        }
        const Where where = lines.at(begin);
        document_.add_attribute(e, piece_of(name), value, where, lines.at(value_at));
        if (name.starts_with("xmlns:")) { bind(name.substr(6)); }
        return true;
    }

    /// Finds attributes of the same name and, once all are known, undeclared prefixes.
    bool check_attributes(ElementId e) {
        if (const Attribute* const second = document_.repeated(e)) {
            diagnostics.error("duplicate-attribute", second->where,
                              "the attribute " + quoted(document_.string(second->name)) +
                                  " is given twice in <" + std::string(document_.name(e)) + ">");
            return false;
        }
        check_prefix(document_.name(e), document_.at(e).where);
        for (const Attribute& a : document_.attributes_of(e)) {
            check_prefix(document_.string(a.name), a.where);
        }
        return true;
    }

    bool read_end_tag() {
        const std::size_t begin = at;
        at += 2;
        const std::string_view name = take_name();
        if (outside_root()) {
            at = begin;
            return document_.empty() ? fail_outside()
                                     : fail_syntax("</" + std::string(name) +
                                                   "> closes nothing: no element is open");
        }
        const ElementId e = frames_[depth_ - 1].element;
        if (name != document_.name(e)) {
            const std::string expected(document_.name(e));
            at = begin;
            const Where opened = document_.at(e).where;
            return fail_syntax("expected </" + expected + "> for the <" + expected + "> of line " +
                               std::to_string(opened.line) + ", found " +
                               (name.empty() ? quoted("</") : "</" + std::string(name) + ">"));
        }
        skip_blanks();
        if (!ahead(">")) { return fail_expected("\">\" at the end of the tag"); }
        ++at;
        close_element();
        return true;
    }

    void close_element() {
        const Frame& frame = frames_[--depth_];
        append_docs(frame.element);
        if (!is_blank(frame.text)) {
            const Piece piece = document_.add_string(frame.text);
            Element& element = document_.elements[frame.element.index];
            element.text = piece;
            element.text_where = frame.text_where;
        }
        document_.close(frame.element);
        for (; bound_.size() > frame.bindings; bound_.pop_back()) {
            --prefixes_[bound_.back()];
        }
    }

    bool check_end() {
        if (document_.empty()) {
            return fail_syntax(is_blank(text) ? "the file is empty: expected an element"
                                              : "expected an element, found the end of the file");
        }
        if (depth_ != 0) {
            const Element& open = document_.at(frames_[depth_ - 1].element);
            const std::string name(document_.string(open.name));
            diagnostics.error("xml-syntax", open.where,
                              "<" + name + "> is never closed: expected </" + name +
                                  "> before the end of the file");
            return false;
        }
        append_docs(document_.root());
        return true;
    }

    // Namespaces ----------------------------------------------------------------------------------

    void bind(std::string_view prefix) {
        ++prefixes_[prefix];
        bound_.push_back(prefix);
    }

    void check_prefix(std::string_view name, Where where) {
        const std::size_t colon = name.find(':');
        if (colon == std::string_view::npos || colon == 0) { return; }
        const std::string_view prefix = name.substr(0, colon);
        if (prefix == "xml" || prefix == "xmlns") { return; }
        const auto declared = prefixes_.find(prefix);
        if (declared != prefixes_.end() && declared->second != 0) { return; }
        diagnostics.warning("unbound-prefix", where,
                            "no xmlns:" + std::string(prefix) + " declares the prefix of " +
                                quoted(name));
    }

    DocumentLimits limits_;
    Document document_;
    std::vector<Frame> frames_;  // those below depth_ are open
    std::size_t depth_ = 0;
    std::string docs_;  // the comments since the last tag
    // how often each prefix is declared by the open elements; the keys are pieces of text
    std::unordered_map<std::string_view, std::uint32_t> prefixes_;
    std::vector<std::string_view> bound_;  // in the order in which they were declared
};

}  // namespace

std::optional<Document> read_xml(std::string_view text, std::uint32_t file,
                                 Diagnostics& diagnostics, const DocumentLimits& limits) {
    return XmlReader(text, file, diagnostics, limits).read();
}

}  // namespace trellis
