// The grammar: the forms of values, and how tables, built-in nodes and leaves become rules. That
// the schemas agree with it is tested in faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/grammar.h"

#include "support/example_registry.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <set>

using namespace trellis;

namespace {

AttributeRule of_type(ValueType type, bool may_be_pointer = false) {
    AttributeRule rule;
    rule.type = type;
    rule.may_be_pointer = may_be_pointer;
    return rule;
}

void check_values(const AttributeRule& rule, std::initializer_list<const char*> good,
                  std::initializer_list<const char*> bad) {
    for (const char* value : good) {
        INFO(value);
        CHECK(accepts(rule, value));
    }
    for (const char* value : bad) {
        INFO(value);
        CHECK_FALSE(accepts(rule, value));
    }
}

}  // namespace

TEST_CASE("attribute_rule: numbers are whole decimal numbers") {
    check_values(of_type(ValueType::number), {"1", "-0.5", ".5", "5.", "1e-3", "+2", "1E+9"},
                 {"", "2abc", "inf", "nan", "0x10", " 1", "1 ", ".", "e5", "1e", "{v}"});
    check_values(of_type(ValueType::int32), {"0", "-7", "12"}, {"", "-", "+1", "1.5", "1e3", "x"});
    AttributeRule named = of_type(ValueType::int32);
    named.choices = {"RED"};
    check_values(named, {"RED", "3"}, {"red", "BLUE"});
}

TEST_CASE("attribute_rule: booleans have eight spellings") {
    check_values(of_type(ValueType::boolean),
                 {"0", "1", "true", "false", "True", "False", "TRUE", "FALSE"},
                 {"", "yes", "tRUE", "2"});
}

TEST_CASE("attribute_rule: a pointer is one name in braces") {
    check_values(of_type(ValueType::key), {"{a}", "{=}", " {a b} ", "{@x}"},
                 {"", "a", "{}", "{a", "a}", "{{a}}", "{a}{b}", "x{a}"});
    check_values(of_type(ValueType::number, true), {"1", "{speed}"}, {"speed", "{}"});
}

TEST_CASE("attribute_rule: names have no blanks, lists of names have at least one") {
    check_values(of_type(ValueType::name), {"a", "a.b", "ação"}, {"", "a b", "a\n"});
    check_values(of_type(ValueType::names), {"a", "a b", " a.* b "}, {"", " ", "\n\t"});
}

TEST_CASE("attribute_rule: integers have a range") {
    CHECK(in_range(of_type(ValueType::int32), "2147483647"));
    CHECK_FALSE(in_range(of_type(ValueType::int32), "2147483648"));
    CHECK(in_range(of_type(ValueType::int64), "2147483648"));
    CHECK_FALSE(in_range(of_type(ValueType::int64), "-9223372036854775809"));
    CHECK(in_range(of_type(ValueType::number), "1e300"));
}

TEST_CASE("attribute_rule: expectations name the unit and the pointer") {
    AttributeRule speed = of_type(ValueType::number, true);
    speed.unit = "m/s";
    CHECK(expectation(speed) == "a number in m/s or a {key}");
    AttributeRule type = of_type(ValueType::choice);
    type.choices = {"internal", "external"};
    CHECK(expectation(type) == "internal or external");
}

TEST_CASE("grammar: trees have the built-in nodes with their ports and the registered leaves") {
    Registry registry;
    test::register_examples(registry);
    const Grammar grammar = tree_grammar(registry);
    CHECK(grammar.at(grammar.root).name == "root");

    const RuleId repeat = grammar.find(grammar.nodes, "Repeat");
    REQUIRE(repeat);
    const AttributeRule* cycles = grammar.at(repeat).find("num_cycles");
    REQUIRE(cycles != nullptr);
    CHECK(cycles->required);
    CHECK(cycles->may_be_pointer);
    CHECK(cycles->choices == std::vector<std::string>{"FRONT", "BACK"});
    CHECK(grammar.at(repeat).least == 1);
    CHECK(grammar.at(repeat).most == 1);

    const RuleId forward = grammar.find(grammar.nodes, "MoveForward");
    REQUIRE(forward);
    const AttributeRule* speed = grammar.at(forward).find("speed");
    REQUIRE(speed != nullptr);
    CHECK(speed->unit == "m/s");
    CHECK(speed->initial == "0.5");
    CHECK(speed->doc == "forwards");
    CHECK(grammar.at(forward).find("_skipIf") != nullptr);
    CHECK_FALSE(grammar.at(forward).group);

    const RuleId measure = grammar.find(grammar.nodes, "Measure");
    REQUIRE(measure);
    CHECK(grammar.at(measure).find("distance")->type == ValueType::key);
    CHECK(grammar.find(grammar.nodes, "SubTree"));
    CHECK_FALSE(grammar.find(grammar.nodes, "BehaviorTree"));
}

TEST_CASE("grammar: one name may have different rules at different places") {
    const Grammar grammar = machine_grammar();
    const ElementRule& state = grammar.at(grammar.find("state"));
    const ElementRule& initial = grammar.at(grammar.find("initial"));
    CHECK_FALSE(grammar.at(grammar.find(state.group, "transition")).find("target")->required);
    CHECK(grammar.at(grammar.find(initial.group, "transition")).find("target")->required);
}

TEST_CASE(
    "grammar: ids are unique, attributes of one element differ, every element can be reached") {
    Registry registry;
    test::register_examples(registry);
    for (const Grammar& grammar : {tree_grammar(registry), machine_grammar()}) {
        std::set<std::string> ids;
        std::set<std::uint32_t> reached = {grammar.root.index};
        for (const ElementRule& rule : grammar.rules) {
            INFO(rule.id);
            CHECK(ids.insert(rule.id).second);
            CHECK_FALSE(rule.doc.empty());
            CHECK((rule.group || (rule.least == 0 && rule.most == 0)));
            std::set<std::string> names;
            for (const AttributeRule& attribute : rule.attributes) {
                INFO(attribute.name);
                CHECK(names.insert(attribute.name).second);
            }
        }
        for (const Group& group : grammar.groups) {
            for (const RuleId rule : group.rules) {
                reached.insert(rule.index);
            }
        }
        CHECK(reached.size() == grammar.rules.size());
    }
}
