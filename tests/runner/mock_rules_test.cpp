// --mock: rules that put other nodes in the place of some, in every command that loads a
// behaviour.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const nav = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Navigate">
    <RecoveryNode number_of_retries="6" name="navigate">
      <FollowPath path="{path}"/>
      <Spin spin_dist="1.57"/>
    </RecoveryNode>
  </BehaviorTree>
</root>
)";

const char* const palette = R"(<root BTCPP_format="4">
  <TreeNodesModel>
    <Action ID="FollowPath"><input_port name="path"/></Action>
    <Action ID="Spin"><input_port name="spin_dist" type="double"/></Action>
  </TreeNodesModel>
</root>
)";

const char* const rules = R"({
  "TestNodeConfigs": {
    "drive": { "async_delay": 50, "return_status": "FAILURE" },
    "turn": { "async_delay": 100 }
  },
  "SubstitutionRules": {
    "RecoveryNode": "Fallback",
    "FollowPath": "drive",
    "Spin": "turn"
  }
}
)";

MemoryFiles nav_files() {
    MemoryFiles files;
    files.content = {{"nav.xml", nav}, {"palette.xml", palette}, {"rules.json", rules}};
    return files;
}

/// `trellis COMMAND nav.xml` with the palette, the rules and more words.
Ran ran(MemoryFiles& files, const std::string& command, const std::vector<std::string>& more = {},
        const std::string& in = {}) {
    std::vector<std::string> words{command,       "nav.xml", "--nodes",
                                   "palette.xml", "--mock",  "rules.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run_words(files, words, in);
}

}  // namespace

TEST_CASE("mock rules: a tree of another robot runs without it") {
    MemoryFiles files = nav_files();
    const Ran done = ran(files, "run", {"--ticks", "10", "--format", "json"});
    CHECK(done.err == "");
    CHECK(done.exit == Exit::yes);
    const auto report = nlohmann::json::parse(done.out);
    CHECK(report["successes"] == 1);
    CHECK(report["leaves"].size() == 2);
}

TEST_CASE("mock rules: validating reads the rules and what is left that does not run") {
    MemoryFiles files = nav_files();
    Ran valid = ran(files, "validate");
    CHECK(valid.err == "");
    CHECK(valid.out == "nav.xml: ok, 3 nodes\n");
    std::string& text = files.content["rules.json"];
    text.replace(text.find("\"Spin\""), 6, "\"Spn\"");
    valid = ran(files, "validate");
    CHECK(valid.exit == Exit::yes);
    CHECK(valid.out == "nav.xml: ok, 3 nodes; declared only: Spin\n");
    CHECK(valid.err == "rules.json:9:13: warning: no node is replaced by the rule for \"Spn\" "
                       "[substitution]\n"
                       "    \"Spn\": \"turn\"\n"
                       "            ^\n"
                       "1 warning\n");
    const Ran refused = ran(files, "run");
    CHECK(refused.exit == Exit::no);
    CHECK(refused.err.starts_with("nav.xml:5:8: error: Spin is only declared: it does not run "
                                  "here; a rule of --mock can put another node in its place "
                                  "[only-declared]\n"));
}

TEST_CASE("mock rules: faults in the rules have a place and end with 1, no such file with 3") {
    MemoryFiles files = nav_files();
    std::string& text = files.content["rules.json"];
    text.replace(text.find("FAILURE"), 7, "FAILED");
    const Ran wrong = ran(files, "validate");
    CHECK(wrong.exit == Exit::no);
    CHECK(wrong.err ==
          "rules.json:3:53: error: \"return_status\": expected SUCCESS, FAILURE, RUNNING or "
          "SKIPPED, found \"FAILED\" [bad-value]\n"
          "    \"drive\": { \"async_delay\": 50, \"return_status\": \"FAILED\" },\n"
          "                                                    ^\n"
          "1 error\n");
    files.content.erase("rules.json");
    for (const char* command : {"run", "validate", "try"}) {
        const Ran missing = ran(files, command);
        CHECK(missing.exit == Exit::file);
        CHECK(missing.err == "trellis: cannot read \"rules.json\": No such file or directory\n");
    }
}

TEST_CASE("mock rules: trying a tree by hand, and drawing what a run of it did") {
    MemoryFiles files = nav_files();
    CHECK(ran(files, "try", {}, "tick 4\n").out ==
          "tick 1  RUNNING  FollowPath RUNNING\n"
          "tick 4  RUNNING  FollowPath FAILURE, Spin RUNNING\n");
    CHECK(ran(files, "run", {"--ticks", "4", "--trace", "run.jsonl"}).exit == Exit::yes);
    const Ran shown = ran(files, "show", {"--trace", "run.jsonl", "--ascii"});
    CHECK(shown.err == "");
    CHECK(shown.out.find("FollowPath  path = {path}  [failure]") != std::string::npos);
    CHECK(shown.out.find("Spin  spin_dist = 1.57  [running]") != std::string::npos);
}

TEST_CASE("mock rules: two trees are compared with the same rules, each with its own leaves") {
    MemoryFiles files = nav_files();
    files.content["other.xml"] = nav;
    const Ran same = run_words(
        files, {"compare", "nav.xml", "other.xml", "--mock", "rules.json", "--ticks", "20"});
    CHECK(same.err == "");
    CHECK(same.exit == Exit::yes);
    CHECK(same.out.starts_with("seed 0: no difference in 20 ticks\n"));
}
