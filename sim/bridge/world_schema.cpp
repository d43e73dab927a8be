// World files as JSON Schema: a definition for each object of the table.
// SPDX-License-Identifier: MIT
#include "sim/bridge/world_grammar.h"

namespace trellis {
namespace {

using Kind = WorldMember::Kind;
using Limit = WorldMember::Limit;

/// Writes schemas into one JSON value.
class SchemaWriter {
public:
    std::string write() {
        const JsonId root = open({}, "", JsonValue::Kind::object);
        text(root, "$schema", "http://json-schema.org/draft-07/schema#");
        text(root, "title", "Trellis world file");
        text(root, "$ref", "#/definitions/world");
        const JsonId definitions = open(root, "definitions", JsonValue::Kind::object);
        WorldObject last = WorldObject::none;
        for (const WorldMember& member : world_members()) {
            if (member.object != last) definition(definitions, member);
            last = member.object;
        }
        point(definitions);
        json_.close(definitions);
        json_.close(root);
        return print_json(json_);
    }

private:
    /// The object to which a member, its first, belongs.
    void definition(JsonId definitions, const WorldMember& first) {
        const JsonId schema = open(definitions, name(first.object), JsonValue::Kind::object);
        text(schema, "type", "object");
        const JsonId properties = open(schema, "properties", JsonValue::Kind::object);
        const JsonId doc = open(properties, "doc", JsonValue::Kind::object);
        text(doc, "type", "string");
        text(doc, "description", "a comment");
        json_.close(doc);
        for (const WorldMember& member : world_members()) {
            if (member.object == first.object) property(properties, member);
        }
        json_.close(properties);
        const JsonId patterns = open(schema, "patternProperties", JsonValue::Kind::object);
        json_.add(patterns, "^\\$", JsonValue::Kind::boolean, "true");
        json_.close(patterns);
        json_.add(schema, "additionalProperties", JsonValue::Kind::boolean, "false");
        const JsonId required = open(schema, "required", JsonValue::Kind::array);
        for (const WorldMember& member : world_members()) {
            if (member.object == first.object && member.need == WorldMember::Need::needed)
                json_.add(required, "", JsonValue::Kind::string, member.name);
        }
        json_.close(required);
        json_.close(schema);
    }

    void property(JsonId properties, const WorldMember& member) {
        const JsonId schema = open(properties, member.name, JsonValue::Kind::object);
        text(schema, "description", member.doc);
        switch (member.kind) {
        case Kind::text: text(schema, "type", "string"); break;
        case Kind::number:
            text(schema, "type", "number");
            limit(schema, member.limit);
            break;
        case Kind::point: reference_in_all_of(schema, "point"); break;
        case Kind::points: list(schema, "point", 3); break;
        case Kind::object: reference_in_all_of(schema, name(member.of)); break;
        case Kind::list:
            list(schema, name(member.of), member.need == WorldMember::Need::needed ? 1 : 0);
            break;
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

    void list(JsonId schema, std::string_view definition, int least) {
        text(schema, "type", "array");
        const JsonId items = open(schema, "items", JsonValue::Kind::object);
        text(items, "$ref", "#/definitions/" + std::string(definition));
        json_.close(items);
        if (least > 0) number(schema, "minItems", std::to_string(least));
    }

    /// Beside a "$ref", draft 7 reads nothing, not even a description: it gets an object of its
    /// own.
    void reference_in_all_of(JsonId schema, std::string_view definition) {
        const JsonId all = open(schema, "allOf", JsonValue::Kind::array);
        const JsonId reference = open(all, "", JsonValue::Kind::object);
        text(reference, "$ref", "#/definitions/" + std::string(definition));
        json_.close(reference);
        json_.close(all);
    }

    static std::string_view name(WorldObject object) {
        switch (object) {
        case WorldObject::none: break;
#define OBJECT(name, article)                                                                      \
    case WorldObject::name:                                                                        \
        return #name;
#define MEMBER(object, name, kind, of, need, limit, doc)
#include "sim/bridge/world_grammar.def"
        }
        return "";
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

    JsonTree json_;
};

}  // namespace

std::string world_schema() {
    return SchemaWriter().write();
}

}  // namespace trellis
