// Loading files for commands: includes, packages, variables, standard input.
// SPDX-License-Identifier: MIT
#include "runner/behaviour.h"

#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const with_include = R"(<root BTCPP_format="4">
  <include path="parts/back.xml"/>
  <BehaviorTree ID="Main"><SubTree ID="Back"/></BehaviorTree>
</root>
)";

const char* const with_package = R"(<root BTCPP_format="4">
  <include ros_pkg="lab" path="back.xml"/>
  <BehaviorTree ID="Main"><SubTree ID="Back"/></BehaviorTree>
</root>
)";

const char* const part =
    R"(<root BTCPP_format="4"><BehaviorTree ID="Back"><GoBack/></BehaviorTree></root>)";

}  // namespace

TEST_CASE("behaviour: an included file is looked for beside the one that includes it") {
    MemoryFiles files;
    files.content = {{"trees/main.xml", with_include}, {"trees/parts/back.xml", part}};
    CHECK(run_words(files, {"validate", "trees/main.xml", "--tree", "Main"}).out ==
          "trees/main.xml: ok, 2 nodes\n");
    files.content.erase("trees/parts/back.xml");
    const Ran ran = run_words(files, {"validate", "trees/main.xml", "--tree", "Main"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("parts/back.xml") != std::string::npos);
}

TEST_CASE("behaviour: a package is the folder that --ros-pkg names") {
    MemoryFiles files;
    files.content = {{"main.xml", with_package}, {"/opt/lab/back.xml", part}};
    CHECK(run_words(files, {"validate", "main.xml", "--tree", "Main"}).exit == Exit::no);
    CHECK(run_words(files, {"validate", "main.xml", "--tree", "Main", "--ros-pkg", "lab=/opt/lab"})
              .out == "main.xml: ok, 2 nodes\n");
}

TEST_CASE("behaviour: standard input has a name in messages") {
    MemoryFiles files;
    CHECK(run_words(files, {"validate", "-"}, forward_tree).out == "standard input: ok, 1 node\n");
    const Ran ran = run_words(files, {"validate", "-"}, "<root");
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.starts_with("standard input:1:"));
}

TEST_CASE("behaviour: a variable that is set must exist") {
    MemoryFiles files;
    files.content = {{"a.scxml", two_states}};
    const Ran ran = run_words(files, {"run", "a.scxml", "--set", "a=1"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err ==
          "a.scxml: error: there is no variable \"a\" to set [unknown-variable]\n1 error\n");
}
