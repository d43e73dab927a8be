// One walk over the document: each element is checked by the rule that its place gives it, then its
// children. Faults are reported and the walk goes on. Covered by tests/load/check_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/check.h"

#include "core/number.h"
#include "load/check_wording.h"
#include "load/namespaces.h"
#include "load/text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

namespace {

class Checker {
public:
    Checker(const Document& document, const Grammar& grammar, Diagnostics& diagnostics)
        : document_(document), grammar_(grammar), diagnostics_(diagnostics),
          namespaces_(document, grammar.kind == FileKind::machine ? scxml_namespace : "") {}

    void run() {
        const ElementId root = document_.root();
        const ElementRule& rule = grammar_.at(grammar_.root);
        const Namespaces::Mark mark = namespaces_.enter(root);
        const std::string_view name = namespaces_.local(document_.name(root));
        if (name != rule.name) {
            structural("wrong-root", document_.at(root).where,
                       "expected <" + rule.name + "> as the outermost element, found <" +
                           std::string(document_.name(root)) + ">");
            return;
        }
        if (namespaces_.space_of_element(document_.name(root)) != Namespaces::Space::own) {
            structural("wrong-namespace", document_.at(root).where,
                       "expected xmlns=\"" + std::string(namespaces_.own()) + "\"");
            namespaces_.adopt_default();
        }
        check_format();
        check_element(root, rule);
        namespaces_.leave(mark);
    }

private:
    void structural(std::string_view id, Where where, std::string message) {
        diagnostics_.structural_error(std::string(id), where, std::move(message));
    }
    void error(std::string_view id, Where where, std::string message) {
        diagnostics_.error(std::string(id), where, std::move(message));
    }
    /// An error that a schema finds as well if `structural_fault`.
    void fault(bool structural_fault, std::string_view id, Where where, std::string message) {
        if (structural_fault) {
            structural(id, where, std::move(message));
        } else {
            error(id, where, std::move(message));
        }
    }

    bool in_json() const { return document_.spelling == Document::Spelling::json; }
    std::string_view attribute_word() const { return in_json() ? "member" : "attribute"; }
    /// An element's name as messages show it: nodes bare, elements of SCXML as tags.
    std::string shown(std::string_view name) const {
        const bool tag = grammar_.kind == FileKind::machine && !in_json();
        return tag ? "<" + std::string(name) + ">" : std::string(name);
    }

    /// Whether a file of trees says which format it has.
    void check_format() {
        if (grammar_.kind != FileKind::tree) { return; }
        const ElementId root = document_.root();
        const Attribute* format = document_.find(root, "BTCPP_format");
        if (format == nullptr) {
            diagnostics_.warning("format-version", document_.at(root).where,
                                 "BTCPP_format is missing; the file is read as format 4");
        } else if (document_.string(format->value) != "4") {
            diagnostics_.warning("format-version", format->value_where,
                                 "the file is read as format 4");
        }
    }

    void check_element(ElementId e, const ElementRule& rule) {
        const ElementRule* named = rule.open == ElementRule::Open::named ? named_node(e) : nullptr;
        check_attributes(e, rule, named);
        check_parts(e, rule);
        if (!rule.text && !document_.text(e).empty()) {
            structural("unexpected-text", document_.at(e).text_where,
                       shown(rule.name) + " takes no text, found " +
                           quoted_short(document_.text(e)));
        }
        if (rule.open == ElementRule::Open::content) { return; }
        check_children(e, rule, named);
        if (rule.id == "if") { check_branches(e); }
    }

    // Attributes --------------------------------------------------------------------------------

    /// The rule of the node that <Action ID="…"> and its like name; null if there is none.
    const ElementRule* named_node(ElementId e) {
        const Attribute* id = document_.find(e, "ID");
        if (id == nullptr) { return nullptr; }
        const std::string_view name = document_.string(id->value);
        const RuleId found = grammar_.find(grammar_.nodes, name);
        if (found && grammar_.at(found).open == ElementRule::Open::closed) {
            return &grammar_.at(found);
        }
        if (is_replaced(name)) { return nullptr; }
        std::vector<std::string_view> candidates;
        for (const RuleId node : grammar_.at(grammar_.nodes).rules) {
            if (grammar_.at(node).open == ElementRule::Open::closed) {
                candidates.push_back(grammar_.at(node).name);
            }
        }
        error("unknown-node", id->value_where,
              "unknown node " + quoted(name) + suggestion(name, candidates));
        return nullptr;
    }

