// JSON that a program reads: objects and arrays written in order, numbers as everywhere in Trellis.
// Covered by tests/runner/json_writer_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trellis {

/// Appends `text` as a JSON string. Bytes that are not UTF-8 become U+FFFD.
void append_json_string(std::string& out, std::string_view text);

/// Writes one JSON value. Inside an object each value needs a key, elsewhere it has none. Indented
/// by two spaces per level, or all on one line.
class JsonWriter {
public:
    enum class Layout : std::uint8_t { indented, one_line };
    explicit JsonWriter(Layout layout = Layout::indented) : layout_(layout) {}

    JsonWriter& begin_object(std::string_view key = {}) { return begin(key, '{'); }
    JsonWriter& begin_array(std::string_view key = {}) { return begin(key, '['); }
    JsonWriter& end_object() { return end('}'); }
    JsonWriter& end_array() { return end(']'); }

    JsonWriter& text(std::string_view key, std::string_view value);
    JsonWriter& number(std::string_view key, double value);  ///< null if it is not finite
    JsonWriter& integer(std::string_view key, std::int64_t value);
    JsonWriter& count(std::string_view key, std::uint64_t value);
    JsonWriter& boolean(std::string_view key, bool value);
    JsonWriter& null(std::string_view key);
    JsonWriter& element(std::string_view text_value);  ///< of an array

    /// What was written, and a line feed.
    std::string finish() &&;

private:
    JsonWriter& begin(std::string_view key, char bracket);
    JsonWriter& end(char bracket);
    void start(std::string_view key);
    void new_line();

    Layout layout_;
    std::string out_;
    std::size_t depth_ = 0;
    bool first_ = true;  // of the values of the innermost object or array
};

}  // namespace trellis
