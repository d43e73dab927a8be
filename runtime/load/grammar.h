// What a kind of file may consist of, as one table: elements, attributes, types of values, numbers
// of children. The registered leaves extend it. check.h checks documents against it; schema_xsd.h
// and schema_json.h write it down for editors and other validators. It says nothing that needs to
// know the whole document: that is the compiler's. Covered by tests/load/grammar_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/leaf.h"
#include "load/attribute_rule.h"
#include "load/document.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

using RuleId = Id<struct RuleTag>;    ///< Grammar::rules
using GroupId = Id<struct GroupTag>;  ///< Grammar::groups

/// How many of some attributes and children an element may have: beyond what a schema can say.
struct PartsRule {
    std::uint32_t least = 0, most = 0;
    std::vector<std::string> parts;  ///< "attribute", "<child>", "#text"
};

/// One element at one kind of place. Several rules may have the same name: <transition> inside
/// <state> and inside <initial> differ.
struct ElementRule {
    static constexpr std::uint32_t many = 0xFFFFFFFF;

    /// Attributes and elements beyond those listed.
    enum class Open : std::uint8_t {
        closed,      ///< none
        parameters,  ///< any attributes
        named,       ///< the attributes of the node that the attribute ID names
        content,     ///< any elements inside, which are not looked at
    };

    std::string id;    ///< unique in the grammar: "initial_transition"
    std::string name;  ///< as written: "transition"
    std::string doc;
    Open open = Open::closed;
    bool text = false;  ///< character data may stand in it
    bool node = false;  ///< of a tree: its last Grammar::node_attributes attributes all nodes have
    GroupId group;      ///< what may stand in it; none: nothing
    std::uint32_t least = 0, most = 0;  ///< children, in all
    std::vector<AttributeRule> attributes;
    std::vector<PartsRule> parts;

    /// The attribute of that name, or null.
    const AttributeRule* find(std::string_view attribute) const;
};

/// Elements that may stand at one place, in any order.
struct Group {
    std::string id;
    std::vector<RuleId> rules;    ///< in the order of the manual
    std::vector<RuleId> by_name;  ///< the same, sorted by ElementRule::name
};

struct Grammar {
    FileKind kind = FileKind::tree;
    RuleId root;
    GroupId nodes;                      ///< trees: every node; none in machines
    std::uint32_t node_attributes = 0;  ///< how many attributes all nodes have
    std::vector<ElementRule> rules;
    std::vector<Group> groups;
    std::vector<std::string> later;     ///< elements that this version does not run
    std::vector<std::string> replaced;  ///< nodes that another always replaces: not looked at

    const ElementRule& at(RuleId rule) const { return rules[rule.index]; }
    const Group& at(GroupId group) const { return groups[group.index]; }
    /// The rule for an element called `element` in a group; none if it may not stand there.
    RuleId find(GroupId group, std::string_view element) const;
    /// The first rule for an element of that name anywhere; none if there is no such element.
    RuleId find(std::string_view element) const;
};

/// The namespace of SCXML.
inline constexpr std::string_view scxml_namespace = "http://www.w3.org/2005/07/scxml";

/// Trees: the BehaviorTree.CPP v4 dialect with the built-in nodes of core/ops.def and the leaves of
/// `registry`, of which nothing is kept.
Grammar tree_grammar(const Registry& registry);

/// Machines: SCXML 1.0. They name leaves in values, which only the compiler can check.
Grammar machine_grammar();

}  // namespace trellis
