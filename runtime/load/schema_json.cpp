// Writes a grammar as JSON Schema, draft 7: a definition for each rule, whose members are the
// rule's attributes and what the JSON spelling makes of its children. Covered by
// tests/load/schema_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/schema_json.h"

#include "load/json_tree.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>
#include <vector>

namespace trellis {

namespace {

using Json = nlohmann::ordered_json;

Json reference(std::string_view definition) {
    return {{"$ref", "#/definitions/" + std::string(definition)}};
}

Json array_of(Json items) {
    return {{"type", "array"}, {"items", std::move(items)}};
}

/// Anchors a regular expression, which JSON Schema searches for.
std::string anchored(const std::string& expression) {
    return "^(" + expression + ")$";
}

/// A text that a JSON file may also write as a number, true or false.
Json any_text() {
    return {{"type", {"string", "number", "boolean"}}};
}

/// The values that an attribute takes: strings, or bare where the spelling is that of a number,
/// true or false.
Json value_schema(const AttributeRule& rule) {
    const std::string expression = anchored(pattern(rule));
    switch (rule.type) {
    case ValueType::text:
    case ValueType::script:
    case ValueType::expression: return any_text();
    case ValueType::int32:
    case ValueType::int64: return {{"type", {"integer", "string"}}, {"pattern", expression}};
    case ValueType::count:
        return {{"type", {"integer", "string"}}, {"pattern", expression}, {"minimum", 0}};
    case ValueType::number: return {{"type", {"number", "string"}}, {"pattern", expression}};
    case ValueType::boolean:
        return {{"anyOf",
                 {{{"type", "boolean"}},
                  {{"enum", {0, 1}}},
                  {{"type", "string"}, {"pattern", expression}}}}};
    case ValueType::key: return {{"type", "string"}, {"pattern", expression}};
    case ValueType::name:
        return {{"type", {"string", "number", "boolean"}}, {"pattern", expression}};
    case ValueType::names:
        return {{"anyOf",
                 {{{"type", {"string", "number", "boolean"}}, {"pattern", expression}},
                  {{"type", "array"},
                   {"items", {{"type", "string"}, {"pattern", expression}}},
                   {"minItems", 1}}}}};
    case ValueType::choice:
        if (rule.may_be_pointer) { return {{"type", "string"}, {"pattern", expression}}; }
        return {{"enum", rule.choices}};
    }
    return any_text();
}

Json attribute_schema(const AttributeRule& rule) {
    std::string doc = rule.doc;
    if (!rule.unit.empty()) { doc += (doc.empty() ? "" : ", ") + ("in " + rule.unit); }
    Json out = Json::object();
    if (!doc.empty()) { out["description"] = doc; }
    out.update(value_schema(rule));
    if (!rule.initial.empty() && !rule.required) { out["default"] = rule.initial; }
    return out;
}

/// An object whose members are the attributes of a rule; members for children are added to it.
class ObjectSchema {
public:
    explicit ObjectSchema(const ElementRule& rule) : open_(rule.open) {
        schema_["description"] = rule.doc;
        schema_["type"] = "object";
        properties_["doc"] = {{"type", "string"}, {"description", "a comment"}};
        for (const AttributeRule& attribute : rule.attributes) {
            properties_[attribute.name] = attribute_schema(attribute);
            if (attribute.required && !attribute.constant_in_json) {
                required_attributes_.push_back(attribute.name);
            }
        }
    }

    /// Puts references to definitions/of_every_node in the place of the last `count` attributes.
    void share(const ElementRule& rule, std::size_t count) {
        for (std::size_t i = rule.attributes.size() - count; i < rule.attributes.size(); ++i) {
            const std::string& name = rule.attributes[i].name;
            properties_[name] = reference("of_every_node/" + name);
        }
    }
    void member(const std::string& name, Json schema, bool required = false) {
        properties_[name] = std::move(schema);
        if (required) { required_.push_back(name); }
    }
    /// Lets attributes stand inside another member as well, where they are not checked: it is for
    /// those whose names mean something else in the object itself.
    void attributes_in(const std::string& name) {
        properties_[name] = {{"type", "object"}, {"additionalProperties", any_text()}};
        outside_of_ = name;
    }
    /// Lets members pass whose names match.
    void passed_over(const std::string& expression, Json schema) {
        patterns_[expression] = std::move(schema);
    }

