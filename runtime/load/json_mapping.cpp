// Elements out of and into JSON values. Covered by tests/load/json_trees_test.cpp and
// json_machines_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/json_mapping.h"

#include "load/text.h"
#include "load/xml.h"

#include <algorithm>
#include <utility>

namespace trellis {

bool contains(Names names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

ElementReader::ElementReader(const JsonTree& json, Diagnostics& diagnostics,
                             const DocumentLimits& limits)
    : json_(json), diagnostics_(diagnostics), limits_(limits),
      errors_before_(diagnostics.errors()) {
    document_.spelling = Document::Spelling::json;
    document_.strings.reserve(json.strings.size());
}

std::optional<Document> ElementReader::take() {
    if (diagnostics_.errors() != errors_before_) { return std::nullopt; }
    return std::move(document_);
}

ElementId ElementReader::open(ElementId parent, std::string_view name, Where where) {
    if (!is_name(name)) {
        diagnostics_.structural_error("bad-name", where,
                                      quoted(name) + " is no name of an element");
    }
    if (++depth_ == limits_.depth + 1) {
        diagnostics_.error("too-large", where,
                           "elements are nested more than " + std::to_string(limits_.depth) +
                               " deep");
    }
    if (document_.elements.size() == limits_.elements) {
        diagnostics_.error("too-large", where,
                           "the file has more than " + std::to_string(limits_.elements) +
                               " elements");
    }
    return document_.open(parent, name, where);
}

void ElementReader::close(ElementId e) {
    --depth_;
    document_.close(e);
}

void ElementReader::set_text(ElementId e, JsonId value) {
    std::string text;
    Where where = json_.at(value).where;
    if (json_.kind(value) == Kind::array) {
        for (const JsonId piece : json_.children(value)) {
            if (json_.kind(piece) != Kind::string) { continue; }
            if (text.empty()) { where = json_.at(piece).where; }
            text += json_.text(piece);
        }
    } else if (expect(value, Kind::string)) {
        text = json_.text(value);
    }
    if (is_blank(text)) { return; }
    const Piece piece = document_.add_string(text);
    document_.elements[e.index].text = piece;
    document_.elements[e.index].text_where = where;
}

void ElementReader::set_doc(ElementId e, JsonId value) {
    if (!expect(value, Kind::string)) { return; }
    const Piece piece = document_.add_string(normal_doc(json_.text(value)));
    document_.elements[e.index].doc = piece;
}

void ElementReader::add_attribute(ElementId e, std::string_view name, JsonId member, bool list) {
    const JsonValue& value = json_.at(member);
    const Where where = value.key_where.line != 0 ? value.key_where : value.where;
    if (!is_name(name)) {
        diagnostics_.structural_error("bad-name", where,
                                      quoted(name) + " is no name of an attribute");
        return;
    }
    if (value.kind == Kind::object || (value.kind == Kind::array && !list)) {
        fail_type(member, title(member) + " must be text, a number, true or false, found " +
                              std::string(article(member)));
        return;
    }
    if (value.kind != Kind::array) {
        document_.add_attribute(e, name, json_.string(value.text), where, value.where,
                                value.kind != Kind::string);
        return;
    }
    std::string joined;
    Where value_where = value.where;
    for (const JsonId item : json_.children(member)) {
        if (!expect(item, Kind::string)) { continue; }
        if (joined.empty()) {
            value_where = json_.at(item).where;
        } else {
            joined += ' ';
        }
        joined += json_.text(item);
    }
    document_.add_attribute(e, name, joined, where, value_where);
}

void ElementReader::check_unique(ElementId e) {
    const Attribute* const second = document_.repeated(e);
    if (second == nullptr) { return; }
    diagnostics_.structural_error("json-member", second->where,
                                  "the attribute " + quoted(document_.string(second->name)) +
                                      " is given twice");
}

void ElementReader::add_xml(ElementId e, JsonId fragment) {
    if (!expect(fragment, Kind::string)) { return; }
    DocumentLimits left = limits_;
    left.depth -= std::min(left.depth, depth_);
    left.depth += 1;  // the wrapper
    Diagnostics inside;
    const auto read =
        read_xml("<xml>" + std::string(json_.text(fragment)) + "</xml>", 0, inside, left);
    if (!read) {
        const auto& all = inside.all();
        const auto error = std::find_if(all.begin(), all.end(), [](const Diagnostic& d) {
            return d.severity == Diagnostic::Severity::error;
        });
        fail_type(fragment, title(fragment) + " must be XML: " + error->message);
        return;
    }
    if (!read->text(read->root()).empty()) {
        fail_type(fragment, title(fragment) + " must be elements; text stands in \"text\"");
        return;
    }
    for (const ElementId child : read->children(read->root())) {
        const ElementId copy = copy_subtree(*read, child, document_, e);
        for (std::uint32_t i = copy.index; i < document_.elements.size(); ++i) {
            Element& element = document_.elements[i];
            element.where = element.text_where = json_.at(fragment).where;
            for (std::uint32_t a = 0; a < element.attribute_count; ++a) {
                Attribute& attribute = document_.attributes[element.first_attribute + a];
                attribute.where = attribute.value_where = json_.at(fragment).where;
            }
        }
    }
}

JsonId ElementReader::array_member(JsonId object, std::string_view key) {
    const JsonId list = json_.member(object, key);
    return list && expect(list, Kind::array) ? list : JsonId{};
}

bool ElementReader::expect(JsonId value, Kind kind) {
    if (json_.kind(value) == kind) { return true; }
    const std::string_view wanted = kind == Kind::array    ? "an array"
                                    : kind == Kind::object ? "an object"
                                                           : "text";
    fail_type(value, title(value) + " must be " + std::string(wanted) + ", found " +
                         std::string(article(value)));
    return false;
}

void ElementReader::fail_type(JsonId value, std::string message) {
    diagnostics_.structural_error("json-type", json_.at(value).where, std::move(message));
}

void ElementReader::fail_member(JsonId value, std::string message) {
    const JsonValue& v = json_.at(value);
    diagnostics_.structural_error("json-member", v.key_where.line != 0 ? v.key_where : v.where,
                                  std::move(message));
}

std::string ElementReader::title(JsonId value) const {
    const JsonId parent = json_.at(value).parent;
    if (!parent) { return "the file"; }
    if (json_.kind(parent) == Kind::object) { return quoted(json_.key(value)); }
    // arrays in arrays: the nearest that has a name
    JsonId named = parent;
    while (json_.at(named).parent && json_.kind(json_.at(named).parent) == Kind::array) {
        named = json_.at(named).parent;
    }
    if (!json_.at(named).parent) { return "each value"; }
    return "each value of " + quoted(json_.key(named));
}

std::string_view ElementReader::article(JsonId value) const {
    return trellis::article(json_, value);
}

void ElementWriter::add_bare(JsonId parent, std::string_view key, std::string_view text) {
    const bool word = text == "true" || text == "false";
    json_.add(parent, key,
              word            ? Kind::boolean
              : is_bare(text) ? Kind::number
                              : Kind::string,
              text);
}

void ElementWriter::add_doc(JsonId object, ElementId e) {
    carry_doc(e);
    if (!carried_.empty()) { add_text(object, "doc", carried_); }
    carried_.clear();
}

void ElementWriter::carry_doc(ElementId e) {
    if (document_.doc(e).empty()) { return; }
    if (!carried_.empty()) { carried_ += '\n'; }
    carried_ += document_.doc(e);
}

bool is_bare(std::string_view text) {
    constexpr std::size_t exact_digits = 15;  // that a double keeps: DBL_DIG
    if (text == "true" || text == "false") { return true; }
    const bool negative = text.starts_with('-');
    if (negative) { text.remove_prefix(1); }
    const std::size_t point = text.find('.');
    const std::string_view whole = text.substr(0, point);
    const auto digits = [](std::string_view s) {
        return !s.empty() && s.find_first_not_of("0123456789") == std::string_view::npos;
    };
    if (!digits(whole) || (whole.size() > 1 && whole[0] == '0')) { return false; }
    if (whole.size() > exact_digits) { return false; }
    if (point == std::string_view::npos) { return !negative || whole != "0"; }

    const std::string_view fraction = text.substr(point + 1);
    if (!digits(fraction) || whole.size() + fraction.size() > exact_digits) { return false; }
    if (fraction == "0") { return !negative || whole != "0"; }
    // below 1e-4, libraries write an exponent
    return !fraction.ends_with('0') && (whole != "0" || !fraction.starts_with("0000"));
}

}  // namespace trellis
