// The rules of LoadOptions::substitutions, read: which nodes of a tree are replaced, and by what.
// tree_compiler.h applies them. Private to runtime/load. Covered by
// tests/load/substitutions_test.cpp.
//
//     { "TestNodeConfigs":  { "quick": { "return_status": "SUCCESS", "post_script": "n := 1" } },
//       "SubstitutionRules": { "MoveForward": "quick", "escape/*": "AlwaysFailure" } }
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/status.h"
#include "load/builder.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// A script of the rules, with its place for messages; empty text: none.
struct RuleScript {
    std::string text;
    Where where;
};

/// What replaces a node without being one: TestNodeConfig of BehaviorTree.CPP.
struct TestConfig {
    std::string name;
    Status status = Status::success;
    RuleScript status_script, success_script, failure_script, post_script;
    std::int64_t delay = 0;  ///< ms before it answers
};

struct SubstitutionRule {
    static constexpr std::uint32_t no_test = 0xFFFFFFFF;

    std::string pattern;           ///< a name, a type, or a path with * and ?
    std::string node;              ///< what is put there, if it is no test
    std::uint32_t test = no_test;  ///< row of Substitutions::tests
    Where where;
    bool used = false;
};

struct Substitutions {
    std::vector<TestConfig> tests;
    std::vector<SubstitutionRule> rules;  ///< in written order: the first that matches counts
};

/// The rules that a text spells. Errors: those of JSON; "json-type", "json-member", "bad-value",
/// "unknown-node" for a rule that puts something there that is neither a test nor a node.
Substitutions read_substitutions(const Source& source, const Grammar& grammar,
                                 Diagnostics& diagnostics, const LoadOptions& options);

/// Whether the pattern is the text; * stands for any characters, ? for one.
bool matches(std::string_view pattern, std::string_view text);

}  // namespace trellis
