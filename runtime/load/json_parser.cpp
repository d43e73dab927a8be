// Text to JsonTree: nlohmann's SAX parser, with the places that it does not tell. Covered by
// tests/load/json_test.cpp.
//
// The parser is asked where it is in the text whenever it reports a value. Strings and brackets end
// there; what lies between the end of one report and the next is blanks, a colon or a comma, then
// the value. The same stretch of text explains a syntax error better than the parser's own message.
// SPDX-License-Identifier: MIT
#include "load/json_tree.h"
#include "load/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace trellis {

namespace {

/// A character of the text, for the parser to read; its offset is seen by the receiver of events.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* begin, const char* at, std::size_t* read)
        : begin_(begin), at_(at), read_(read) {}

    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        ++at_;
        *read_ = static_cast<std::size_t>(at_ - begin_);
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ == b.at_;
    }

private:
    const char* begin_;
    const char* at_;
    std::size_t* read_;
};

bool is_number_character(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}

/// Receives the parser's events (nlohmann's SAX interface: the names and types are its) and builds
/// the tree.
class JsonReceiver {
public:
    JsonReceiver(std::string_view text, std::uint32_t file, Diagnostics& diagnostics,
                 const DocumentLimits& limits)
        : text_(text), lines_(text, file), diagnostics_(diagnostics), limits_(limits) {}

    std::optional<JsonTree> parse() {
        const auto begin = check_text(text_, limits_.bytes, Characters::any, lines_, diagnostics_);
        if (!begin) { return std::nullopt; }
        past_ = read_ = *begin;
        tree_.strings.reserve(text_.size());
        // as in XmlReader::reserve(); the shortest value is a digit and a comma
        const std::size_t bytes_per_value = text_.size() >= large_text ? 2 : 8;
        tree_.values.reserve(std::min<std::size_t>(text_.size() / bytes_per_value, limits_.values));
        const char* const data = text_.data();
        const bool ok =
            nlohmann::json::sax_parse(CountingIterator(data, data + *begin, &read_),
                                      CountingIterator(data, data + text_.size(), &read_), this);
        if (!ok) { return std::nullopt; }
        return std::move(tree_);
    }

    // SAX events ----------------------------------------------------------------------------------

    bool null() { return scalar(JsonTree::Kind::null, 4); }
    bool boolean(bool value) { return scalar(JsonTree::Kind::boolean, value ? 4 : 5); }
    bool number_integer(std::int64_t /*value*/) { return number(); }
    bool number_unsigned(std::uint64_t /*value*/) { return number(); }
    bool number_float(double /*value*/, const std::string& /*spelling*/) { return number(); }
    bool string(const std::string& value) {
        return check_characters(value) && add(JsonTree::Kind::string, value, 1) && passed(read_);
    }
    bool binary(const std::vector<std::uint8_t>& /*value*/) { return false; }  // not in texts

