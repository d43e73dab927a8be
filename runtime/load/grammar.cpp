// Builds the grammars from their tables (grammar_tree.def, grammar_machine.def), the built-in nodes
// and their ports, and the registry. Covered by tests/load/grammar_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/grammar.h"

#include "core/program.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace trellis {

namespace {

/// The words of a list that is separated by single blanks; none for "".
std::vector<std::string> words(std::string_view list) {
    std::vector<std::string> out;
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        out.emplace_back(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return out;
}

/// The presence column of the tables.
enum class Presence : std::uint8_t { optional, required, in_xml };

/// The type column of the tables.
struct TypeColumn {
    ValueType type;
    std::string_view choices = {};

    constexpr TypeColumn(ValueType t) : type(t) {}
    constexpr TypeColumn(ValueType t, std::string_view list) : type(t), choices(list) {}
};

constexpr TypeColumn one_of(std::string_view list) {
    return {ValueType::choice, list};
}

AttributeRule attribute_rule(std::string_view name, TypeColumn type, Presence presence,
                             std::string_view initial, std::string_view doc) {
    AttributeRule rule;
    rule.name = name;
    rule.type = type.type;
    rule.choices = words(type.choices);
    rule.required = presence != Presence::optional;
    rule.constant_in_json = presence == Presence::in_xml;
    rule.initial = initial;
    rule.doc = doc;
    return rule;
}

/// Fills a Grammar line by line, in the order of the tables.
class GrammarBuilder {
public:
    GrammarBuilder(FileKind kind, const std::vector<std::string>& enumerators)
        : enumerators_(enumerators) {
        grammar_.kind = kind;
    }

    void group(std::string_view id, std::string_view members) {
        grammar_.groups.push_back({std::string(id), {}, {}});
        members_.push_back(words(members));
    }
    void element(std::string_view id, std::string_view name, std::string_view group,
                 std::uint32_t least, std::uint32_t most, bool text, ElementRule::Open open,
                 std::string_view doc) {
        ElementRule& rule = grammar_.rules.emplace_back();
        rule.id = id;
        rule.name = name;
        rule.doc = doc;
        rule.open = open;
        rule.text = text;
        rule.group = group_named(group);
        rule.least = least;
        rule.most = most;
    }
    void node(std::string_view id, std::string_view name, std::string_view group,
              std::uint32_t least, std::uint32_t most, ElementRule::Open open,
              std::string_view doc) {
        element(id, name, group, least, most, false, open, doc);
        last().node = true;
        nodes_.push_back({static_cast<std::uint32_t>(grammar_.rules.size() - 1)});
    }
    void attribute(AttributeRule rule) { last().attributes.push_back(std::move(rule)); }
    void port(AttributeRule rule) {
        if (rule.type == ValueType::int32 || rule.type == ValueType::int64) {
            rule.choices = enumerators_;
        }
        rule.may_be_pointer = true;
        attribute(std::move(rule));
    }
    void node_attribute(AttributeRule rule) { common_.push_back(std::move(rule)); }
    void parts(std::uint32_t least, std::uint32_t most, std::string_view list) {
        last().parts.push_back({least, most, words(list)});
    }
    void later(std::string_view element) { grammar_.later.emplace_back(element); }

    /// Resolves the names between the lines. The builder is used up.
    Grammar finish(std::string_view root) {
        for (const RuleId n : nodes_) {
            std::vector<AttributeRule>& attributes = grammar_.rules[n.index].attributes;
            attributes.insert(attributes.end(), common_.begin(), common_.end());
        }
        grammar_.node_attributes = static_cast<std::uint32_t>(common_.size());
        for (std::size_t g = 0; g < grammar_.groups.size(); ++g) {
            resolve(g);
        }
        grammar_.root = rule_named(root);
        return std::move(grammar_);
    }

private:
    ElementRule& last() { return grammar_.rules.back(); }

    GroupId group_named(std::string_view id) const {
        for (std::uint32_t g = 0; g < grammar_.groups.size(); ++g) {
            if (grammar_.groups[g].id == id) { return {g}; }
        }
        assert(id == "no_group");
        return {};
    }
    RuleId rule_named(std::string_view id) const {
        for (std::uint32_t r = 0; r < grammar_.rules.size(); ++r) {
            if (grammar_.rules[r].id == id) { return {r}; }
        }
        assert(false && "a group names a rule that does not exist");
        return {};
    }
    void resolve(std::size_t g) {
        Group& group = grammar_.groups[g];
        if (group.id == "node") {
            grammar_.nodes = {static_cast<std::uint32_t>(g)};
            group.rules = nodes_;
        }
        for (const std::string& member : members_[g]) {
            group.rules.push_back(rule_named(member));
        }
        group.by_name = group.rules;
        std::stable_sort(group.by_name.begin(), group.by_name.end(), [this](RuleId a, RuleId b) {
            return grammar_.at(a).name < grammar_.at(b).name;
        });
    }

    Grammar grammar_;
    std::vector<std::string> enumerators_;
    std::vector<std::vector<std::string>> members_;  // of each group: ids of rules
    std::vector<AttributeRule> common_;              // of all nodes
    std::vector<RuleId> nodes_;
};

/// The built-in nodes that have a spelling of their own, with their ports.
void add_built_in_nodes(GrammarBuilder& builder) {
    using enum ValueType;
    constexpr ValueType any = text;
    for (const OpInfo& info : op_table()) {
        const bool is_node = info.group == OpGroup::control || info.group == OpGroup::decorator ||
                             info.group == OpGroup::action || info.group == OpGroup::condition;
        if (!is_node || info.element.empty()) { continue; }
        using Open = ElementRule::Open;
        builder.node(info.element, info.element, info.most_children == 0 ? "no_group" : "node",
                     info.least_children, info.most_children,
                     info.op == Op::run_machine ? Open::parameters : Open::closed, info.doc);
#define PORT(of, name, type, must_give, initial, doc)                                              \
    if (info.op == Op::of) {                                                                       \
        const Presence presence = (must_give) ? Presence::required : Presence::optional;           \
        builder.port(attribute_rule(name, type, presence, initial, doc));                          \
    }
#include "core/builtin_ports.def"
    }
}

ValueType value_type(const Port& port) {
    if (port.direction != PortDirection::input) { return ValueType::key; }
    switch (port.type) {
    case PortType::any:
    case PortType::text: return ValueType::text;
    case PortType::boolean: return ValueType::boolean;
    case PortType::int32: return ValueType::int32;
    case PortType::int64: return ValueType::int64;
    case PortType::real: return ValueType::number;
    }
    return ValueType::text;
}

/// As a document would write it; empty if there is no value.
std::string spelled(const Value& value) {
    if (value.is(Value::Kind::undefined)) { return {}; }
    return value.is(Value::Kind::text) ? value.as_text() : print(value);
}

void add_leaves(GrammarBuilder& builder, const Registry& registry) {
    for (const LeafType& leaf : registry.leaves()) {
        const bool is_leaf = leaf.most_children == 0;
        builder.node(leaf.name, leaf.name, is_leaf ? "no_group" : "node", is_leaf ? 0 : 1,
                     leaf.most_children, ElementRule::Open::closed, leaf.doc);
        for (const Port& port : leaf.ports) {
            const Presence presence = port.required ? Presence::required : Presence::optional;
            AttributeRule rule = attribute_rule(port.name, value_type(port), presence,
                                                spelled(port.initial), port.doc);
            rule.unit = port.unit;
            builder.port(std::move(rule));
        }
    }
}

}  // namespace

const AttributeRule* ElementRule::find(std::string_view attribute) const {
    for (const AttributeRule& rule : attributes) {
        if (rule.name == attribute) { return &rule; }
    }
    return nullptr;
}

RuleId Grammar::find(GroupId group, std::string_view element) const {
    if (!group) { return {}; }
    const std::vector<RuleId>& sorted = at(group).by_name;
    const auto found = std::lower_bound(
        sorted.begin(), sorted.end(), element,
        [this](RuleId rule, std::string_view name) { return at(rule).name < name; });
    return found != sorted.end() && at(*found).name == element ? *found : RuleId{};
}

RuleId Grammar::find(std::string_view element) const {
    for (std::uint32_t r = 0; r < rules.size(); ++r) {
        if (rules[r].name == element) { return {r}; }
    }
    return {};
}

Grammar tree_grammar(const Registry& registry) {
    using enum ValueType;
    using enum Presence;
    using enum ElementRule::Open;
    constexpr auto many = ElementRule::many;
    std::vector<std::string> enumerators;
    for (const auto& enumerator : registry.enumerators()) {
        enumerators.push_back(enumerator.first);
    }
    GrammarBuilder builder(FileKind::tree, enumerators);
#define GROUP(id, rules) builder.group(#id, rules);
#define ELEMENT(id, spelling, group, least, most, text, open, doc)                                 \
    builder.element(#id, spelling, #group, least, most, text, open, doc);
#define NODE(id, spelling, group, least, most, open, doc)                                          \
    builder.node(#id, spelling, #group, least, most, open, doc);
#define ATTRIBUTE(name, type, presence, initial, doc)                                              \
    builder.attribute(attribute_rule(name, type, presence, initial, doc));
#define NODE_ATTRIBUTE(name, type, initial, doc)                                                   \
    builder.node_attribute(attribute_rule(name, type, optional, initial, doc));
#define LATER(element) builder.later(element);
#include "load/grammar_tree.def"
    add_built_in_nodes(builder);
    add_leaves(builder, registry);
    return builder.finish("root");
}

Grammar machine_grammar() {
    using enum ValueType;
    using enum Presence;
    using enum ElementRule::Open;
    constexpr auto many = ElementRule::many;
    GrammarBuilder builder(FileKind::machine, {});
#define GROUP(id, rules) builder.group(#id, rules);
#define ELEMENT(id, spelling, group, least, most, text, open, doc)                                 \
    builder.element(#id, spelling, #group, least, most, text, open, doc);
#define ATTRIBUTE(name, type, presence, initial, doc)                                              \
    builder.attribute(attribute_rule(name, type, presence, initial, doc));
#define PARTS(least, most, parts_) builder.parts(least, most, parts_);
#include "load/grammar_machine.def"
    return builder.finish("scxml");
}

}  // namespace trellis
