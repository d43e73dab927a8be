// Substitution rules: which nodes they replace, what stands there then and does, and every message.
// SPDX-License-Identifier: MIT
#include "load/substitutions.h"

#include "load/load.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

namespace trellis::test {
namespace {

constexpr std::string_view file = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
<BehaviorTree ID="Main"><Sequence>
  <Leaf id="a" script="F" name="first"/>
  <SubTree ID="Sub" name="inner"/>
  <Leaf id="d" script="F"/>
</Sequence></BehaviorTree>
<BehaviorTree ID="Sub"><Fallback>
  <Leaf id="b" script="F" name="second"/>
  <Leaf id="c" script="S"/>
</Fallback></BehaviorTree></root>)";

struct Loaded {
    Diagnostics diagnostics;
    std::optional<Program> program;
};

Loaded with_rules(const std::string& rules, std::string_view tree = file) {
    Loaded out;
    const Source source{"rules.json", rules};
    const Source text{"tree.xml", std::string(tree)};
    LoadOptions options;
    options.substitutions = &source;
    out.program = load(text, script_registry(), out.diagnostics, options);
    return out;
}

/// The ops of the nodes and the leaves that are left, for example "sequence test Leaf".
std::string nodes(const Loaded& loaded) {
    if (!loaded.program) { return loaded.diagnostics.render(); }
    std::string out;
    for (const Row& row : loaded.program->rows) {
        if (row.op == Op::tree) { continue; }
        out += out.empty() ? "" : " ";
        out += row.op == Op::action ? loaded.program->calls[row.arg].type->name
                                    : std::string(op_table()[row.op].name);
    }
    return out;
}

std::string rules(const std::string& list, const std::string& tests = "") {
    return "{\"TestNodeConfigs\": {" + tests + "}, \"SubstitutionRules\": {" + list + "}}";
}

/// The findings without the quoted lines.
std::string messages(const Loaded& loaded) {
    std::string out;
    for (const Diagnostic& d : loaded.diagnostics.all()) {
        out += d.id + ": " + d.message + '\n';
    }
    return out;
}

}  // namespace