    Json finish() {
        patterns_["^\\$"] = true;  // "$schema" and its like are for other programs
        if (!required_.empty()) { schema_["required"] = required_; }
        if (!required_attributes_.empty() && outside_of_.empty()) {
            for (const std::string& name : required_attributes_) {
                schema_["required"].push_back(name);
            }
        } else if (!required_attributes_.empty()) {
            schema_["if"] = {{"not", {{"required", {outside_of_}}}}};
            schema_["then"] = {{"required", required_attributes_}};
        }
        schema_["properties"] = std::move(properties_);
        schema_["patternProperties"] = std::move(patterns_);
        const bool open =
            open_ == ElementRule::Open::parameters || open_ == ElementRule::Open::named;
        schema_["additionalProperties"] = open ? any_text() : Json(false);
        return std::move(schema_);
    }

private:
    ElementRule::Open open_;
    Json schema_ = Json::object();
    Json properties_ = Json::object();
    Json patterns_ = Json::object();
    std::vector<std::string> required_, required_attributes_;
    std::string outside_of_;  // the member that attributes may stand in
};

// Trees -----------------------------------------------------------------------------------------

/// A tree file: TREES, "JSON". Every element has a long form, {"type": name, …, "children": […]};
/// what is around the nodes has a short one as well.
class TreeSchema {
public:
    explicit TreeSchema(const Grammar& grammar) : grammar_(grammar) {}

    Json write() {
        ObjectSchema root = object(rule("root"));
        const Json include = {{"anyOf", {{{"type", "string"}}, reference("short_include")}}};
        root.member("include",
                    {{"anyOf", {{{"type", "string"}}, array_of(long_or("include", include))}}});
        root.member("trees", array_of(long_or("tree", reference("short_tree"))));
        root.member("models", array_of(long_or("any_model", reference("short_model"))));
        root.member("extra", array_of(reference("any_root_parts")));

        write_node_attributes();
        write_groups();
        write_short_forms();
        Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                    {"$comment", "Generated; do not edit."},
                    {"title", "Tree file of Trellis"}};
        out.update(root.finish());
        out["definitions"] = std::move(definitions_);
        return out;
    }

private:
    ObjectSchema object(const ElementRule& rule) const {
        ObjectSchema out(rule);
        if (rule.node) { out.share(rule, grammar_.node_attributes); }
        out.passed_over(passed_over_names, any_text());
        out.attributes_in("ports");
        return out;
    }
    const ElementRule& rule(std::string_view id) const {
        return *std::find_if(grammar_.rules.begin(), grammar_.rules.end(),
                             [&](const ElementRule& r) { return r.id == id; });
    }

    /// The long form of a rule where there is a "type", else the short form.
    static Json long_or(std::string_view definition, Json short_form) {
        return {{"if", {{"type", "object"}, {"required", {"type"}}}},
                {"then", reference(definition)},
                {"else", std::move(short_form)}};
    }

    void write_node_attributes() {
        const ElementRule& node = grammar_.at(grammar_.at(grammar_.nodes).rules.front());
        for (std::size_t i = node.attributes.size() - grammar_.node_attributes;
             i < node.attributes.size(); ++i) {
            const AttributeRule& attribute = node.attributes[i];
            definitions_["of_every_node"][attribute.name] = attribute_schema(attribute);
        }
    }

    /// For each group, what may stand there: the rule that "type" names.
    void write_groups() {
        for (const Group& group : grammar_.groups) {
            Json names = Json::array();
            Json cases = Json::array();
            for (const RuleId id : group.rules) {
                const ElementRule& rule = grammar_.at(id);
                names.push_back(rule.name);
                cases.push_back({{"if", {{"properties", {{"type", {{"const", rule.name}}}}}}},
                                 {"then", reference(rule.id)}});
                if (!definitions_.contains(rule.id)) { definitions_[rule.id] = long_form(rule); }
            }
            definitions_["any_" + group.id] = {{"type", "object"},
                                               {"required", {"type"}},
                                               {"properties", {{"type", {{"enum", names}}}}},
                                               {"allOf", cases}};
        }
    }

    Json long_form(const ElementRule& rule) const {
        ObjectSchema out = object(rule);
        out.member("type", {{"const", rule.name}}, true);
        if (rule.text) {
            out.member("children", array_of({{"type", "string"}}));
        } else {
            Json children = {{"type", "array"}};
            if (rule.group) { children["items"] = reference("any_" + grammar_.at(rule.group).id); }
            if (rule.least > 0) { children["minItems"] = rule.least; }
            if (rule.most != ElementRule::many) { children["maxItems"] = rule.most; }
            out.member("children", children, rule.least > 0);
        }
        return out.finish();
    }

