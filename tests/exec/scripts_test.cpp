// The 963 scripts of which BehaviorTree.CPP 4.10's results are recorded: every one must give
// exactly that result and leave exactly that blackboard.
// SPDX-License-Identifier: MIT
#include "support/script_outcome.h"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

namespace trellis::test {

TEST_CASE("scripts: every recorded script gives what BehaviorTree.CPP gave") {
    std::ifstream file(TRELLIS_SHARED_DIR "/conformance/scripts/scripts.tsv");
    if (!file) {
        MESSAGE("no recorded scripts in " TRELLIS_SHARED_DIR);
        return;
    }
    int count = 0;
    for (std::string line; std::getline(file, line); ++count) {
        const std::size_t first = line.find('\t');
        const std::size_t second = line.find('\t', first + 1);
        REQUIRE(second != std::string::npos);
        const std::string script = line.substr(0, first);
        CAPTURE(script);
        const ScriptOutcome outcome = outcome_of(script);
        CHECK(outcome.result == line.substr(first + 1, second - first - 1));
        CHECK(outcome.blackboard == line.substr(second + 1));
    }
    MESSAGE(count, " recorded scripts");
    CHECK(count == 963);
}

}  // namespace trellis::test
