// What is wrong with a document, where, and what was probably meant: collected, never thrown or
// printed. Covered by tests/load/diagnostics_test.cpp; exact texts by tests/load/faults_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

/// A place in a text. Line and column count from 1, columns in bytes; line 0 means "no place".
struct Where {
    std::uint32_t file = 0;  ///< index of the text, in the order of Diagnostics::add_file
    std::uint32_t line = 0;
    std::uint32_t column = 0;

    friend bool operator==(const Where&, const Where&) = default;
};

/// One finding. `id` is its stable name ("unknown-attribute"), the anchor of its manual entry.
struct Diagnostic {
    enum class Severity : std::uint8_t { error, warning };

    Severity severity = Severity::error;
    /// True for a fault that the generated schemas must find as well: names, types and numbers of
    /// elements and attributes. False for anything that needs to know the whole document.
    bool structural = false;
    std::string id;
    Where where;
    std::string message;  ///< lower case, no full stop: "Repeat takes 1 child, found 2"

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

/// The findings about one document and the files it includes, in the order they were made. Checking
/// goes on after an error, so that one run reports everything; ok() at the end decides.
class Diagnostics {
public:
    /// Names the next text; returns its index for Where::file. The first added is the main file.
    /// The text is copied: rendering shows its lines.
    std::uint32_t add_file(std::string name, std::string_view text) {
        return take_file(std::move(name), std::string(text));
    }
    /// Likewise, without a copy: file_text() is where the text is then.
    std::uint32_t take_file(std::string name, std::string text);
    std::uint32_t file_count() const { return static_cast<std::uint32_t>(files_.size()); }

    /// So many errors, and so many warnings, are kept; the next becomes "too-many" and all after it
    /// are dropped, so that a file of nothing but faults takes no more memory than another.
    static constexpr std::size_t most = 1000;
    /// Whether further errors are dropped: what only looks for faults may stop.
    bool is_full() const { return errors_ > most; }

    void error(std::string id, Where where, std::string message);
    /// An error that the generated schemas must find as well.
    void structural_error(std::string id, Where where, std::string message);
    void warning(std::string id, Where where, std::string message);

    bool ok() const { return errors_ == 0; }
    std::size_t errors() const { return errors_; }
    /// Whether any error is structural: what an XSD or a JSON Schema would say about the file.
    bool structural() const;
    /// In the order in which they were made; after sort(), by place.
    const std::vector<Diagnostic>& all() const { return all_; }
    /// The name given to add_file; empty for an unknown index.
    std::string_view file_name(std::uint32_t file) const;
    /// The text given to add_file, as long as no further is added; empty for an unknown index.
    std::string_view file_text(std::uint32_t file) const;

    /// Sorts by place (stable) and drops exact repetitions: call once, when checking is done.
    void sort();

    /// "file:line:column: error: message [id]", the line, and a caret below the place. A tab in the
    /// line is kept in front of the caret; a long line is cut around the place.
    std::string render(const Diagnostic& d) const;
    /// All of them, rendered, then one line that counts: "2 errors, 1 warning". Empty if there
    /// are none.
    std::string render() const;

private:
    struct File {
        std::string name;
        std::string text;
        std::vector<std::size_t> marks;  // byte offsets of the lines 1, 1 + lines_per_mark, …
    };

    void add(Diagnostic::Severity severity, bool structural, std::string id, Where where,
             std::string message);

    std::vector<File> files_;
    std::vector<Diagnostic> all_;
    std::size_t errors_ = 0;    // found, kept or not, until sort() counts what is kept
    std::size_t warnings_ = 0;  // likewise
};

/// The name among `candidates` that `wrong` was probably meant to be: smallest edit distance (with
/// transpositions), at most a third of the length; letter case counts half. Empty if none is close
/// or `wrong` is longer than 64 bytes. The first of several equally close ones.
std::string_view closest(std::string_view wrong, const std::vector<std::string_view>& candidates);

/// `; did you mean "Sequence"?`, or nothing when no candidate is close: to append to a message.
std::string suggestion(std::string_view wrong, const std::vector<std::string_view>& candidates);

}  // namespace trellis
