// What the XML and JSON readers share about text: lines, the encoding, characters and names, and
// the form in which a document keeps comments. Knows nothing of documents. Covered by
// tests/load/xml_test.cpp and json_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trellis {

/// Turns byte offsets of one text, of less than 4 GiB, into places. All queries that do not go back
/// take the time of one pass over the text; one that does begins a new pass.
class LineCounter {
public:
    LineCounter(std::string_view text, std::uint32_t file);

    Where at(std::size_t offset);

private:
    void begin_line(std::size_t start);

    // Why no table of all lines: of a text of nothing but line feeds it has four times the bytes.
    std::string_view text_;
    std::size_t start_ = 0;  // of the line of the last query
    std::size_t next_ = 0;   // of the line behind it; one past the text if that is the last
    std::uint32_t line_ = 1;
    std::uint32_t file_;
};

/// Which characters a text may hold as they are. XML 1.0 forbids the control characters but tab,
/// line feed and carriage return, and U+FFFE and U+FFFF; JSON's own syntax deals with them.
enum class Characters : std::uint8_t { xml, any };

/// Checks that `text` is UTF-8 of at most `most_bytes` bytes: the offset of its first character (3
/// after a byte order mark), or none and an error "encoding", "character" or "too-large" at the
/// first place that is wrong.
std::optional<std::size_t> check_text(std::string_view text, std::size_t most_bytes,
                                      Characters allowed, LineCounter& lines,
                                      Diagnostics& diagnostics);

/// Whether XML 1.0 allows the character in a document.
bool is_xml_character(char32_t c);
/// A character that XML forbids, and where.
struct Forbidden {
    std::size_t offset = 0;
    char32_t character = 0;
};
/// The first one in `text`, which must be UTF-8.
std::optional<Forbidden> find_forbidden(std::string_view text);
/// Bytes at the start of `text` (UTF-8) that are a Name of XML 1.0; 0 if it begins with none.
std::size_t name_length(std::string_view text);
/// Whether all of `text` is a name.
inline bool is_name(std::string_view text) {
    return !text.empty() && name_length(text) == text.size();
}

/// Bytes of a text from which on a reader makes room for all that the text may hold.
constexpr std::size_t large_text = std::size_t{4} << 20;

/// Space, tab, line feed or carriage return: what both XML and JSON call white space.
inline bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}
bool is_blank(std::string_view text);
/// `text` without the blanks around it.
std::string_view trimmed(std::string_view text);

/// 0 to 15, or 16 if `c` is no hexadecimal digit.
std::uint32_t hex_digit(char c);
/// Bytes of a character in UTF-8, from 1 to 4.
std::size_t utf8_size(char32_t c);
void append_utf8(std::string& to, char32_t c);
/// "U+000A": to name a character that cannot be shown.
std::string character_code(char32_t c);

/// An entity or character reference of XML.
struct Reference {
    char32_t character = 0;  ///< 0 if it is none of the five entities nor an allowed character
    std::size_t length = 0;  ///< with the ampersand and the semicolon; 0 if it is no reference
};
/// The reference that `text` begins with.
Reference read_reference(std::string_view text);

/// Appends `text` with every line end (CR LF, or CR alone) as one line feed: XML 1.0, 2.11.
void append_with_line_feeds(std::string& to, std::string_view text);

/// A comment in the form in which documents keep it: no blanks around it, line ends as line feeds.
std::string normal_doc(std::string_view text);

/// `s` in double quotes, as it is.
std::string quoted(std::string_view s);
/// What stands at the start of `rest`, quoted and short, for "found …": `"abc"`, `the end of the
/// file`, `the end of the line`.
std::string found(std::string_view rest);

}  // namespace trellis
