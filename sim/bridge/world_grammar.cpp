// The table, and checking a file against it.
// SPDX-License-Identifier: MIT
#include "sim/bridge/world_grammar.h"

#include "core/number.h"
#include "load/text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace trellis {
namespace {

using Kind = WorldMember::Kind;
using Limit = WorldMember::Limit;
using Need = WorldMember::Need;

constexpr WorldMember members[] = {
#define OBJECT(name, article)
#define MEMBER(object, name, kind, of, need, limit, doc)                                           \
    {WorldObject::object, #name, Kind::kind, WorldObject::of, Need::need, Limit::limit, doc},
#include "sim/bridge/world_grammar.def"
};

const WorldMember* find(WorldObject object, std::string_view name) {
    for (const WorldMember& member : members) {
        if (member.object == object && member.name == name) return &member;
    }
    return nullptr;
}

/// What is wrong with a number, as "above 0"; empty if nothing is.
std::string_view broken(Limit limit, double value) {
    const double size = std::fabs(value);
    switch (limit) {
    case Limit::place: return size <= 1000.0 ? "" : "from -1000 to 1000";
    case Limit::from_0: return value >= 0.0 && size <= 1e6 ? "" : "from 0 to 1000000";
    case Limit::above_0: return value > 0.0 && size <= 1e6 ? "" : "above 0, up to 1000000";
    case Limit::part: return value >= 0.0 && value <= 1.0 ? "" : "from 0 to 1";
    case Limit::any: break;
    }
    return "";
}

/// Goes through the values of a file, object by object.
class Checker {
public:
    Checker(const JsonTree& json, Diagnostics& diagnostics)
        : json_(json), diagnostics_(diagnostics) {}

    void object(JsonId value, WorldObject kind, std::string_view title) {
        if (!expect(value, JsonValue::Kind::object, title)) return;
        for (const JsonId child : json_.children(value)) {
            const std::string_view key = json_.key(child);
            if (const WorldMember* rule = find(kind, key))
                member(child, *rule);
            else if (key == "doc")
                expect(child, JsonValue::Kind::string, quoted(key));
            else if (!key.starts_with('$'))
                unknown(child, kind);
        }
        for (const WorldMember& rule : members) {
            if (rule.object == kind && rule.need == Need::needed && !json_.member(value, rule.name))
                diagnostics_.structural_error("json-member", json_.at(value).where,
                                              std::string(article(kind)) + " needs " +
                                                  quoted(rule.name));
        }
    }

private:
    void member(JsonId value, const WorldMember& rule) {
        const std::string title = quoted(rule.name);
        switch (rule.kind) {
        case Kind::text: expect(value, JsonValue::Kind::string, title); break;
        case Kind::number: number(value, rule.limit, title); break;
        case Kind::point: point(value, title); break;
        case Kind::points:
            if (!expect(value, JsonValue::Kind::array, title)) break;
            for (const JsonId corner : json_.children(value))
                point(corner, "each value of " + title);
            if (count(value) < 3)
                diagnostics_.structural_error("bad-value", json_.at(value).where,
                                              title + " must be at least 3 points, found " +
                                                  std::to_string(count(value)));
            break;
        case Kind::object: object(value, rule.of, title); break;
        case Kind::list:
            if (!expect(value, JsonValue::Kind::array, title)) break;
            for (const JsonId child : json_.children(value))
                object(child, rule.of, "each value of " + title);
            if (rule.need == Need::needed && count(value) == 0)
                diagnostics_.structural_error("bad-value", json_.at(value).where,
                                              title + " must not be empty");
            break;
        }
    }

    void number(JsonId value, Limit limit, const std::string& title) {
        if (!expect(value, JsonValue::Kind::number, title)) return;
        const std::string_view text = json_.text(value);
        const std::string_view wanted = broken(limit, parse_whole_number(text).value);
        if (!wanted.empty())
            diagnostics_.structural_error("bad-value", json_.at(value).where,
                                          title + " must be " + std::string(wanted) + ", found " +
                                              std::string(text));
    }

    void point(JsonId value, const std::string& title) {
        const bool pair = json_.kind(value) == JsonValue::Kind::array && count(value) == 2;
        if (!pair) {
            diagnostics_.structural_error("json-type", json_.at(value).where,
                                          title + " must be [x, y]");
            return;
        }
        for (const JsonId coordinate : json_.children(value))
            number(coordinate, Limit::place, "a coordinate");
    }

    bool expect(JsonId value, JsonValue::Kind kind, std::string_view title) {
        if (json_.kind(value) == kind) return true;
        const std::string_view wanted = kind == JsonValue::Kind::array    ? "an array"
                                        : kind == JsonValue::Kind::object ? "an object"
                                        : kind == JsonValue::Kind::number ? "a number"
                                                                          : "text";
        diagnostics_.structural_error("json-type", json_.at(value).where,
                                      std::string(title) + " must be " + std::string(wanted) +
                                          ", found " + std::string(article(json_, value)));
        return false;
    }

    void unknown(JsonId value, WorldObject kind) {
        std::vector<std::string_view> known;
        for (const WorldMember& rule : members) {
            if (rule.object == kind) known.push_back(rule.name);
        }
        const std::string_view key = json_.key(value);
        diagnostics_.structural_error("json-member", json_.at(value).key_where,
                                      std::string(article(kind)) + " has no member " + quoted(key) +
                                          suggestion(key, known));
    }

    std::size_t count(JsonId array) const {
        std::size_t n = 0;
        for (const JsonId child : json_.children(array)) {
            static_cast<void>(child);
            ++n;
        }
        return n;
    }

    const JsonTree& json_;
    Diagnostics& diagnostics_;
};

}  // namespace

std::span<const WorldMember> world_members() {
    return members;
}

std::string_view article(WorldObject object) {
    switch (object) {
    case WorldObject::none: break;
#define OBJECT(name, article)                                                                      \
    case WorldObject::name:                                                                        \
        return article;
#define MEMBER(object, name, kind, of, need, limit, doc)
#include "sim/bridge/world_grammar.def"
    }
    return "";
}

void check_world(const JsonTree& json, Diagnostics& diagnostics) {
    Checker(json, diagnostics).object(json.root(), WorldObject::world, "the file");
}

}  // namespace trellis