TEST_CASE("substitutions: a rule names a node, a type or a path") {
    CHECK(nodes(with_rules(rules(R"("first": "AlwaysSuccess")"))) ==
          "sequence always_success subtree fallback Leaf Leaf Leaf");
    CHECK(nodes(with_rules(rules(R"("Leaf": "AlwaysSuccess")"))) ==
          "sequence always_success subtree fallback always_success always_success always_success");
    CHECK(nodes(with_rules(rules(R"("inner/second": "AlwaysSuccess")"))) ==
          "sequence Leaf subtree fallback always_success Leaf Leaf");
    CHECK(nodes(with_rules(rules(R"("inner/*": "AlwaysSuccess")"))) ==
          "sequence Leaf subtree always_success Leaf");
    CHECK(nodes(with_rules(rules(R"("inner/Leaf::6": "AlwaysSuccess")"))) ==
          "sequence Leaf subtree fallback Leaf always_success Leaf");
    CHECK(nodes(with_rules(rules(R"("SubTree": "AlwaysSuccess")"))) ==
          "sequence Leaf always_success Leaf");
}

TEST_CASE("substitutions: of several rules the first that matches counts") {
    CHECK(nodes(with_rules(rules(R"("first": "AlwaysFailure", "Leaf": "AlwaysSuccess")"))) ==
          "sequence always_failure subtree fallback always_success always_success always_success");
}

TEST_CASE("substitutions: patterns match with * and ?") {
    CHECK(matches("a*c", "abbc"));
    CHECK(matches("*", ""));
    CHECK(matches("a?c*", "abc"));
    CHECK(matches("*/b*/c", "a/b/c/b2/c"));
    CHECK_FALSE(matches("a?c", "ac"));
    CHECK_FALSE(matches("a*c", "abcd"));
}

TEST_CASE("substitutions: a test answers after its delay, and runs its scripts") {
    const Loaded loaded =
        with_rules(rules(R"("first": "slow", "Leaf::7": "asks")",
                         R"("slow": {"async_delay": 2000, "success_script": "n := 1",
                          "post_script": "n = n + 1"},
                 "asks": {"return_status_script": "n == 2 ? 'FAILURE' : 'SUCCESS'",
                          "success_script": "n = 8", "failure_script": "n = 9"})"));
    REQUIRE_MESSAGE(loaded.program, loaded.diagnostics.render());
    ScriptRun run(*loaded.program);
    CHECK(run.step() == Status::running);
    CHECK(run.step() == Status::running);
    CHECK(run.step() == Status::failure);
    CHECK(run.take_events() == "b:FAILURE c:SUCCESS");
    CHECK(run.state.slots.at(0) == Value::integer(9));
}

TEST_CASE("substitutions: a type that a rule names need not be known, in either form") {
    const std::string tree = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
        <BehaviorTree ID="Main"><RecoveryNode retries="6">
          <Control ID="RoundRobin" wrap="true"><Leaf id="a" script="F"/></Control>
          <Spin distance="1.57" _skipIf="false"/>
        </RecoveryNode></BehaviorTree>
        <BehaviorTree ID="Unused"><Spin/></BehaviorTree></root>)";
    const std::string all = R"("RecoveryNode": "Fallback", "RoundRobin": "Sequence", )";
    CHECK(nodes(with_rules(rules(all + R"("Spin": "still")", R"("still": {})"), tree)) ==
          "fallback sequence Leaf test");
    const Loaded one_less = with_rules(rules(all + R"("Fallback": "Sequence")"), tree);
    CHECK(messages(one_less) == "unknown-node: unknown node \"Spin\"\n"
                                "unknown-node: unknown node \"Spin\"\n"
                                "substitution: no node is replaced by the rule for "
                                "\"Fallback\"\n");
}

TEST_CASE("substitutions: trees that do not run are replaced in too") {
    const std::string unused = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
        <BehaviorTree ID="Main"><Leaf id="a" script="S"/></BehaviorTree>
        <BehaviorTree ID="Unused"><Leaf id="b" script="S" name="other"/></BehaviorTree></root>)";
    CHECK(messages(with_rules(rules(R"("other": "AlwaysSuccess")"), unused)) == "");
}

TEST_CASE("substitutions: with a fault in the rules nothing is said about the tree") {
    const std::string tree = R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
        <Spin/></BehaviorTree></root>)";
    CHECK(messages(with_rules(rules(R"("Spin": "AlwaysSucces")"), tree)) ==
          "unknown-node: there is neither a test nor a node \"AlwaysSucces\"; did you mean "
          "\"AlwaysSuccess\"?\n");
}

TEST_CASE("substitutions: messages") {
    CHECK(messages(with_rules(rules(R"("first": "AlwaysSucess")"))) ==
          "unknown-node: there is neither a test nor a node \"AlwaysSucess\"; did you mean "
          "\"AlwaysSuccess\"?\n");
    CHECK(messages(with_rules(rules(R"("frist": "AlwaysSuccess")"))) ==
          "substitution: no node is replaced by the rule for \"frist\"\n");
    CHECK(messages(with_rules(rules(R"("first": "Repeat")"))) ==
          "substitution: Repeat cannot stand in the place of \"first\": it cannot have 0 "
          "children\n");
    CHECK(messages(with_rules(rules(R"("first": "Sleep")"))) ==
          "substitution: Sleep cannot stand in the place of \"first\": it needs the attribute "
          "\"msec\"\n");
    CHECK(messages(with_rules(rules("", R"("t": {"return_status": "DONE"})"))) ==
          "bad-value: \"return_status\": expected SUCCESS, FAILURE, RUNNING or SKIPPED, found "
          "\"DONE\"\n");
    CHECK(messages(with_rules(rules("", R"("t": {"async_delay": 1.5})"))) ==
          "bad-value: \"async_delay\": expected whole milliseconds, found \"1.5\"\n");
    CHECK(messages(with_rules(rules("", R"("t": {"post": "n"})"))) ==
          "json-member: unknown member \"post\"\n");
    CHECK(messages(with_rules(R"({"SubstitutionRules": {"first": 1}})")) ==
          "json-type: expected the name of a test or node for \"first\"\n");
    CHECK(messages(with_rules(rules(R"("first": "t")", R"("t": {"post_script": "n := "})")))
              .starts_with("script-syntax: "));
}

}  // namespace trellis::test