    /// `named`: the node that the element names, null unless it names one.
    void check_attributes(ElementId e, const ElementRule& rule, const ElementRule* named) {
        for (const Attribute& attribute : document_.attributes_of(e)) {
            const std::string_view name = document_.string(attribute.name);
            if (namespaces_.is_passed_over(name)) { continue; }
            if (const AttributeRule* known = rule.find(name)) {
                check_value(attribute, *known, true);
            } else if (const AttributeRule* port = named ? named->find(name) : nullptr) {
                check_value(attribute, *port, false);
            } else if (!takes_any(rule, named)) {
                report_unknown(attribute, rule, named);
            } else if (is_null(attribute)) {
                report_value(attribute, AttributeRule(), true);
            }
        }
        check_required(e, rule, true);
        if (named != nullptr) { check_required(e, *named, false); }
    }

    /// Whether further attributes are accepted: parameters, or ports of a node that is not known.
    static bool takes_any(const ElementRule& rule, const ElementRule* named) {
        return rule.open == ElementRule::Open::parameters ||
               (rule.open == ElementRule::Open::named && named == nullptr);
    }

    void report_unknown(const Attribute& attribute, const ElementRule& rule,
                        const ElementRule* named) {
        const std::string_view name = document_.string(attribute.name);
        const ElementRule& owner = named != nullptr ? *named : rule;
        std::vector<std::string_view> candidates;
        for (const AttributeRule& known : owner.attributes) {
            candidates.push_back(known.name);
        }
        const std::string meant = suggestion(name, candidates);
        if (grammar_.kind == FileKind::tree && name.starts_with('_') && !is_null(attribute)) {
            diagnostics_.warning("ignored-attribute", attribute.where,
                                 quoted(name) + " is ignored" + meant);
            return;
        }
        fault(named == nullptr, "unknown-attribute", attribute.where,
              shown(owner.name) + " has no " + std::string(attribute_word()) + " " + quoted(name) +
                  (meant.empty() ? own_attributes(owner) : meant));
    }

    /// "; it has path and ros_pkg": the attributes of an element, if they are few; of a node those
    /// that not all nodes have.
    std::string own_attributes(const ElementRule& rule) const {
        constexpr std::size_t most = 6;
        const std::size_t common = rule.node ? grammar_.node_attributes : 0;
        std::vector<std::string> names;
        for (std::size_t i = 0; i + common < rule.attributes.size(); ++i) {
            names.push_back(rule.attributes[i].name);
        }
        if (names.empty() || names.size() > most) { return {}; }
        return "; it has " + listed(names, " and ");
    }

    /// Whether the type tells more than the attribute's name.
    static bool says_more(ValueType type) {
        return type == ValueType::int32 || type == ValueType::int64 || type == ValueType::count ||
               type == ValueType::number || type == ValueType::boolean || type == ValueType::key ||
               type == ValueType::choice;
    }

    void check_required(ElementId e, const ElementRule& rule, bool structural_fault) {
        for (const AttributeRule& attribute : rule.attributes) {
            if (!attribute.required || (attribute.constant_in_json && in_json())) { continue; }
            if (document_.find(e, attribute.name) != nullptr) { continue; }
            std::string message = shown(rule.name) + " needs the " + std::string(attribute_word()) +
                                  " \"" + attribute.name + "\"";
            if (says_more(attribute.type)) { message += ", " + expectation(attribute); }
            fault(structural_fault, "missing-attribute", document_.at(e).where, message);
        }
    }

    void check_value(const Attribute& attribute, const AttributeRule& rule, bool structural_fault) {
        const std::string_view value = document_.string(attribute.value);
        if (!accepts_spelling(rule, attribute)) {
            report_value(attribute, rule, structural_fault);
        } else if (!in_range(rule, value)) {
            error("out-of-range", attribute.value_where,
                  "\"" + rule.name + "\": " + std::string(value) + " does not fit " +
                      (rule.type == ValueType::int64 ? "64" : "32") + " bits");
        }
    }

