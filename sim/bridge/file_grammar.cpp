// Checking a file against its table, and taking values out of it.
// SPDX-License-Identifier: MIT
#include "sim/bridge/file_grammar.h"

#include "core/number.h"
#include "load/text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace trellis {
namespace {

using Kind = FileMember::Kind;
using Limit = FileMember::Limit;
using Need = FileMember::Need;

/// What is wrong with a number, as "above 0"; empty if nothing is.
std::string_view broken(Limit limit, double value) {
    const double size = std::fabs(value);
    switch (limit) {
    case Limit::place: return size <= 1000.0 ? "" : "from -1000 to 1000";
    case Limit::from_0: return value >= 0.0 && size <= 1e6 ? "" : "from 0 to 1000000";
    case Limit::above_0: return value > 0.0 && size <= 1e6 ? "" : "above 0, up to 1000000";
    case Limit::part: return value >= 0.0 && value <= 1.0 ? "" : "from 0 to 1";
    case Limit::cell: return value >= 0.005 && value <= 1.0 ? "" : "from 0.005 to 1";
    case Limit::any: break;
    }
    return "";
}

/// Goes through the values of a file, object by object.
class Checker {
public:
    Checker(const JsonTree& json, const FileGrammar& grammar, Diagnostics& diagnostics)
        : json_(json), grammar_(grammar), diagnostics_(diagnostics) {}

    void object(JsonId value, std::uint8_t kind, std::string_view title) {
        if (!expect(value, JsonValue::Kind::object, title)) return;
        for (const JsonId child : json_.children(value)) {
            const std::string_view key = json_.key(child);
            if (const FileMember* rule = find(kind, key))
                member(child, *rule);
            else if (key == "doc")
                expect(child, JsonValue::Kind::string, quoted(key));
            else if (!key.starts_with('$'))
                unknown(child, kind);
        }
        for (const FileMember& rule : grammar_.members) {
            if (rule.object == kind && rule.need == Need::needed && !json_.member(value, rule.name))
                diagnostics_.structural_error("json-member", json_.at(value).where,
                                              std::string(grammar_.objects[kind].article) +
                                                  " needs " + quoted(rule.name));
        }
    }

private:
    const FileMember* find(std::uint8_t object, std::string_view name) const {
        for (const FileMember& member : grammar_.members) {
            if (member.object == object && member.name == name) return &member;
        }
        return nullptr;
    }

    void member(JsonId value, const FileMember& rule) {
        const std::string title = quoted(rule.name);
        switch (rule.kind) {
        case Kind::text: expect(value, JsonValue::Kind::string, title); break;
        case Kind::number: number(value, rule.limit, title); break;
        case Kind::flag: expect(value, JsonValue::Kind::boolean, title); break;
        case Kind::whole: whole(value, rule.limit, title); break;
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
        case Kind::settings:
            if (!expect(value, JsonValue::Kind::object, title)) break;
            for (const JsonId child : json_.children(value))
                scalar(child, quoted(json_.key(child)));
            break;
        case Kind::texts:
        case Kind::numbers:
        case Kind::scalars:
        case Kind::list: list(value, rule, title); break;
        }
    }

    void list(JsonId value, const FileMember& rule, const std::string& title) {
        if (!expect(value, JsonValue::Kind::array, title)) return;
        const std::string each = "each value of " + title;
        for (const JsonId child : json_.children(value)) {
            if (rule.kind == Kind::list) object(child, rule.of, each);
            if (rule.kind == Kind::texts) expect(child, JsonValue::Kind::string, each);
            if (rule.kind == Kind::numbers) number(child, rule.limit, each);
            if (rule.kind == Kind::scalars) scalar(child, each);
        }
        if (rule.need == Need::needed && count(value) == 0)
            diagnostics_.structural_error("bad-value", json_.at(value).where,
                                          title + " must not be empty");
    }

    void scalar(JsonId value, const std::string& title) {
        const JsonValue::Kind kind = json_.kind(value);
        if (kind == JsonValue::Kind::number || kind == JsonValue::Kind::string ||
            kind == JsonValue::Kind::boolean)
            return;
        diagnostics_.structural_error("json-type", json_.at(value).where,
                                      title + " must be a number, text, true or false, found " +
                                          std::string(article(json_, value)));
    }

    /// A number that is written without a point or an exponent.
    void whole(JsonId value, Limit limit, const std::string& title) {
        number(value, limit, title);
        if (json_.kind(value) != JsonValue::Kind::number) return;
        const std::string_view text = json_.text(value);
        if (text.find_first_of(".eE") != std::string_view::npos)
            diagnostics_.structural_error("bad-value", json_.at(value).where,
                                          title + " must be a whole number, found " +
                                              std::string(text));
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
        const std::string_view wanted = kind == JsonValue::Kind::array     ? "an array"
                                        : kind == JsonValue::Kind::object  ? "an object"
                                        : kind == JsonValue::Kind::number  ? "a number"
                                        : kind == JsonValue::Kind::boolean ? "true or false"
                                                                           : "text";
        diagnostics_.structural_error("json-type", json_.at(value).where,
                                      std::string(title) + " must be " + std::string(wanted) +
                                          ", found " + std::string(article(json_, value)));
        return false;
    }

    void unknown(JsonId value, std::uint8_t kind) {
        std::vector<std::string_view> known;
        for (const FileMember& rule : grammar_.members) {
            if (rule.object == kind) known.push_back(rule.name);
        }
        const std::string_view key = json_.key(value);
        diagnostics_.structural_error("json-member", json_.at(value).key_where,
                                      std::string(grammar_.objects[kind].article) +
                                          " has no member " + quoted(key) + suggestion(key, known));
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
    const FileGrammar& grammar_;
    Diagnostics& diagnostics_;
};

}  // namespace

void check_file(const JsonTree& json, const FileGrammar& grammar, Diagnostics& diagnostics) {
    Checker(json, grammar, diagnostics).object(json.root(), 1, "the file");
}

std::string text_in(const JsonTree& json, JsonId object, std::string_view key) {
    const JsonId value = json.member(object, key);
    return value ? std::string(json.text(value)) : std::string();
}

double number_in(const JsonTree& json, JsonId object, std::string_view key, double otherwise) {
    const JsonId value = json.member(object, key);
    return value ? parse_whole_number(json.text(value)).value : otherwise;
}

std::vector<JsonId> list_in(const JsonTree& json, JsonId object, std::string_view key) {
    std::vector<JsonId> values;
    if (const JsonId array = json.member(object, key)) {
        for (const JsonId value : json.children(array))
            values.push_back(value);
    }
    return values;
}

}  // namespace trellis
