// Searching, building and printing JSON values. Covered by tests/load/json_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/json_tree.h"

#include "load/text.h"

#include <algorithm>

namespace trellis {

JsonId JsonTree::member(JsonId object, std::string_view wanted) const {
    if (kind(object) != Kind::object) { return {}; }
    for (const JsonId m : children(object)) {
        if (key(m) == wanted) { return m; }
    }
    return {};
}

Piece JsonTree::add_string(std::string_view s) {
    const Piece piece{static_cast<std::uint32_t>(strings.size()),
                      static_cast<std::uint32_t>(s.size())};
    strings += s;
    return piece;
}

JsonId JsonTree::add(JsonId parent, std::string_view key, Kind kind, std::string_view text) {
    const JsonId v{static_cast<std::uint32_t>(values.size())};
    JsonValue value;
    value.kind = kind;
    value.key = add_string(key);
    value.text = add_string(text);
    value.parent = parent;
    value.end = {v.index + 1};
    values.push_back(value);
    return v;
}

namespace {

constexpr std::size_t line_columns = 100;
constexpr std::size_t indent_columns = 2;

void append_quoted(std::string& out, std::string_view s) {
    out += '"';
    for (const char c : s) {
        switch (c) {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '\n': out += "\\n"; break;
        case '\t': out += "\\t"; break;
        case '\r': out += "\\r"; break;
        default:
            if (static_cast<unsigned char>(c) < 0x20) {
                const std::string code = character_code(static_cast<unsigned char>(c));
                out += "\\u" + code.substr(2);
            } else {
                out += c;
            }
        }
    }
    out += '"';
}

class Printer {
public:
    explicit Printer(const JsonTree& tree) : tree_(tree), columns_(tree.values.size()) {
        // from the last value to the first, so that what is inside has been measured before
        for (std::size_t i = tree.values.size(); i-- > 0;) {
            columns_[i] = measure({static_cast<std::uint32_t>(i)});
        }
    }

    std::string print() {
        append(tree_.root(), 0);
        return std::move(out_) + "\n";
    }

private:
    using Kind = JsonTree::Kind;

    bool is_scalar(JsonId v) const {
        return tree_.kind(v) != Kind::array && tree_.kind(v) != Kind::object;
    }
    bool in_object(JsonId v) const {
        return tree_.at(v).parent && tree_.kind(tree_.at(v).parent) == Kind::object;
    }

    static std::size_t columns(std::string_view s) {
        return static_cast<std::size_t>(std::count_if(s.begin(), s.end(), [](char c) {
            return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
        }));
    }

    /// Columns of a value with its key on one line.
    std::size_t measure(JsonId v) {
        scratch_.clear();
        if (in_object(v)) {
            append_quoted(scratch_, tree_.key(v));
            scratch_ += ": ";
        }
        if (is_scalar(v)) { append_scalar(scratch_, v); }
        std::size_t sum = columns(scratch_);
        if (is_scalar(v)) { return sum; }
        for (const JsonId child : tree_.children(v)) {
            sum += columns_[child.index] + 2;
        }
        // the brackets, and the blanks inside braces; one comma fewer than children
        if (!tree_.has_children(v)) { return sum + 2; }
        return sum + (tree_.kind(v) == Kind::object ? 2 : 0);
    }

    void append_scalar(std::string& out, JsonId v) const {
        if (tree_.kind(v) == Kind::string) {
            append_quoted(out, tree_.text(v));
        } else {
            out += tree_.text(v);
        }
    }

    /// Writes v at the end of a line that is indented by `depth` levels.
    void append(JsonId v, std::size_t depth) {
        if (in_object(v)) {
            append_quoted(out_, tree_.key(v));
            out_ += ": ";
        }
        if (is_scalar(v)) {
            append_scalar(out_, v);
            return;
        }
        const bool object = tree_.kind(v) == Kind::object;
        // one column for the comma behind it
        const bool one_line = depth * indent_columns + columns_[v.index] + 1 <= line_columns;
        out_ += object ? '{' : '[';
        bool first = true;
        for (const JsonId child : tree_.children(v)) {
            if (!first) { out_ += ','; }
            if (!one_line) {
                out_ += '\n';
                out_.append((depth + 1) * indent_columns, ' ');
            } else if (!first || object) {
                out_ += ' ';
            }
            append(child, depth + 1);
            first = false;
        }
        if (!one_line) {
            out_ += '\n';
            out_.append(depth * indent_columns, ' ');
        } else if (object && !first) {
            out_ += ' ';
        }
        out_ += object ? '}' : ']';
    }

    const JsonTree& tree_;
    std::vector<std::size_t> columns_;
    std::string scratch_;
    std::string out_;
};

}  // namespace

std::string_view article(const JsonTree& json, JsonId value) {
    switch (json.kind(value)) {
    case JsonValue::Kind::null: return "null";
    case JsonValue::Kind::boolean: return json.text(value);
    case JsonValue::Kind::number: return "a number";
    case JsonValue::Kind::string: return "text";
    case JsonValue::Kind::array: return "an array";
    case JsonValue::Kind::object: return "an object";
    }
    return {};
}

std::string print_json(const JsonTree& tree) {
    return Printer(tree).print();
}

}  // namespace trellis