    bool is_null(const Attribute& attribute) const {
        return attribute.bare && document_.string(attribute.value) == "null";
    }

    /// accepts(), and what only JSON can write: 3.0 is an integer there, null is nothing, and names
    /// of a closed list are strings.
    bool accepts_spelling(const AttributeRule& rule, const Attribute& attribute) const {
        const std::string_view value = document_.string(attribute.value);
        if (!attribute.bare) { return accepts(rule, value); }
        if (is_null(attribute) || rule.type == ValueType::choice) { return false; }
        const bool count = rule.type == ValueType::count;
        if (rule.type == ValueType::int32 || rule.type == ValueType::int64 || count) {
            const ParsedNumber number = parse_whole_number(value);
            return number.length != 0 && number.value == std::floor(number.value) &&
                   (!count || number.value >= 0.0);
        }
        return accepts(rule, value);
    }

    void report_value(const Attribute& attribute, const AttributeRule& rule,
                      bool structural_fault) {
        const std::string_view value = document_.string(attribute.value);
        const std::vector<std::string_view> choices(rule.choices.begin(), rule.choices.end());
        fault(structural_fault, "bad-value", attribute.value_where,
              quoted(document_.string(attribute.name)) + ": expected " + expectation(rule) +
                  ", found " + (attribute.bare ? std::string(value) : quoted_short(value)) +
                  suggestion(value, choices));
    }

    // Children ----------------------------------------------------------------------------------

    void check_children(ElementId e, const ElementRule& rule, const ElementRule* named) {
        std::vector<ElementId> counted;
        for (const ElementId child : document_.children(e)) {
            if (diagnostics_.is_full()) { return; }
            const Namespaces::Mark mark = namespaces_.enter(child);
            if (namespaces_.space_of_element(document_.name(child)) != Namespaces::Space::foreign) {
                counted.push_back(child);
                if (const RuleId found = rule_of_child(child, rule)) {
                    check_element(child, grammar_.at(found));
                } else if (rule.group && rule.group == grammar_.nodes) {
                    check_below_unknown(child);
                }
            }
            namespaces_.leave(mark);
        }
        if (!check_count(e, rule, rule, counted, true) || named == nullptr) { return; }
        check_count(e, rule, *named, counted, false);
    }

    /// What stands in a node of which nothing is known is nodes all the same.
    void check_below_unknown(ElementId e) {
        ElementRule unknown;
        unknown.name = document_.name(e);
        unknown.group = grammar_.nodes;
        unknown.most = ElementRule::many;
        check_children(e, unknown, nullptr);
    }

    /// Whether the number of children is right for `rule`; says so if it is not.
    bool check_count(ElementId e, const ElementRule& element, const ElementRule& rule,
                     const std::vector<ElementId>& children, bool structural_fault) {
        const std::size_t count = children.size();
        if (count >= rule.least && (rule.most == ElementRule::many || count <= rule.most)) {
            return true;
        }
        const ElementId place = count < rule.least ? e : children[rule.most];
        fault(structural_fault, "child-count", document_.at(place).where,
              shown(&element == &rule ? element.name : rule.name) + " takes " +
                  children_in_words(rule.least, rule.most) + ", found " + std::to_string(count));
        return false;
    }

    /// The rule that checks `child`; none, after saying why, if nothing is known about it.
    RuleId rule_of_child(ElementId child, const ElementRule& parent) {
        const std::string_view written = document_.name(child);
        const std::string_view name = namespaces_.local(written);
        const Where where = document_.at(child).where;
        if (namespaces_.space_of_element(written) == Namespaces::Space::none) {
            structural("wrong-namespace", where,
                       shown(written) + " is not in the namespace " +
                           std::string(namespaces_.own()));
            return {};
        }
        if (name.size() != written.size()) {
            error("prefixed-element", where,
                  "expected <" + std::string(name) + "> without a prefix, found <" +
                      std::string(written) + ">");
        }
        if (const RuleId found = grammar_.find(parent.group, name)) { return found; }
        if (is_later(name)) {
            structural("not-run", where, shown(name) + " is not run by this version");
            return {};
        }
        if (parent.group == grammar_.nodes && is_replaced(name)) { return {}; }
        const RuleId elsewhere = grammar_.find(name);
        if (!elsewhere) {
            report_unknown(name, where, parent);
        } else if (parent.group) {
            structural("misplaced-element", where,
                       shown(name) + " may not stand directly inside " + shown(parent.name) +
                           expected_inside(parent));
        }
        // if the parent takes no children at all, their number is the fault
        return elsewhere;
    }

