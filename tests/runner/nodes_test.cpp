// trellis nodes: the palette in three spellings.
// SPDX-License-Identifier: MIT
#include "load/load.h"
#include "runner/behaviour.h"
#include "runner/command.h"
#include "runner/palette.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("nodes: every node, leaf, port and sensor is told to people") {
    MemoryFiles files;
    const std::string out = run_words(files, {"nodes"}).out;
    CHECK(out.starts_with("Built-in nodes of trees\n"));
    CHECK(out.find("  Rotate (Action): turn on the spot by a random angle\n"
                   "    rate=0.5 rad/s: how fast to turn; above 0\n") != std::string::npos);
    CHECK(out.find("    num_cycles (required): ") != std::string::npos);
    CHECK(out.find("\nSensors, in expressions\n"
                   "  _x.bumper: the robot has met a wall in the last tick\n"
                   "  _x.x m: position, to the right\n") != std::string::npos);
    CHECK(run_words(files, {"nodes", "--text"}).out == out);
}

TEST_CASE("nodes: as JSON") {
    MemoryFiles files;
    const auto nodes = nlohmann::json::parse(run_words(files, {"nodes", "--json"}).out);
    const auto named = [&](const char* name) {
        const auto& all = nodes["nodes"];
        return *std::find_if(all.begin(), all.end(),
                             [&](const auto& node) { return node["name"] == name; });
    };
    CHECK(named("Repeat")["kind"] == "Decorator");
    CHECK(named("Repeat")["ports"][0]["type"] == "int");
    CHECK(named("Bumped")["kind"] == "Condition");
    CHECK(named("Bumped")["built_in"] == false);
    CHECK(named("GoBack")["ports"][0] == nlohmann::json::parse(R"({
        "name": "speed", "direction": "input", "type": "double", "unit": "m/s", "required": false,
        "default": "0.1", "doc": "backwards"})"));
    CHECK(nodes["sensors"].size() == 14);
}

TEST_CASE("nodes: as a TreeNodesModel of the leaves, which reads back") {
    MemoryFiles files;
    const std::string out = run_words(files, {"nodes", "--xml"}).out;
    CHECK(out == run_words(files, {"nodes", "--format", "xml"}).out);
    Diagnostics diagnostics;
    const auto document = read({"palette.xml", out}, diagnostics);
    REQUIRE(document);
    CHECK(diagnostics.all().empty());
    CHECK(document->name({1}) == "TreeNodesModel");
    const RoombaRegistry registry;
    CHECK(document->child_count({1}) == registry.leaves().size());
    CHECK(out.find("<input_port name=\"speed\" type=\"double\" default=\"0.5\">forwards, in m/s"
                   "</input_port>\n") != std::string::npos);
    CHECK(out.find("Sequence") == std::string::npos);
}
