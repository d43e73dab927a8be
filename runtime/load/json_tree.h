// JSON as data: the values of a text in document order, flat, with their places. Which members make
// a behaviour is not known here (json_trees.cpp, json_machines.cpp). Covered by
// tests/load/json_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "load/diagnostics.h"
#include "load/document.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

using JsonId = Id<struct JsonTag>;

struct JsonValue {
    enum class Kind : std::uint8_t { null, boolean, number, string, array, object };

    Kind kind = Kind::null;
    Piece key;        ///< decoded; empty if it is no member of an object
    Piece text;       ///< of a string: decoded; of a number, true, false and null: as written
    Where key_where;  ///< of the key's first character, inside the quotes
    Where where;      ///< of the value; of a string's first character, inside the quotes
    JsonId parent;    ///< none for the root
    JsonId end;       ///< one past the last value inside this one
};

/// Values in document order: what is inside value v is the interval (v, end(v)). Regular: may be
/// copied, holds no pointers.
class JsonTree {
public:
    using Kind = JsonValue::Kind;

    std::string strings;  ///< every key and text, back to back
    std::vector<JsonValue> values;

    JsonId root() const { return {0}; }
    const JsonValue& at(JsonId v) const { return values[v.index]; }
    Kind kind(JsonId v) const { return at(v).kind; }
    std::string_view string(Piece p) const { return {strings.data() + p.begin, p.size}; }
    std::string_view key(JsonId v) const { return string(at(v).key); }
    std::string_view text(JsonId v) const { return string(at(v).text); }
    /// The member of an object, or none; of anything else none.
    JsonId member(JsonId object, std::string_view key) const;
    /// Whether anything is inside an array or object.
    bool has_children(JsonId v) const { return at(v).end.index > v.index + 1; }

    /// The members of an object or the values of an array, in written order.
    class ChildRange {
    public:
        class Iterator {
        public:
            Iterator(const JsonTree* tree, JsonId at) : tree_(tree), at_(at) {}
            JsonId operator*() const { return at_; }
            Iterator& operator++() {
                at_ = tree_->at(at_).end;
                return *this;
            }
            friend bool operator!=(const Iterator& a, const Iterator& b) { return a.at_ != b.at_; }

        private:
            const JsonTree* tree_;
            JsonId at_;
        };
        ChildRange(const JsonTree* tree, JsonId first, JsonId last)
            : tree_(tree), first_(first), last_(last) {}
        Iterator begin() const { return {tree_, first_}; }
        Iterator end() const { return {tree_, last_}; }

    private:
        const JsonTree* tree_;
        JsonId first_, last_;
    };
    ChildRange children(JsonId v) const { return {this, {v.index + 1}, at(v).end}; }

    // Building ----------------------------------------------------------------------------------

    Piece add_string(std::string_view s);
    /// Adds a value inside `parent` (none for the root); `key` is empty inside an array. An array
    /// or object is filled next, and close()d then.
    JsonId add(JsonId parent, std::string_view key, Kind kind, std::string_view text = {});
    void close(JsonId v) { values[v.index].end = {static_cast<std::uint32_t>(values.size())}; }
};

/// The value that `text` spells, or none and an error at the first place that is not JSON (RFC
/// 8259); takes time proportional to the text and never recurses. Numbers keep their spelling.
/// `file` is the text's index in `diagnostics`. The limits are the document's: a JSON text may have
/// 4 levels per element.
///
/// Errors: "json-syntax", "duplicate-member", "encoding", "character" (one that XML cannot hold),
/// "too-large".
std::optional<JsonTree> parse_json(std::string_view text, std::uint32_t file,
                                   Diagnostics& diagnostics, const DocumentLimits& limits = {});

/// "a number", "text", "an array", "true": what a value is, for "found …". A boolean's text belongs
/// to `json`.
std::string_view article(const JsonTree& json, JsonId value);

/// The value as JSON: two spaces of indentation, arrays and objects on one line where they fit in
/// 100 columns, a line feed at the end.
std::string print_json(const JsonTree& tree);

}  // namespace trellis