    bool is_later(std::string_view name) const { return has(grammar_.later, name); }
    bool is_replaced(std::string_view name) const { return has(grammar_.replaced, name); }
    static bool has(const std::vector<std::string>& names, std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    }

    void report_unknown(std::string_view name, Where where, const ElementRule& parent) {
        std::vector<std::string_view> candidates;
        if (parent.group) {
            for (const RuleId rule : grammar_.at(parent.group).rules) {
                candidates.push_back(grammar_.at(rule).name);
            }
        }
        const bool node = parent.group && parent.group == grammar_.nodes;
        structural(node ? "unknown-node" : "unknown-element", where,
                   (node ? "unknown node " : "unknown element ") + quoted(name) +
                       suggestion(name, candidates));
    }

    /// "; expected onentry or onexit": what may stand in an element, if that is a short list.
    std::string expected_inside(const ElementRule& parent) const {
        constexpr std::size_t longest = 10;
        if (parent.group == grammar_.nodes) { return "; expected a node"; }
        std::vector<std::string> names;
        for (const RuleId rule : grammar_.at(parent.group).rules) {
            names.push_back(grammar_.at(rule).name);
        }
        return names.size() > longest ? std::string() : "; expected " + listed(names, " or ");
    }

    // Beyond the schemas ------------------------------------------------------------------------

    /// How often one part of a PartsRule occurs; `place` becomes that of its last occurrence.
    std::size_t occurrences(ElementId e, std::string_view part, Where& place) const {
        if (part == "#text") {
            const bool present = !document_.text(e).empty() || document_.child_count(e) > 0;
            return present ? 1 : 0;
        }
        if (!part.starts_with('<')) {
            const Attribute* attribute = document_.find(e, part);
            if (attribute != nullptr) { place = attribute->where; }
            return attribute != nullptr ? 1 : 0;
        }
        std::size_t count = 0;
        for (const ElementId child : document_.children(e)) {
            if (document_.name(child) != part.substr(1, part.size() - 2)) { continue; }
            place = document_.at(child).where;
            ++count;
        }
        return count;
    }

    void check_parts(ElementId e, const ElementRule& rule) {
        for (const PartsRule& parts : rule.parts) {
            Where place = document_.at(e).where;
            std::size_t count = 0;
            std::vector<std::string> names;
            for (const std::string& part : parts.parts) {
                count += occurrences(e, part, place);
                names.push_back(part == "#text" ? "text" : part);
            }
            if (count < parts.least && !has_later_child(e)) {
                error("missing-part", place, shown(rule.name) + " needs " + listed(names, " or "));
            }
            if (parts.most == ElementRule::many || count <= parts.most) { continue; }
            error("conflicting-parts", place,
                  shown(rule.name) +
                      (names.size() == 1
                           ? " takes one " + names[0] + ", found " + std::to_string(count)
                           : " takes only one of " + listed(names, " and ")));
        }
    }

    /// What is missing may be what this version does not run, which has been said.
    bool has_later_child(ElementId e) const {
        for (const ElementId child : document_.children(e)) {
            if (is_later(document_.name(child))) { return true; }
        }
        return false;
    }

    void check_branches(ElementId e) {
        bool ended = false;
        for (const ElementId child : document_.children(e)) {
            if (ended && document_.name(child) == "elseif") {
                error("branch-after-else", document_.at(child).where,
                      shown("elseif") + " may not stand after " + shown("else"));
            }
            ended = ended || document_.name(child) == "else";
        }
    }

    const Document& document_;
    const Grammar& grammar_;
    Diagnostics& diagnostics_;
    Namespaces namespaces_;
};

}  // namespace

void check(const Document& document, const Grammar& grammar, Diagnostics& diagnostics) {
    Checker(document, grammar, diagnostics).run();
}

}  // namespace trellis
