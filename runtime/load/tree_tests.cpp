// Putting other nodes in the place of those that a substitution rule names, as mocks for tests
// (TREES §2.5): part of tree_compiler.h. Covered by tests/load/substitutions_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/substitutions.h"
#include "load/tree_compiler.h"

#include <string>
#include <utility>

namespace trellis {

// "escape/turn", "escape/MoveForward::7": the subtrees around a node and its name, or its type and
// its number, counted from 1 in document order.
std::string TreeCompiler::path_of(const Place& place, std::string_view type) const {
    const std::string_view own = document(place).value(place.element, "name");
    const std::string& around = paths_[place.scope.index];
    if (!own.empty() && own != type) { return around + std::string(own); }
    ScopeId outermost = place.scope;
    while (scopes_.parent(outermost)) {
        outermost = scopes_.parent(outermost);
    }
    const std::size_t number = builder_.program.rows.size() - scopes_.row(outermost).index;
    return around + std::string(type) + "::" + std::to_string(number);
}

SubstitutionRule* TreeCompiler::rule_for(const Place& place) {
    const std::string_view type = kind(place);
    const std::string_view own = instance_name(place);
    const std::string path =
        path_of(place, type == "SubTree" ? document(place).value(place.element, "ID") : type);
    for (SubstitutionRule& rule : builder_.substitutions->rules) {
        if (rule.pattern == own || rule.pattern == type || matches(rule.pattern, path)) {
            rule.used = true;
            return &rule;
        }
    }
    return nullptr;
}

// A test or a leaf stands without the children of the node it replaces.
void TreeCompiler::replace(const Place& place, const SubstitutionRule& rule) {
    if (rule.test != SubstitutionRule::no_test) {
        test(place, builder_.substitutions->tests[rule.test]);
    } else if (is_replaceable(place, rule)) {
        if (const auto op = built_ins_.find(rule.node); op != built_ins_.end()) {
            built_in(place, op_table()[op->second]);
        } else {
            leaf(place, *leaves_.find(rule.node)->second);
        }
    }
}

// The attributes and children that were written for one node must do for the other.
bool TreeCompiler::is_replaceable(const Place& place, const SubstitutionRule& rule) {
    const Grammar& grammar = builder_.grammar();
    const ElementRule& node = grammar.at(grammar.find(grammar.nodes, rule.node));
    const std::size_t children = document(place).child_count(place.element);
    std::string why;
    for (const AttributeRule& port : node.attributes) {
        const bool given = document(place).find(place.element, port.name) != nullptr;
        if (port.required && !given) { why = "it needs the attribute \"" + port.name + '"'; }
    }
    const bool too_many = node.most != ElementRule::many && children > node.most;
    if (node.most != 0 && (children < node.least || too_many)) {
        why = "it cannot have " + std::to_string(children) + " children";
    }
    if (why.empty()) { return true; }
    builder_.diagnostics().error("substitution", rule.where,
                                 rule.node + " cannot stand in the place of \"" +
                                     std::string(instance_name(place)) + "\": " + why);
    return false;
}

void TreeCompiler::test(const Place& place, const TestConfig& config) {
    // for messages, the scripts are texts of a JSON file
    ReadFile rules;
    rules.document.spelling = Document::Spelling::json;
    const auto code = [&](const RuleScript& script) {
        return script.text.empty()
                   ? CodeId()
                   : compiled(place, {&rules, script.text, script.where}, next_row());
    };
    TestInfo test{.status = config.status,
                  .status_script = code(config.status_script),
                  .on_success = code(config.success_script),
                  .on_failure = code(config.failure_script),
                  .post = code(config.post_script),
                  .delay = config.delay,
                  .word = {builder_.program.words++}};
    builder_.program.tests.push_back(test);
    const auto arg = static_cast<std::uint32_t>(builder_.program.tests.size() - 1);
    const RowId n = builder_.open(Op::test, place.parent, instance_name(place),
                                  document(place).at(place.element).where, arg);
    if (!n) { return; }
    conditions(place, n);
    builder_.close(n);
}

}  // namespace trellis
