// A kind of file as JSON Schema: a definition for each object of the table.
// SPDX-License-Identifier: MIT
#include "sim/bridge/file_grammar.h"

#include <algorithm>

namespace trellis {
namespace {

using Kind = FileMember::Kind;
using Limit = FileMember::Limit;

/// Writes schemas into one JSON value.
class SchemaWriter {
public:
    explicit SchemaWriter(const FileGrammar& grammar) : grammar_(grammar) {}

    std::string write() {
        const JsonId root = open({}, "", JsonValue::Kind::object);
        text(root, "$schema", "http://json-schema.org/draft-07/schema#");
        text(root, "title", grammar_.title);
        text(root, "$ref", reference(1));
        const JsonId definitions = open(root, "definitions", JsonValue::Kind::object);
        std::uint8_t last = 0;
        for (const FileMember& member : grammar_.members) {
            if (member.object != last) definition(definitions, member);
            last = member.object;
        }
        if (uses(Kind::point) || uses(Kind::points)) point(definitions);
        json_.close(definitions);
        json_.close(root);
        return print_json(json_);
    }

private:
    /// The object to which a member, its first, belongs.
    void definition(JsonId definitions, const FileMember& first) {
        const JsonId schema =
            open(definitions, grammar_.objects[first.object].name, JsonValue::Kind::object);
        text(schema, "type", "object");
        const JsonId properties = open(schema, "properties", JsonValue::Kind::object);
        const JsonId doc = open(properties, "doc", JsonValue::Kind::object);
        text(doc, "type", "string");
        text(doc, "description", "a comment");
        json_.close(doc);
        for (const FileMember& member : grammar_.members) {
            if (member.object == first.object) property(properties, member);
        }
        json_.close(properties);
        const JsonId patterns = open(schema, "patternProperties", JsonValue::Kind::object);
        json_.add(patterns, "^\\$", JsonValue::Kind::boolean, "true");
        json_.close(patterns);
        json_.add(schema, "additionalProperties", JsonValue::Kind::boolean, "false");
        const JsonId required = open(schema, "required", JsonValue::Kind::array);
        for (const FileMember& member : grammar_.members) {
            if (member.object == first.object && member.need == FileMember::Need::needed)
                json_.add(required, "", JsonValue::Kind::string, member.name);
        }
        json_.close(required);
        json_.close(schema);
    }

    void property(JsonId properties, const FileMember& member) {
        const JsonId schema = open(properties, member.name, JsonValue::Kind::object);
        text(schema, "description", member.doc);
        switch (member.kind) {
        case Kind::text: text(schema, "type", "string"); break;
        case Kind::flag: text(schema, "type", "boolean"); break;
        case Kind::number:
        case Kind::whole:
            text(schema, "type", member.kind == Kind::whole ? "integer" : "number");
            limit(schema, member.limit);
            break;
        case Kind::point: reference_in_all_of(schema, "#/definitions/point"); break;
        case Kind::object: reference_in_all_of(schema, reference(member.of)); break;
        case Kind::settings: {
            text(schema, "type", "object");
            const JsonId values = open(schema, "additionalProperties", JsonValue::Kind::object);
            scalar(values);
            json_.close(values);
            break;
        }
        case Kind::points:
        case Kind::texts:
        case Kind::numbers:
        case Kind::scalars:
        case Kind::list: list(schema, member); break;
        }
        json_.close(schema);
    }

    void limit(JsonId schema, Limit limit) {
        switch (limit) {
        case Limit::any: break;
        case Limit::place:
            number(schema, "minimum", "-1000");
            number(schema, "maximum", "1000");
            break;
        case Limit::from_0:
            number(schema, "minimum", "0");
            number(schema, "maximum", "1000000");
            break;
        case Limit::above_0:
            number(schema, "exclusiveMinimum", "0");
            number(schema, "maximum", "1000000");
            break;
        case Limit::part:
            number(schema, "minimum", "0");
            number(schema, "maximum", "1");
            break;
        case Limit::cell:
            number(schema, "minimum", "0.005");
            number(schema, "maximum", "1");
            break;
        }
    }

    void point(JsonId definitions) {
        const JsonId schema = open(definitions, "point", JsonValue::Kind::object);
        text(schema, "type", "array");
        const JsonId items = open(schema, "items", JsonValue::Kind::object);
        text(items, "type", "number");
        limit(items, Limit::place);
        json_.close(items);
        number(schema, "minItems", "2");
        number(schema, "maxItems", "2");
        json_.close(schema);
    }

    void list(JsonId schema, const FileMember& member) {
        text(schema, "type", "array");
        const JsonId items = open(schema, "items", JsonValue::Kind::object);
        if (member.kind == Kind::list) text(items, "$ref", reference(member.of));
        if (member.kind == Kind::points) text(items, "$ref", "#/definitions/point");
        if (member.kind == Kind::texts) text(items, "type", "string");
        if (member.kind == Kind::scalars) scalar(items);
        if (member.kind == Kind::numbers) {
            text(items, "type", "number");
            limit(items, member.limit);
        }
        json_.close(items);
        const bool needed = member.need == FileMember::Need::needed;
        if (member.kind == Kind::points)
            number(schema, "minItems", "3");
        else if (needed)
            number(schema, "minItems", "1");
    }

    void scalar(JsonId schema) {
        const JsonId types = open(schema, "type", JsonValue::Kind::array);
        for (const std::string_view type : {"number", "string", "boolean"})
            json_.add(types, "", JsonValue::Kind::string, type);
        json_.close(types);
    }

    /// Beside a "$ref", draft 7 reads nothing, not even a description: it gets an object of its
    /// own.
    void reference_in_all_of(JsonId schema, std::string_view target) {
        const JsonId all = open(schema, "allOf", JsonValue::Kind::array);
        const JsonId reference = open(all, "", JsonValue::Kind::object);
        text(reference, "$ref", target);
        json_.close(reference);
        json_.close(all);
    }

    bool uses(Kind kind) const {
        return std::any_of(grammar_.members.begin(), grammar_.members.end(),
                           [&](const FileMember& member) { return member.kind == kind; });
    }

    std::string reference(std::uint8_t object) const {
        return "#/definitions/" + std::string(grammar_.objects[object].name);
    }

    JsonId open(JsonId parent, std::string_view key, JsonValue::Kind kind) {
        return json_.add(parent, key, kind);
    }
    void text(JsonId object, std::string_view key, std::string_view value) {
        json_.add(object, key, JsonValue::Kind::string, value);
    }
    void number(JsonId object, std::string_view key, std::string_view value) {
        json_.add(object, key, JsonValue::Kind::number, value);
    }

    const FileGrammar& grammar_;
    JsonTree json_;
};

}  // namespace

std::string file_schema(const FileGrammar& grammar) {
    return SchemaWriter(grammar).write();
}

}  // namespace trellis
