// Lines, UTF-8, characters, names and references. Covered by tests/load/xml_test.cpp and
// json_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/text.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace trellis {

LineCounter::LineCounter(std::string_view text, std::uint32_t file) : text_(text), file_(file) {
    begin_line(0);
}

void LineCounter::begin_line(std::size_t start) {
    start_ = start;
    next_ = std::min(text_.find('\n', start), text_.size()) + 1;
}

Where LineCounter::at(std::size_t offset) {
    if (offset < start_) {
        line_ = 1;
        begin_line(0);
    }
    // the end of the text stands behind its last character, in the same line
    while (offset >= next_ && next_ <= text_.size()) {
        ++line_;
        begin_line(next_);
    }
    return {file_, line_, static_cast<std::uint32_t>(offset - start_ + 1)};
}

namespace {

/// One character of UTF-8; length 0 if the bytes are none (Unicode 15, table 3-7).
struct Decoded {
    char32_t character = 0;
    std::size_t length = 0;
};

Decoded decode(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) { return {lead, 1}; }
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4) { return {}; }
    char32_t c = lead & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) { return {}; }
        c = (c << 6U) | (byte(i) & 0x3FU);
    }
    if (utf8_size(c) != length || c > 0x10FFFF || (c >= 0xD800 && c <= 0xDFFF)) { return {}; }
    return {c, length};
}

// which ASCII characters names are made of, as bits: names are most of what is read
constexpr std::uint8_t name_start = 1;
constexpr std::uint8_t name_part = 2;
constexpr std::array<std::uint8_t, 0x80> ascii_names = [] {
    std::array<std::uint8_t, 0x80> bits{};
    for (std::size_t c = 0; c < bits.size(); ++c) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        const bool start = letter || c == '_' || c == ':';
        const bool part = start || (c >= '0' && c <= '9') || c == '-' || c == '.';
        bits[c] = static_cast<std::uint8_t>((start ? name_start : 0) | (part ? name_part : 0));
    }
    return bits;
}();

bool starts_name(char32_t c) {  // XML 1.0, production 4, above ASCII
    static constexpr struct {
        char32_t first, last;
    } ranges[] = {{0xC0, 0xD6},     {0xD8, 0xF6},     {0xF8, 0x2FF},    {0x370, 0x37D},
                  {0x37F, 0x1FFF},  {0x200C, 0x200D}, {0x2070, 0x218F}, {0x2C00, 0x2FEF},
                  {0x3001, 0xD7FF}, {0xF900, 0xFDCF}, {0xFDF0, 0xFFFD}, {0x10000, 0xEFFFF}};
    return std::any_of(std::begin(ranges), std::end(ranges),
                       [c](const auto& r) { return c >= r.first && c <= r.last; });
}

bool continues_name(char32_t c) {  // production 4a, above ASCII
    return starts_name(c) || c == 0xB7 || (c >= 0x300 && c <= 0x36F) || c == 0x203F || c == 0x2040;
}

/// The encoding that the first bytes give away as not UTF-8; empty if they do not.
std::string_view foreign_encoding(std::string_view text) {
    using namespace std::string_view_literals;
    if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) {
        return "UTF-32";
    }
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) { return "UTF-16"; }
    if (text.starts_with("<\0"sv) || text.starts_with("\0<"sv) || text.starts_with("{\0"sv) ||
        text.starts_with("\0{"sv)) {
        return "UTF-16";
    }
    return {};
}

/// Bytes at the start of `text` that are ASCII and no control characters: most of any file. Eight
/// at a time: a byte has its high bit set itself, or has it set by taking 0x20 away if it is below.
std::size_t plain_length(std::string_view text) {
    constexpr std::uint64_t high_bits = 0x8080808080808080;
    constexpr std::uint64_t spaces = 0x2020202020202020;
    std::size_t length = 0;
    for (std::uint64_t word = 0; length + sizeof word <= text.size(); length += sizeof word) {
        std::memcpy(&word, text.data() + length, sizeof word);
        if (((word | (word - spaces)) & high_bits) != 0) { break; }
    }
    const auto plain = [](unsigned char byte) { return byte >= 0x20 && byte < 0x80; };
    while (length < text.size() && plain(static_cast<unsigned char>(text[length]))) {
        ++length;
    }
    return length;
}

}  // namespace

std::optional<std::size_t> check_text(std::string_view text, std::size_t most_bytes,
                                      Characters allowed, LineCounter& lines,
                                      Diagnostics& diagnostics) {
    most_bytes = std::min(most_bytes, std::size_t{1} << 31U);  // places and pieces have 32 bits
    if (text.size() > most_bytes) {
        diagnostics.error("too-large", lines.at(0),
                          "the file has " + std::to_string(text.size()) + " bytes, the limit is " +
                              std::to_string(most_bytes));
        return std::nullopt;
    }
    if (const std::string_view encoding = foreign_encoding(text); !encoding.empty()) {
        diagnostics.error("encoding", lines.at(0),
                          "the file is " + std::string(encoding) + ", expected UTF-8");
        return std::nullopt;
    }
    for (std::size_t i = plain_length(text); i < text.size(); i += plain_length(text.substr(i))) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const Decoded c = decode(text.substr(i));
        if (c.length == 0) {
            static constexpr char digits[] = "0123456789ABCDEF";
            diagnostics.error("encoding", lines.at(i),
                              std::string("the file is not UTF-8: found the byte 0x") +
                                  digits[byte >> 4U] + digits[byte & 15U]);
            return std::nullopt;
        }
        if (c.character == 0 || (allowed == Characters::xml && !is_xml_character(c.character))) {
            diagnostics.error("character", lines.at(i),
                              "the character " + character_code(c.character) +
                                  " is not allowed in a file");
            return std::nullopt;
        }
        i += c.length;
    }
    return text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

