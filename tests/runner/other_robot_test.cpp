// A tree for Nav2 and the palette of its nodes, of which none runs here: validated, drawn,
// converted, tried by hand and run with mocks, as on a machine without ROS.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

#include <string>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const palette = R"(<root BTCPP_format="4">
  <TreeNodesModel>
    <Action ID="ComputePathToPose">
      <input_port name="goal">Destination to plan to</input_port>
      <input_port name="planner_id"/>
      <output_port name="path">Path created</output_port>
    </Action>
    <Action ID="FollowPath"><input_port name="path"/></Action>
    <Action ID="ClearEntireCostmap"><input_port name="service_name"/></Action>
    <Action ID="Spin"><input_port name="spin_dist" type="double" default="1.57"/></Action>
    <Condition ID="GoalUpdated"/>
    <Control ID="PipelineSequence"/>
    <Control ID="RecoveryNode"><input_port name="number_of_retries" type="int" default="1"/></Control>
    <Control ID="ReactiveFallback"/>
    <Decorator ID="RateController"><input_port name="hz" type="double" default="10.0"/></Decorator>
  </TreeNodesModel>
</root>
)";

const char* const tree = R"(<root BTCPP_format="4" main_tree_to_execute="MainTree">
  <BehaviorTree ID="MainTree">
    <RecoveryNode number_of_retries="6" name="NavigateRecovery">
      <Control ID="PipelineSequence" name="NavigateWithReplanning">
        <RateController hz="1.0">
          <ComputePathToPose goal="{goal}" path="{path}" planner_id="GridBased"/>
        </RateController>
        <FollowPath path="{path}"/>
      </Control>
      <ReactiveFallback name="RecoveryFallback">
        <GoalUpdated/>
        <ClearEntireCostmap name="ClearLocalCostmap" service_name="local/clear"/>
        <Spin spin_dist="1.57"/>
      </ReactiveFallback>
    </RecoveryNode>
  </BehaviorTree>
</root>
)";

const char* const rules = R"({
  "TestNodeConfigs": {
    "plan": { "async_delay": 100, "post_script": "path := 'a path'" },
    "drive": { "async_delay": 200, "return_status": "FAILURE" }
  },
  "SubstitutionRules": {
    "RecoveryNode": "Fallback",
    "PipelineSequence": "Sequence",
    "RateController": "Sequence",
    "ComputePathToPose": "plan",
    "FollowPath": "drive",
    "GoalUpdated": "AlwaysFailure",
    "ClearLocalCostmap": "AlwaysFailure",
    "Spin": "AlwaysSuccess"
  }
})";

MemoryFiles nav_files() {
    MemoryFiles files;
    files.content = {{"nav.xml", tree}, {"nodes.xml", palette}, {"rules.json", rules}};
    return files;
}

}  // namespace

