// Profiles: ticks of nodes and states, and how run --stats tells them.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const fallback_tree = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Fallback name="either">
      <Sequence name="first">
        <MoveForward duration="0.05"/>
        <SetVelocity name="skipped" linear="0" angular="0" _skipIf="true"/>
      </Sequence>
      <GoBack/>
    </Fallback>
  </BehaviorTree>
</root>
)";

std::string stats_of(const Ran& ran) {
    const std::size_t begin = ran.out.find("\nnode ") + 1;
    return ran.out.substr(begin);
}

}  // namespace

TEST_CASE("profile: every node of a tree, and those that were never reached") {
    MemoryFiles files;
    files.content["a.xml"] = fallback_tree;
    const Ran ran = run_words(files, {"run", "a.xml", "--ticks", "6", "--stats"});
    CHECK(ran.exit == Exit::yes);
    CHECK(stats_of(ran) ==
          "node               ticks  success  failure  skipped  halted     time    share\n"
          "Main                   6        1        0        0       0  0.100 s  100.0 %\n"
          "  either               6        1        0        0       0  0.100 s  100.0 %\n"
          "    first              6        1        0        0       0  0.100 s  100.0 %\n"
          "      MoveForward      6        1        0        0       0  0.100 s  100.0 %\n"
          "      skipped          0        0        0        1       0  0.000 s    0.0 %\n"
          "    GoBack             0        0        0        0       0  0.000 s    0.0 %\n"
          "\n"
          "never reached, of 6 nodes:\n"
          "  GoBack  a.xml:8:8\n");
}

TEST_CASE("profile: the same as JSON") {
    MemoryFiles files;
    files.content["a.xml"] = fallback_tree;
    const Ran ran =
        run_words(files, {"run", "a.xml", "--ticks", "6", "--stats", "--format", "json"});
    const auto rows = nlohmann::json::parse(ran.out)["stats"]["rows"];
    REQUIRE(rows.size() == 6);
    CHECK(rows[0]["parent"].is_null());
    CHECK(rows[4] == nlohmann::json::parse(R"({"row": 4, "parent": 2, "name": "skipped",
        "kind": "SetVelocity", "place": "a.xml:6:10", "reached": true, "entered": 0, "ticks": 0,
        "successes": 0, "failures": 0, "skips": 1, "halts": 0, "time": 0.0, "share": 0.0})"));
}

TEST_CASE("profile: states, transitions, and what runs in states") {
    MemoryFiles files;
    files.content["a.scxml"] = two_states;
    const Ran ran = run_words(files, {"run", "a.scxml", "--stats"});
    CHECK(ran.out.substr(ran.out.rfind("\nstate ") + 1) ==
          "state  entered  ticks     time   share\n"
          "go           1      3  0.050 s  75.0 %\n"
          "done         1      1  0.017 s  25.0 %\n"
          "\n"
          "transition                          taken\n"
          "go → done  tick [elapsed() > 0.04]      1\n"
          "\n"
          "all 3 states and activities were reached\n");
    const Ran json = run_words(files, {"run", "a.scxml", "--stats", "--format", "json"});
    const auto stats = nlohmann::json::parse(json.out)["stats"];
    CHECK(stats["transitions"] == nlohmann::json::parse(R"([{"index": 1, "row": 1,
              "words": "go → done  tick [elapsed() > 0.04]", "taken": 1}])"));
    CHECK(stats["rows"][1]["name"] == "SetVelocity");
    CHECK(stats["rows"][1]["ticks"] == 3);
    CHECK(stats["rows"][1]["halts"] == 1);
}
