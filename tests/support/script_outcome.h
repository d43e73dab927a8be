// One script of a tree on the blackboard of the recorded scripts (TREES, "The test driver"), and
// what came of it in their spelling. Covered by tests/exec/scripts_test.cpp; the program is
// tests/conformance/script_driver.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace trellis::test {

struct ScriptOutcome {
    std::string result;      ///< i3, d1.5, 'text', <empty>, PARSE_ERROR or RUN_ERROR
    std::string blackboard;  ///< "b=d1 i=i3 …" after it, sorted by name
};

/// Runs the script on i=3 j=-2 d=1.5 s='abc' n='7' b=true, with RED, GREEN and BLUE.
ScriptOutcome outcome_of(const std::string& script);

}  // namespace trellis::test