TEST_CASE("other robot: controls and decorators of a palette are checked like its leaves") {
    MemoryFiles files = nav_files();
    Ran ran = run_words(files, {"validate", "nav.xml", "--nodes", "nodes.xml"});
    CHECK(ran.err == "");
    CHECK(ran.out == "nav.xml: ok, 9 nodes; declared only: ClearEntireCostmap, "
                     "ComputePathToPose, FollowPath, GoalUpdated, PipelineSequence, "
                     "RateController, RecoveryNode, Spin\n");
    std::string wrong = tree;
    wrong.replace(wrong.find("number_of_retries"), 17, "number_of_retrys!");
    wrong.replace(wrong.find('!'), 1, "");
    wrong.replace(wrong.find("hz=\"1.0\""), 8, "hz=\"often\"");
    wrong.insert(wrong.find("</RateController>"), "<GoalUpdated/>");
    files.content["nav.xml"] = wrong;
    ran = run_words(files, {"validate", "nav.xml", "--nodes", "nodes.xml", "--format", "json"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out.find("RecoveryNode has no attribute \\\"number_of_retrys\\\"; did you mean "
                       "\\\"number_of_retries\\\"?") != std::string::npos);
    CHECK(ran.out.find("\\\"hz\\\": expected a number or a {key}, found \\\"often\\\"") !=
          std::string::npos);
    CHECK(ran.out.find("RateController takes 1 child, found 2") != std::string::npos);
}

TEST_CASE("other robot: its leaf replaces the one of the same name that has other ports") {
    MemoryFiles files = nav_files();
    files.content["nav.xml"] = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">"
                               "<Wait wait_duration=\"5\"/></BehaviorTree></root>";
    files.content["nodes.xml"] = "<root BTCPP_format=\"4\"><TreeNodesModel><Action ID=\"Wait\">"
                                 "<input_port name=\"wait_duration\"/></Action>"
                                 "</TreeNodesModel></root>";
    const std::vector<std::string> words = {"validate", "nav.xml", "--nodes", "nodes.xml"};
    CHECK(run_words(files, words).out == "nav.xml: ok, 1 node; declared only: Wait\n");
    CHECK(run_words(files, {"run", "nav.xml", "--nodes", "nodes.xml"})
              .err.find("Wait is only declared") != std::string::npos);
    // the Roomba's own, as `trellis nodes --xml` declares it
    files.content["nav.xml"] = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">"
                               "<Wait duration=\"5\"/></BehaviorTree></root>";
    files.content["nodes.xml"] = run_words(files, {"nodes", "--xml"}).out;
    CHECK(run_words(files, words).out == "nav.xml: ok, 1 node\n");
}

TEST_CASE("other robot: a palette in a file that is included counts like one in the file itself") {
    MemoryFiles files = nav_files();
    std::string including = tree;
    including.insert(including.find("  <BehaviorTree"), "  <include path=\"lib/all.xml\"/>\n");
    files.content["nav.xml"] = including;
    files.content["lib/all.xml"] = "<root BTCPP_format=\"4\"><include path=\"nodes.xml\"/>"
                                   "<include path=\"all.xml\"/></root>";
    files.content["lib/nodes.xml"] = palette;
    const Ran ran = run_words(files, {"validate", "nav.xml"});
    // the rest is known, and a cycle ends
    CHECK(ran.err.find("lib/all.xml includes lib/all.xml [include-cycle]") != std::string::npos);
    CHECK(ran.err.find("unknown-node") == std::string::npos);
    files.content["lib/all.xml"] = "<root BTCPP_format=\"4\"><include path=\"nodes.xml\"/></root>";
    CHECK(run_words(files, {"validate", "nav.xml"}).exit == Exit::yes);
    CHECK(run_words(files, {"validate", "nav.xml", "--mock", "rules.json"}).out ==
          "nav.xml: ok, 9 nodes\n");
}

TEST_CASE("other robot: its tree is drawn and converted as it is") {
    MemoryFiles files = nav_files();
    const Ran shown = run_words(files, {"show", "nav.xml", "--nodes", "nodes.xml"});
    CHECK(shown.exit == Exit::yes);
    CHECK(shown.out.find("NavigateWithReplanning (PipelineSequence)") != std::string::npos);
    CHECK(run_words(files, {"show", "nav.xml", "--svg", "nav.svg"}).exit == Exit::yes);
    CHECK(run_words(files, {"convert", "nav.xml", "nav.json"}).exit == Exit::yes);
    CHECK(run_words(files, {"convert", "nav.json", "back.xml"}).exit == Exit::yes);
    CHECK(run_words(files, {"convert", "back.xml", "again.json"}).exit == Exit::yes);
    CHECK(files.content["nav.json"] == files.content["again.json"]);
    CHECK(files.content["back.xml"].find("<Control ID=\"PipelineSequence\" "
                                         "name=\"NavigateWithReplanning\">") != std::string::npos);
    CHECK(run_words(files, {"validate", "nav.json", "--nodes", "nodes.xml"}).exit == Exit::yes);
}

TEST_CASE("other robot: rules of --mock let its tree be tried by hand and run") {
    MemoryFiles files = nav_files();
    const std::vector<std::string> with_rules = {"nav.xml", "--nodes", "nodes.xml", "--mock",
                                                 "rules.json"};
    std::vector<std::string> words = {"try"};
    words.insert(words.end(), with_rules.begin(), with_rules.end());
    const Ran tried = run_words(files, words, "tick 20\n");
    CHECK(tried.exit == Exit::yes);
    CHECK(tried.out.find("ComputePathToPose SUCCESS, FollowPath RUNNING") != std::string::npos);
    CHECK(tried.out.find("FollowPath FAILURE, GoalUpdated FAILURE, ClearLocalCostmap FAILURE, "
                         "Spin SUCCESS") != std::string::npos);
    words = {"run"};
    words.insert(words.end(), with_rules.begin(), with_rules.end());
    words.insert(words.end(), {"--time", "2"});
    const Ran ran = run_words(files, words);
    CHECK(ran.err == "");
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out.find("root      succeeded") != std::string::npos);
}

TEST_CASE("other robot: leaves that are only declared are tried by hand, controls are not") {
    MemoryFiles files = nav_files();
    const Ran refused = run_words(files, {"try", "nav.xml", "--nodes", "nodes.xml"}, "tick\n");
    CHECK(refused.exit == Exit::no);
    CHECK(refused.err.find("nav.xml:3:6: error: RecoveryNode is only declared: it does not run "
                           "here; a rule of --mock can put another node in its place "
                           "[only-declared]") != std::string::npos);
    CHECK(refused.err.find("Spin") == std::string::npos);
    files.content["rules.json"] =
        R"({"SubstitutionRules": {"RecoveryNode": "Fallback", "PipelineSequence": "Sequence",
            "RateController": "Sequence"}})";
    const Ran tried =
        run_words(files,
                  {"try", "nav.xml", "--nodes", "nodes.xml", "--mock", "rules.json", "--outcomes",
                   "ComputePathToPose=S", "--outcomes", "FollowPath=RS"},
                  "tick 2\n");
    CHECK(tried.out == "tick 1  RUNNING  ComputePathToPose SUCCESS, FollowPath RUNNING\n"
                       "tick 2  SUCCESS  FollowPath SUCCESS\n");
}

TEST_CASE("other robot: validate reports the faults of rules beside a palette") {
    MemoryFiles files = nav_files();
    files.content["rules.json"] = R"({"TestNodeConfigs": {"plan": {"async_delai": 1}},
 "SubstitutionRules": {"Spin": "Sequenc", "Nobody": "AlwaysSuccess"}})";
    Ran ran =
        run_words(files, {"validate", "nav.xml", "--nodes", "nodes.xml", "--mock", "rules.json"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("rules.json:1:") != std::string::npos);
    CHECK(ran.err.find("did you mean \"async_delay\"?") != std::string::npos);
    CHECK(ran.err.find("did you mean \"Sequence\"?") != std::string::npos);
    ran = run_words(files, {"validate", "nodes.xml", "--mock", "rules.json"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("did you mean \"Sequence\"?") != std::string::npos);
}
