// Small steps through XML text, and the XML declaration (XML 1.0, productions 23 to 32 and 80).
// Covered by tests/load/xml_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/xml_cursor.h"

#include <utility>

namespace trellis {

namespace {

bool is_version(std::string_view version) {  // production 26: later minor versions are read as 1.0
    return version.size() > 2 && version.starts_with("1.") &&
           version.find_first_not_of("0123456789", 2) == std::string_view::npos;
}

bool is_utf8_or_ascii(std::string_view encoding) {
    std::string lower(encoding);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') { c = static_cast<char>(c - 'A' + 'a'); }
    }
    return lower == "utf-8" || lower == "utf8" || lower == "us-ascii" || lower == "ascii";
}

}  // namespace

bool XmlCursor::skip_blanks() {
    const std::size_t before = at;
    while (at < text.size() && is_blank(text[at])) {
        ++at;
    }
    return at != before;
}

std::string_view XmlCursor::take_name() {
    const std::string_view name = rest().substr(0, name_length(rest()));
    at += name.size();
    return name;
}

std::optional<XmlCursor::RawValue> XmlCursor::take_value(std::string_view name) {
    skip_blanks();
    if (!ahead("=")) {
        fail_expected("\"=\" and a quoted value after " + quoted(name));
        return std::nullopt;
    }
    ++at;
    skip_blanks();
    if (!ahead("\"") && !ahead("'")) {
        fail_expected("the value of " + quoted(name) + " in quotes");
        return std::nullopt;
    }
    const char quote = text[at];
    const std::size_t begin = ++at;
    RawValue value;
    for (; at < text.size() && text[at] != quote && text[at] != '<'; ++at) {
        if (text[at] == '&' || text[at] == '\r') { value.plain = false; }
    }
    if (at == text.size()) {
        fail("xml-syntax", begin - 1, "the value of " + quoted(name) + " has no closing quote");
        return std::nullopt;
    }
    // a missing quote swallows what follows: the "<" of the next tag gives it away
    if (text[at] == '<') {
        fail_syntax("\"<\" in the value of " + quoted(name) +
                    ": write \"&lt;\", or close the quote before it");
        return std::nullopt;
    }
    value.text = text.substr(begin, at - begin);
    ++at;
    return value;
}

bool XmlCursor::take_declaration() {
    if (!ahead("<?xml") || (rest().size() > 5 && !is_blank(rest()[5]))) { return true; }
    at += 5;
    const Declared version = take_declared("version");
    if (!version.ok) { return false; }
    if (!version.given) { return fail_expected("version=\"1.0\""); }
    if (!is_version(version.value)) {
        return fail_syntax("the XML version is " + quoted(version.value) + ", expected \"1.0\"");
    }
    const Declared encoding = take_declared("encoding");
    if (!encoding.ok) { return false; }
    if (encoding.given && !is_utf8_or_ascii(encoding.value)) {
        return fail("encoding", static_cast<std::size_t>(encoding.value.data() - text.data()),
                    "the encoding is " + quoted(encoding.value) + ", expected \"UTF-8\"");
    }
    const Declared standalone = take_declared("standalone");
    if (!standalone.ok) { return false; }
    if (standalone.given && standalone.value != "yes" && standalone.value != "no") {
        return fail_syntax("standalone is " + quoted(standalone.value) +
                           ", expected \"yes\" or \"no\"");
    }
    skip_blanks();
    if (!ahead("?>")) { return fail_expected("\"?>\" at the end of the XML declaration"); }
    at += 2;
    return true;
}

XmlCursor::Declared XmlCursor::take_declared(std::string_view name) {
    const std::size_t before = at;
    const bool blank = skip_blanks();
    if (!ahead(name)) {
        at = before;
        return {};
    }
    if (!blank) { return {fail_expected("a blank before " + quoted(name)), false, {}}; }
    at += name.size();
    const auto value = take_value(name);
    return {value.has_value(), value.has_value(), value.value_or(RawValue()).text};
}

bool XmlCursor::fail(const char* id, std::size_t offset, std::string message) {
    diagnostics.error(id, lines.at(offset), std::move(message));
    return false;
}

bool XmlCursor::fail_syntax(std::string message) {
    return fail("xml-syntax", at, std::move(message));
}

bool XmlCursor::fail_expected(std::string_view what) {
    return fail_syntax("expected " + std::string(what) + ", found " + found(rest()));
}

}  // namespace trellis
