// Leaves known by declaration only: validated with their ports, not run.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const palette = R"(<root BTCPP_format="4">
  <TreeNodesModel>
    <Action ID="FollowPath">
      <input_port name="path" type="nav_msgs::msg::Path"/>
      <input_port name="speed" type="double" default="0.5"/>
      <output_port name="error" type="int"/>
    </Action>
    <Condition ID="GoalReached"/>
  </TreeNodesModel>
</root>
)";

std::string tree_with(const std::string& nodes) {
    return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Sequence>" + nodes +
           "</Sequence></BehaviorTree></root>";
}

Ran validated(const std::string& nodes) {
    MemoryFiles files;
    files.content = {{"a.xml", tree_with(nodes)}, {"palette.xml", palette}};
    return run_words(files, {"validate", "a.xml", "--nodes", "palette.xml"});
}

}  // namespace

TEST_CASE("declarations: leaves of a palette are checked by their ports") {
    Ran ran = validated("<GoalReached/><FollowPath path=\"{path}\" error=\"{e}\"/>");
    CHECK(ran.err == "");
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out == "a.xml: ok, 3 nodes; declared only: FollowPath, GoalReached\n");
    ran = validated("<FollowPath pth=\"{path}\"/>");
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("did you mean \"path\"?") != std::string::npos);
    ran = validated("<FollowPath speed=\"fast\"/>");
    CHECK(ran.exit == Exit::no);
    ran = validated("<FollowPat/>");
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("did you mean \"FollowPath\"?") != std::string::npos);
}

TEST_CASE("declarations: a file knows what it declares itself, and the next does not") {
    MemoryFiles files;
    std::string own = palette;
    own.insert(own.find("  <TreeNodesModel>"),
               "<BehaviorTree ID=\"Main\"><GoalReached/></BehaviorTree>");
    files.content = {{"a.xml", own}, {"b.xml", tree_with("<GoalReached/>")}};
    const Ran ran = run_words(files, {"validate", "a.xml", "b.xml", "--format", "json"});
    CHECK(ran.exit == Exit::no);
    const auto json = nlohmann::json::parse(ran.out)["files"];
    CHECK(json[0]["ok"] == true);
    CHECK(json[0]["declared"] == nlohmann::json::parse(R"(["GoalReached"])"));
    CHECK(json[1]["ok"] == false);
    const Ran refused = run_words(files, {"run", "a.xml"});
    CHECK(refused.exit == Exit::no);
    CHECK(refused.err == "a.xml:2:26: error: GoalReached is only declared: it does not run here; "
                         "a rule of --mock can put another node in its place [only-declared]\n"
                         "<BehaviorTree ID=\"Main\"><GoalReached/></BehaviorTree>  "
                         "<TreeNodesModel>\n"
                         "                         ^\n"
                         "1 error\n");
    CHECK(run_words(files, {"try", "a.xml"}, "tick\n").out == "tick 1  FAILURE  GoalReached "
                                                              "FAILURE\n");
}

TEST_CASE("declarations: a file that is only a palette is valid") {
    MemoryFiles files;
    files.content["palette.xml"] = palette;
    Ran ran = run_words(files, {"validate", "palette.xml"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.err == "");
    CHECK(ran.out == "palette.xml: ok, a palette of 2 nodes\n");
    files.content["own.xml"] = run_words(files, {"nodes", "--xml"}).out;
    CHECK(run_words(files, {"validate", "own.xml"}).exit == Exit::yes);
    files.content["bad.xml"] = "<root><TreeNodesModel><Action/></TreeNodesModel></root>";
    ran = run_words(files, {"validate", "bad.xml"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("no-main-tree") == std::string::npos);
}

TEST_CASE("declarations: files of --nodes that cannot be read or declare nothing") {
    MemoryFiles files;
    files.content["a.xml"] = forward_tree;
    CHECK(run_words(files, {"validate", "a.xml", "--nodes", "no.xml"}).exit == Exit::file);
    const Ran ran = run_words(files, {"validate", "a.xml", "--nodes", "a.xml"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "trellis: a.xml has no TreeNodesModel\n");
}
