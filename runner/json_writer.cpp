// Strings, numbers and indentation.
// SPDX-License-Identifier: MIT
#include "runner/json_writer.h"

#include "core/number.h"

#include <cmath>
#include <utility>

namespace trellis {

namespace {

/// Bytes of the well-formed UTF-8 character that `text` begins with; 0 if there is none.
std::size_t character_size(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const unsigned lead = byte(0);
    if (lead < 0x80) { return 1; }
    const std::size_t size = lead < 0xC2   ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0) != 0x80) { return 0; }
    }
    // overlong forms, surrogates, and what is beyond Unicode
    const bool excluded = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F) ||
                          (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F);
    return excluded ? 0 : size;
}

void append_control(std::string& out, char c) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(c);
    out += "\\u00";
    out += digits[code >> 4U];
    out += digits[code & 15U];
}

}  // namespace

void append_json_string(std::string& out, std::string_view text) {
    out += '"';
    while (!text.empty()) {
        const char c = text.front();
        const std::size_t size = character_size(text);
        switch (c) {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '\n': out += "\\n"; break;
        case '\r': out += "\\r"; break;
        case '\t': out += "\\t"; break;
        default:
            if (size == 0) {
                out += "\xEF\xBF\xBD";
            } else if (static_cast<unsigned char>(c) < 0x20) {
                append_control(out, c);
            } else {
                out += text.substr(0, size);
            }
        }
        text.remove_prefix(size == 0 ? 1 : size);
    }
    out += '"';
}

JsonWriter& JsonWriter::text(std::string_view key, std::string_view value) {
    start(key);
    append_json_string(out_, value);
    return *this;
}

JsonWriter& JsonWriter::number(std::string_view key, double value) {
    if (!std::isfinite(value)) { return null(key); }
    start(key);
    append_number(out_, value);
    return *this;
}

JsonWriter& JsonWriter::integer(std::string_view key, std::int64_t value) {
    start(key);
    out_ += std::to_string(value);
    return *this;
}

JsonWriter& JsonWriter::count(std::string_view key, std::uint64_t value) {
    start(key);
    out_ += std::to_string(value);
    return *this;
}

JsonWriter& JsonWriter::boolean(std::string_view key, bool value) {
    start(key);
    out_ += value ? "true" : "false";
    return *this;
}

JsonWriter& JsonWriter::null(std::string_view key) {
    start(key);
    out_ += "null";
    return *this;
}

JsonWriter& JsonWriter::element(std::string_view text_value) {
    return text({}, text_value);
}

std::string JsonWriter::finish() && {
    out_ += '\n';
    return std::move(out_);
}

JsonWriter& JsonWriter::begin(std::string_view key, char bracket) {
    start(key);
    out_ += bracket;
    ++depth_;
    first_ = true;
    return *this;
}

JsonWriter& JsonWriter::end(char bracket) {
    --depth_;
    if (!first_) { new_line(); }
    out_ += bracket;
    first_ = false;
    return *this;
}

// What stands in front of a value: a comma, its line, its key.
void JsonWriter::start(std::string_view key) {
    if (depth_ != 0) {
        if (!first_) { out_ += layout_ == Layout::one_line ? ", " : ","; }
        new_line();
    }
    first_ = false;
    if (!key.empty()) {
        append_json_string(out_, key);
        out_ += ": ";
    }
}

void JsonWriter::new_line() {
    if (layout_ == Layout::one_line) { return; }
    out_ += '\n';
    out_.append(2 * depth_, ' ');
}

}  // namespace trellis