    void write_short_forms() {
        definitions_["short_include"] = object(rule("include")).finish();

        ObjectSchema tree = object(rule("tree"));
        tree.member("root", reference("any_node"));
        tree.member("children", {{"type", "array"},
                                 {"items", reference("any_node")},
                                 {"minItems", 1},
                                 {"maxItems", 1}});
        Json schema = tree.finish();
        schema["oneOf"] = {{{"required", {"root"}}}, {{"required", {"children"}}}};
        definitions_["short_tree"] = std::move(schema);

        // all kinds of model have the same attributes, all directions of ports too
        const ElementRule& models = rule("models");
        Json kinds = Json::array();
        for (const RuleId id : grammar_.at(models.group).rules) {
            kinds.push_back(grammar_.at(id).name);
        }
        ObjectSchema model(rule("model_action"));
        model.passed_over(passed_over_names, any_text());
        model.member("kind", {{"enum", kinds}}, true);
        model.member("ports", array_of(reference("short_port")));
        definitions_["short_model"] = model.finish();

        ObjectSchema port(rule("input_port"));
        port.passed_over(passed_over_names, any_text());
        port.member("direction", {{"enum", {"input", "output", "inout"}}}, true);
        port.member("description", {{"type", "string"}});
        definitions_["short_port"] = port.finish();
    }

    /// At most a warning; declarations of prefixes; where an XML editor finds the schema.
    static constexpr const char* passed_over_names =
        "^(_|xmlns:|xsi:(schemaLocation|noNamespaceSchemaLocation)$)";

    const Grammar& grammar_;
    Json definitions_ = Json::object();
};

// Machines --------------------------------------------------------------------------------------

/// A machine file: MACHINES, "JSON". Elements of other namespaces stand in it as XML, and pass.
class MachineSchema {
public:
    explicit MachineSchema(const Grammar& grammar) : grammar_(grammar) {}

    Json write() {
        const ElementRule& root = grammar_.at(grammar_.root);
        Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                    {"$comment", "Generated; do not edit."},
                    {"title", "Machine file of Trellis"}};
        out.update(object(root));
        for (const ElementRule& rule : grammar_.rules) {
            if (!has_own_form(rule)) { definitions_[rule.id] = object(rule); }
        }
        write_shared();
        out["definitions"] = std::move(definitions_);
        return out;
    }

private:
    /// Attributes of other namespaces, and declarations of their prefixes.
    static constexpr const char* other_namespaces = "^(\\{|xmlns:)";

    static bool is_one_of(const ElementRule& rule, const std::vector<std::string_view>& ids) {
        return std::find(ids.begin(), ids.end(), rule.id) != ids.end();
    }
    /// Rules that JSON does not spell as one object.
    static bool has_own_form(const ElementRule& rule) {
        return is_one_of(rule, {"scxml", "datamodel", "initial", "onentry", "onexit", "if",
                                "elseif", "else", "finalize"});
    }
    /// Rules whose object may have an "xml" member: what is in it, the schema cannot see.
    static bool may_hold_xml(const ElementRule& rule) {
        return is_one_of(rule, {"scxml", "state", "parallel", "final", "history", "data", "assign",
                                "script", "invoke", "param", "send", "content", "invoke_content",
                                "donedata"});
    }

    Json object(const ElementRule& rule) const {
        ObjectSchema out(rule);
        if (rule.text) { out.member("text", {{"type", "string"}}); }
        if (may_hold_xml(rule)) { out.member("xml", {{"type", "string"}}); }
        if (is_one_of(rule, {"scxml", "state", "parallel", "final", "history"})) {
            // an empty array stands for no element, wherever it is
            for (const char* list :
                 {"data", "scripts", "onentry", "onexit", "invoke", "transitions", "states"}) {
                out.member(list, {{"type", "array"}, {"maxItems", 0}});
            }
        }
        if (rule.group) { add_children(out, grammar_.at(rule.group)); }
        if (is_one_of(rule, {"state", "parallel", "final", "history"})) {
            out.member("kind", {{"const", rule.id}}, rule.id != "state");
        }
        if (rule.id == "scxml") { out.member("xmlns", {{"const", scxml_namespace}}); }
        out.attributes_in("attributes");
        out.passed_over(other_namespaces, any_text());
        return out.finish();
    }

