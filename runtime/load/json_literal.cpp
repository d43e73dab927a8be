// From the values of a JSON text to one Value, and from its places to those of the attribute.
// SPDX-License-Identifier: MIT
#include "load/json_literal.h"

#include "load/json_tree.h"
#include "load/text.h"

#include <algorithm>
#include <optional>
#include <string>

namespace trellis {

namespace {

/// How many bytes of the text lie before a place in it.
std::size_t offset_of(std::string_view text, Where where) {
    std::size_t begin = 0;
    for (std::uint32_t line = 1; line < where.line; ++line) {
        begin = text.find('\n', begin) + 1;
    }
    return std::min(begin + where.column - 1, text.size());
}

// Recursion is as deep as Value::max_depth: the parser saw to that.
Value value_of(const JsonTree& json, JsonId v) {
    switch (json.kind(v)) {
    case JsonValue::Kind::null: return Value::null();
    case JsonValue::Kind::boolean: return Value::boolean(json.text(v) == "true");
    case JsonValue::Kind::number: return literal_value(json.text(v));
    case JsonValue::Kind::string: return Value::text(json.text(v));
    case JsonValue::Kind::array: {
        Value array = Value::array();
        for (const JsonId element : json.children(v)) {
            array.append(value_of(json, element));
        }
        return array;
    }
    case JsonValue::Kind::object: break;
    }
    Value object = Value::object();
    for (const JsonId member : json.children(v)) {
        object.set_member(json.key(member), value_of(json, member));
    }
    return object;
}

/// The parser speaks of files.
std::string reworded(std::string message) {
    constexpr std::string_view file = "the end of the file";
    if (message.ends_with(file)) {
        message.replace(message.size() - file.size(), file.size(), "the end of the literal");
    }
    return message;
}

}  // namespace

Value json_literal(Builder& builder, const Builder::Text& text) {
    const std::string_view json_text = text.text.substr(json_prefix.size());
    if (trimmed(json_text).empty()) {
        builder.diagnostics().error("json-syntax", text.where, "there is no value after json:");
        return {};
    }
    Diagnostics own;
    const std::uint32_t file = own.add_file({}, json_text);
    // arrays and objects may nest as deep as a Value's: 4 levels for each of an element, and 4
    const DocumentLimits limits{.depth = (Value::max_depth - 4) / 4};
    const std::optional<JsonTree> json = parse_json(json_text, file, own, limits);
    for (const Diagnostic& d : own.all()) {
        const std::size_t offset = json_prefix.size() + offset_of(json_text, d.where);
        builder.diagnostics().error(d.id, builder.place_in(text, offset), reworded(d.message));
    }
    return json && own.ok() ? value_of(*json, json->root()) : Value();
}

}  // namespace trellis