bool is_xml_character(char32_t c) {  // XML 1.0, production 2
    return c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c <= 0xD7FF) ||
           (c >= 0xE000 && c <= 0xFFFD) || (c >= 0x10000 && c <= 0x10FFFF);
}

std::optional<Forbidden> find_forbidden(std::string_view text) {
    for (std::size_t i = plain_length(text); i < text.size(); i += plain_length(text.substr(i))) {
        const Decoded c = decode(text.substr(i));
        if (!is_xml_character(c.character)) { return Forbidden{i, c.character}; }
        i += c.length;
    }
    return std::nullopt;
}

std::size_t name_length(std::string_view text) {
    std::size_t length = 0;
    std::uint8_t wanted = name_start;
    for (; length < text.size(); wanted = name_part) {
        const auto byte = static_cast<unsigned char>(text[length]);
        if (byte < 0x80) {
            if ((ascii_names[byte] & wanted) == 0) { break; }
            ++length;
            continue;
        }
        const Decoded c = decode(text.substr(length));
        if (c.length == 0) { break; }
        if (length == 0 ? !starts_name(c.character) : !continues_name(c.character)) { break; }
        length += c.length;
    }
    return length;
}

bool is_blank(std::string_view text) {
    return trimmed(text).empty();
}

// not by find_first_not_of(): it asks memchr about each byte
std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

std::uint32_t hex_digit(char c) {
    if (c >= '0' && c <= '9') { return static_cast<std::uint32_t>(c - '0'); }
    if (c >= 'a' && c <= 'f') { return static_cast<std::uint32_t>(c - 'a') + 10; }
    if (c >= 'A' && c <= 'F') { return static_cast<std::uint32_t>(c - 'A') + 10; }
    return 16;
}

std::size_t utf8_size(char32_t c) {
    return c < 0x80 ? 1 : c < 0x800 ? 2 : c < 0x10000 ? 3 : 4;
}

void append_utf8(std::string& to, char32_t c) {
    const std::size_t size = utf8_size(c);
    if (size == 1) {
        to += static_cast<char>(c);
        return;
    }
    static constexpr std::uint32_t leads[] = {0, 0, 0xC0, 0xE0, 0xF0};
    to += static_cast<char>(leads[size] | (c >> (6 * (size - 1))));
    for (std::size_t i = size - 1; i-- > 0;) {
        to += static_cast<char>(0x80U | ((c >> (6 * i)) & 0x3FU));
    }
}

std::string character_code(char32_t c) {
    std::string digits;
    for (std::uint32_t rest = c; rest != 0 || digits.size() < 4; rest >>= 4U) {
        digits.insert(digits.begin(), "0123456789ABCDEF"[rest & 15U]);
    }
    return "U+" + digits;
}

Reference read_reference(std::string_view text) {
    static constexpr struct {
        std::string_view spelling;
        char32_t character;
    } entities[] = {
        {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};
    for (const auto& entity : entities) {
        if (text.starts_with(entity.spelling)) {
            return {entity.character, entity.spelling.size()};
        }
    }
    if (!text.starts_with("&#")) {
        const std::size_t name = text.empty() ? 0 : name_length(text.substr(1));
        const bool ends = name != 0 && text.substr(1 + name).starts_with(';');
        return {0, ends ? name + 2 : 0};
    }
    const bool hexadecimal = text.starts_with("&#x");
    const std::uint32_t base = hexadecimal ? 16 : 10;
    const std::size_t first = hexadecimal ? 3 : 2;
    std::size_t at = first;
    char32_t c = 0;
    for (; at < text.size() && hex_digit(text[at]) < base; ++at) {
        c = std::min<char32_t>(c * base + hex_digit(text[at]), 0x110000);
    }
    if (at == first || at == text.size() || text[at] != ';') { return {}; }
    return {is_xml_character(c) ? c : 0, at + 1};
}

void append_with_line_feeds(std::string& to, std::string_view text) {
    while (true) {
        const std::size_t end = text.find('\r');
        to += text.substr(0, end);
        if (end == std::string_view::npos) { return; }
        to += '\n';
        text.remove_prefix(end + (text.substr(end).starts_with("\r\n") ? 2 : 1));
    }
}

std::string normal_doc(std::string_view text) {
    std::string out;
    append_with_line_feeds(out, trimmed(text));
    return out;
}

std::string quoted(std::string_view s) {
    return "\"" + std::string(s) + "\"";
}

std::string found(std::string_view rest) {
    static constexpr std::size_t longest = 24;  // bytes shown
    if (rest.empty()) { return "the end of the file"; }
    if (rest.front() == '\n' || rest.front() == '\r') { return "the end of the line"; }
    if (rest.front() == ' ' || rest.front() == '\t') { return "a blank"; }
    const std::size_t name = name_length(rest);
    std::size_t size = name != 0 ? name : decode(rest).length;
    if (size <= longest) { return quoted(rest.substr(0, size)); }
    for (size = longest; (static_cast<unsigned char>(rest[size]) & 0xC0U) == 0x80U;) {
        --size;
    }
    return "\"" + std::string(rest.substr(0, size)) + "…\"";
}

}  // namespace trellis