    /// What the children of an element become.
    void add_children(ObjectSchema& out, const Group& group) const {
        if (group.id == "executable") {
            out.member("do", reference("block"));
            return;
        }
        for (const RuleId child : group.rules) {
            const std::string& id = grammar_.at(child).id;
            if (id == "state") {
                out.member("states", array_of(reference("any_state")));
            } else if (id == "transition") {
                out.member("transitions", array_of(reference("transition")));
            } else if (id == "onentry" || id == "onexit") {
                out.member(id, reference("blocks"));
            } else if (id == "datamodel") {
                out.member("data", array_of(reference("data")));
            } else if (id == "initial") {
                out.member("initialTransition", reference("initial_transition"));
            } else if (id == "script") {
                out.member("scripts", array_of(reference("script")));
            } else if (id == "param") {
                out.member("params", array_of(reference("param")));
            } else if (id == "invoke") {
                out.member("invoke", array_of(reference("invoke")));
            } else if (id == "initial_transition") {
                Json one = array_of(reference(id));
                one["minItems"] = 1;
                one["maxItems"] = 1;
                out.member("transitions", one, true);
            } else if (id == "donedata" || id == "invoke_content") {
                out.member(grammar_.at(child).name, reference(id));
            } else if (id == "content") {
                out.member(id, {{"anyOf", {reference(id), {{"type", "string"}}}}});
            } else if (id == "finalize") {
                out.member(id, reference("block"));
            } else if (id == "scxml") {
                out.member(id, {{"$ref", "#"}});
            }
        }
    }

    void write_shared() {
        Json any_state = reference("state");
        for (const char* kind : {"history", "final", "parallel"}) {
            any_state = {
                {"if", {{"required", {"kind"}}, {"properties", {{"kind", {{"const", kind}}}}}}},
                {"then", reference(kind)},
                {"else", std::move(any_state)}};
        }
        definitions_["any_state"] = std::move(any_state);
        definitions_["blocks"] = {{"description", "blocks of executable content; or one block"},
                                  {"anyOf", {array_of(reference("block")), reference("block")}}};
        definitions_["block"] = array_of(reference("action"));

        Json actions = Json::object();
        for (const RuleId rule : grammar_.at(group_of("transition")).rules) {
            const std::string& id = grammar_.at(rule).id;
            if (id == "if") { continue; }
            actions[id] = reference(id);
            if (const char* only = shorthand(id)) {
                const AttributeRule* attribute = grammar_.at(rule).find(only);
                Json text = attribute != nullptr ? value_schema(*attribute) : Json::object();
                text["type"] = "string";
                actions[id] = {{"description", std::string("or only its ") + only},
                               {"anyOf", {reference(id), text}}};
            }
        }
        actions["if"] = reference("if");
        definitions_["action"] = {{"description", "one step: an object with one member"},
                                  {"type", "object"},
                                  {"minProperties", 1},
                                  {"maxProperties", 1},
                                  {"properties", actions},
                                  {"patternProperties", {{"^\\{", {{"type", "object"}}}}},
                                  {"additionalProperties", false}};
        write_if();
    }

    /// What an action is if it is written as a text instead of an object; null if it may not be.
    static const char* shorthand(std::string_view action) {
        if (action == "raise") { return "event"; }
        if (action == "log") { return "expr"; }
        if (action == "cancel") { return "sendid"; }
        return action == "script" ? "text" : nullptr;
    }

    GroupId group_of(std::string_view element) const {
        return grammar_.at(grammar_.find(element)).group;
    }

    void write_if() {
        const ElementRule& rule = grammar_.at(grammar_.find("if"));
        const auto branch = [&](bool first) {
            ObjectSchema out(grammar_.at(grammar_.find(first ? "if" : "elseif")));
            out.member("do", reference("block"));
            out.passed_over(other_namespaces, any_text());
            Json schema = out.finish();
            if (!first) {
                schema["description"] = "another branch; the last one may have no cond";
                schema.erase("required");  // without cond it is the else
            }
            return schema;
        };
        definitions_["if"] = {{"description", rule.doc},
                              {"type", "array"},
                              {"minItems", 1},
                              {"items", {branch(true)}},
                              {"additionalItems", reference("branch")}};
        definitions_["branch"] = branch(false);
    }

    const Grammar& grammar_;
    Json definitions_ = Json::object();
};

/// In the layout of all our JSON files.
std::string printed(const Json& schema) {
    Diagnostics none;
    const std::string text = schema.dump();
    return print_json(*parse_json(text, none.add_file("", text), none));
}

}  // namespace

std::string json_schema(const Grammar& grammar) {
    return printed(grammar.kind == FileKind::machine ? MachineSchema(grammar).write()
                                                     : TreeSchema(grammar).write());
}

}  // namespace trellis