    bool start_object(std::size_t /*count*/) { return open(JsonTree::Kind::object); }
    bool start_array(std::size_t /*count*/) { return open(JsonTree::Kind::array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(const std::string& value) {
        if (!check_characters(value)) { return false; }
        key_ = value;
        key_where_ = lines_.at(token() + 1);
        has_key_ = true;
        return passed(read_);
    }

    bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                     const nlohmann::json::exception& problem) {
        explain(problem.what());
        return false;
    }

private:
    /// Offset of the value that was just reported, or of what stands in its place.
    std::size_t token() const {
        std::size_t at = past_;
        while (at < text_.size() && (is_blank(text_[at]) || text_[at] == ',' || text_[at] == ':')) {
            ++at;
        }
        return at;
    }

    bool passed(std::size_t offset) {
        past_ = offset;
        return true;
    }

    bool fail(const char* id, std::size_t offset, std::string message) {
        diagnostics_.error(id, lines_.at(offset), std::move(message));
        return false;
    }

    bool check_characters(std::string_view value) {
        const auto forbidden = find_forbidden(value);
        if (!forbidden) { return true; }
        diagnostics_.error(
            "character",
            where_in(text_, Document::Spelling::json, lines_.at(token() + 1), forbidden->offset),
            "the character " + character_code(forbidden->character) + " is not allowed in a file");
        return false;
    }

    bool add(JsonTree::Kind kind, std::string_view value, std::size_t quotes) {
        if (tree_.values.size() >= limits_.values) {
            return fail("too-large", token(),
                        "the file has more than " + std::to_string(limits_.values) + " values");
        }
        const JsonId parent = open_.empty() ? JsonId{} : open_.back();
        const JsonId v = tree_.add(parent, key_, kind, value);
        tree_.values[v.index].where = lines_.at(token() + quotes);
        if (has_key_) { tree_.values[v.index].key_where = key_where_; }
        key_.clear();
        has_key_ = false;
        return true;
    }

    bool scalar(JsonTree::Kind kind, std::size_t size) {
        const std::size_t begin = token();
        return add(kind, text_.substr(begin, size), 0) && passed(begin + size);
    }

    bool number() {
        const std::size_t begin = token();
        std::size_t end = begin;
        while (end < text_.size() && is_number_character(text_[end])) {
            ++end;
        }
        return scalar(JsonTree::Kind::number, end - begin);
    }

    bool open(JsonTree::Kind kind) {
        const std::size_t deepest = std::size_t{limits_.depth} * 4 + 4;
        if (open_.size() >= deepest) {
            return fail("too-large", token(),
                        "values are nested more than " + std::to_string(deepest) + " deep");
        }
        if (!add(kind, {}, 0)) { return false; }
        open_.push_back({static_cast<std::uint32_t>(tree_.values.size() - 1)});
        return passed(read_);
    }

    bool close() {
        const JsonId v = open_.back();
        open_.pop_back();
        tree_.close(v);
        return passed(read_) && check_members(v);
    }

    /// Refuses an object that has two members of one name.
    bool check_members(JsonId object) {
        if (tree_.kind(object) != JsonTree::Kind::object) { return true; }
        members_.clear();
        for (const JsonId m : tree_.children(object)) {
            members_.push_back(m);
        }
        std::stable_sort(members_.begin(), members_.end(),
                         [this](JsonId a, JsonId b) { return tree_.key(a) < tree_.key(b); });
        const auto same =
            std::adjacent_find(members_.begin(), members_.end(),
                               [this](JsonId a, JsonId b) { return tree_.key(a) == tree_.key(b); });
        if (same == members_.end()) { return true; }
        const Where first = tree_.at(*same).key_where;
        diagnostics_.error("duplicate-member", tree_.at(*(same + 1)).key_where,
                           "the member " + quoted(tree_.key(*same)) +
                               " is given twice, first in line " + std::to_string(first.line));
        return false;
    }

    // Syntax errors -------------------------------------------------------------------------------

    bool fail_syntax(std::size_t offset, std::string message) {
        return fail("json-syntax", offset, std::move(message));
    }

    /// What the text lacks behind the last token, and where: past blanks and the right separator.
    struct Expectation {
        std::size_t at = 0;
        const char* what = "";
        bool value = false;                          // a value may stand here
        bool name = false;                           // a member's name may stand here
        std::size_t comma = std::string_view::npos;  // the comma that was passed
    };

    Expectation expectation() const {
        Expectation e;
        const auto skip_blanks = [&] {
            while (e.at < text_.size() && is_blank(text_[e.at])) {
                ++e.at;
            }
        };
        const auto take = [&](char c) {
            if (e.at == text_.size() || text_[e.at] != c) { return false; }
            ++e.at;
            skip_blanks();
            return true;
        };
        e.at = past_;
        skip_blanks();
        const std::size_t separator = e.at;
        if (has_key_) {
            e.value = take(':');
            e.what = e.value ? "a value" : "\":\" after the member's name";
        } else if (open_.empty()) {
            e.value = tree_.values.empty();
            e.what = e.value ? "a value" : "the end of the file";
        } else {
            const bool object = tree_.kind(open_.back()) == JsonTree::Kind::object;
            const bool first = open_.back().index + 1 == tree_.values.size();
            const bool comma = !first && take(',');
            e.value = !object && (first || comma);
            e.name = object && (first || comma);
            if (comma) { e.comma = separator; }
            e.what = object  ? first   ? "a member's name in double quotes or \"}\""
                               : comma ? "a member's name in double quotes"
                                       : "\",\" or \"}\""
                     : first ? "a value or \"]\""
                     : comma ? "a value"
                             : "\",\" or \"]\"";
        }
        return e;
    }

    /// Makes the error for text that is not JSON; `problem` is the parser's own message.
    bool explain(std::string_view problem) {
        const Expectation e = expectation();
        const std::string_view rest = text_.substr(e.at);
        const bool closes = rest.starts_with('}') || rest.starts_with(']');
        if (is_blank(text_.substr(past_)) && tree_.values.empty()) {
            return fail_syntax(e.at, "the file is empty: expected an object");
        }
        if (rest.starts_with("//") || rest.starts_with("/*")) {
            return fail_syntax(e.at, "JSON has no comments; write a member \"doc\"");
        }
        if (closes && e.comma != std::string_view::npos) {
            return fail_syntax(e.comma, "no comma may stand before " + found(rest.substr(0, 1)));
        }
        if (rest.starts_with('\'')) {
            return fail_syntax(e.at, "text and names take double quotes");
        }
        if (rest.starts_with("NaN") || rest.starts_with("Infinity") ||
            rest.starts_with("-Infinity")) {
            return fail_syntax(e.at, "JSON has no NaN and no Infinity");
        }
        if (rest.starts_with('"') && (e.value || e.name)) { return explain_string(e.at); }
        if (e.value && !rest.empty() && is_number_character(rest.front())) {
            return fail_syntax(e.at, problem.find("overflow") != std::string_view::npos
                                         ? "the number is too large"
                                         : "expected a number such as 12, -0.5 or 1e-3");
        }
        // a colon is no part of what stands before it, as it would be in XML
        const std::string_view shown = rest.substr(0, std::max<std::size_t>(rest.find(':'), 1));
        return fail_syntax(e.at, "expected " + std::string(e.what) + ", found " + found(shown));
    }

    /// The parser stopped inside the string that begins at `begin`, behind the wrong character.
    bool explain_string(std::size_t begin) {
        const std::size_t at = read_ - 1;
        const auto wrong = static_cast<unsigned char>(text_[at]);
        if (wrong == '\n' || wrong == '\r') {
            return fail_syntax(at, "a string ends on its line; write \"\\n\" for a line feed");
        }
        if (wrong < 0x20) {
            return fail_syntax(at, "the character " + character_code(wrong) +
                                       " must be escaped in a string");
        }
        const std::size_t escape = text_.substr(0, at + 1).rfind('\\');
        if (read_ == text_.size() || escape == std::string_view::npos || escape < begin) {
            return fail_syntax(begin, "the string has no closing quote");
        }
        return fail_syntax(escape, "a string has no escape " +
                                       quoted(text_.substr(escape, at + 1 - escape)));
    }

    std::string_view text_;
    std::size_t read_ = 0;  // bytes that the parser has taken
    std::size_t past_ = 0;  // end of the last token that was reported
    LineCounter lines_;
    Diagnostics& diagnostics_;
    DocumentLimits limits_;
    JsonTree tree_;
    std::vector<JsonId> open_;
    std::string key_;       // of the next value
    bool has_key_ = false;  // it is a member, even if the key is empty
    Where key_where_;
    std::vector<JsonId> members_;  // of the object that check_members() looks at
};

}  // namespace

std::optional<JsonTree> parse_json(std::string_view text, std::uint32_t file,
                                   Diagnostics& diagnostics, const DocumentLimits& limits) {
    return JsonReceiver(text, file, diagnostics, limits).parse();
}

}  // namespace trellis
