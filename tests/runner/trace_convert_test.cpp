// trellis trace convert: Chrome traces whose intervals nest, and .btlog files read back byte by
// byte by a reader that shares nothing with the writer.
// SPDX-License-Identifier: MIT
#include "load/xml.h"
#include "runner/command.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <map>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const two_trees = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence name="s">
      <SubTree ID="Part" speed="0.25"/>
      <Script code="done := true" _skipIf="false"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Part">
    <MoveForward name="go" speed="{speed}" duration="0.05"/>
  </BehaviorTree>
</root>
)";

MemoryFiles recorded(const std::string& name, const std::string& text,
                     const std::string& ticks = "5") {
    MemoryFiles files;
    files.content[name] = text;
    REQUIRE(run_words(files, {"run", name, "--ticks", ticks, "--trace", "t.jsonl"}).exit ==
            Exit::yes);
    return files;
}

std::uint64_t take(std::string_view& bytes, std::size_t count) {
    REQUIRE(bytes.size() >= count);
    std::uint64_t value = 0;
    for (std::size_t i = count; i-- > 0;) {
        value = value * 256 + static_cast<unsigned char>(bytes[i]);
    }
    bytes.remove_prefix(count);
    return value;
}

/// "B s, B go, E go FAILURE" of one track.
std::string story(const nlohmann::json& events, int track) {
    std::string out;
    for (const auto& event : events) {
        if (event["ph"] == "M" || event["tid"] != track) { continue; }
        out += (out.empty() ? "" : ", ") + event["ph"].get<std::string>() + ' ' +
               event["name"].get<std::string>();
        if (event.contains("args")) { out += ' ' + event["args"]["result"].get<std::string>(); }
    }
    return out;
}

}  // namespace

TEST_CASE("trace convert: a tree for Chrome, what ran inside what") {
    MemoryFiles files = recorded("a.xml", two_trees);
    const Ran ran = run_words(files, {"trace", "convert", "t.jsonl", "t.json", "--start", "2"});
    CHECK(ran.err == "");
    CHECK(ran.exit == Exit::yes);
    const auto trace = nlohmann::json::parse(files.content["t.json"]);
    const auto& events = trace["traceEvents"];
    CHECK(story(events, 1) ==
          "B Main, B s, B Part, B go, E go SUCCESS, E Part SUCCESS, B Script, E Script SUCCESS, "
          "E s SUCCESS, E Main SUCCESS, B Main, B s, B Part, B go, E go, E Part, E s, E Main");
    CHECK(events[1]["ts"] == 2016666.6666666665);
    CHECK(events[1]["cat"] == "BehaviorTree");
    double last = 0.0;
    for (std::size_t i = 1; i < events.size(); ++i) {
        CHECK(events[i]["ts"].get<double>() > last);
        last = events[i]["ts"].get<double>();
    }
}

TEST_CASE("trace convert: a machine for Chrome, with its transitions and logs") {
    MemoryFiles files = recorded("a.scxml", two_states);
    CHECK(run_words(files, {"trace", "convert", "t.jsonl", "-", "--to", "chrome"}).exit ==
          Exit::yes);
    const Ran ran = run_words(files, {"trace", "convert", "t.jsonl", "-", "--to", "chrome"});
    CHECK(story(nlohmann::json::parse(ran.out)["traceEvents"], 1) ==
          "B go, i now: going, B go.1, B SetVelocity, i go → done, E SetVelocity HALTED, "
          "E go.1 HALTED, E go HALTED, B done, E done");
}

TEST_CASE("trace convert: a .btlog, byte by byte") {
    MemoryFiles files = recorded("a.xml", two_trees);
    const Ran ran =
        run_words(files, {"trace", "convert", "t.jsonl", "t.btlog", "--start", "1700000000.5"});
    CHECK(ran.err == "");
    REQUIRE(ran.exit == Exit::yes);
    const std::string log = files.content["t.btlog"];
    std::string_view bytes = log;
    REQUIRE(bytes.starts_with("BTCPP4-FileLogger2"));
    bytes.remove_prefix(18);
    CHECK(take(bytes, 1) == 1);
    const std::size_t size = take(bytes, 4);
    REQUIRE(size <= bytes.size());
    const std::string_view xml = bytes.substr(0, size);
    bytes.remove_prefix(size);
    CHECK(xml.starts_with(R"(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4">
  <BehaviorTree ID="Main" _fullpath="">
    <Sequence name="s" _uid="1">
      <SubTree ID="Part" speed="0.25" _fullpath="Part::2" _uid="2"/>
      <Script name="Script" code="done := true" _skipIf="false" _uid="4"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Part" _fullpath="Part::2">
    <MoveForward name="go" speed="{speed}" duration="0.05" _uid="3"/>
  </BehaviorTree>
  <TreeNodesModel>
)"));
    CHECK(take(bytes, 8) == 1'700'000'000'500'000);
    std::string records;
    while (!bytes.empty()) {
        const std::uint64_t time = take(bytes, 6);
        const std::uint64_t uid = take(bytes, 2);
        records += std::to_string(time) + ' ' + std::to_string(uid) + "IRSFK"[take(bytes, 1)] + ' ';
    }
    // idle, running, success of the nodes 1 to 4 in ticks of 1/60 s
    CHECK(records == "16667 1R 16667 2R 16667 3R "
                     "66667 3S 66667 3I 66667 2S 66667 4S 66667 2I 66667 4I 66667 1S 66667 1I "
                     "83333 1R 83333 2R 83333 3R ");
}

TEST_CASE("trace convert: nodes of included files, and leaves in the long form") {
    MemoryFiles files;
    files.content["part.xml"] = R"(<root BTCPP_format="4"><BehaviorTree ID="Part">
        <Action ID="MoveForward" duration="0.05"/></BehaviorTree></root>)";
    files.content["a.xml"] = R"(<root BTCPP_format="4"><include path="part.xml"/>
        <BehaviorTree ID="Main"><SubTree ID="Part" name="p"/></BehaviorTree></root>)";
    REQUIRE(run_words(files, {"run", "a.xml", "--ticks", "1", "--trace", "t.jsonl"}).exit ==
            Exit::yes);
    REQUIRE(run_words(files, {"trace", "convert", "t.jsonl", "t.btlog"}).exit == Exit::yes);
    const std::string& log = files.content["t.btlog"];
    CHECK(log.find(R"(<SubTree ID="Part" _fullpath="p" _uid="1"/>)") != std::string::npos);
    CHECK(log.find(R"(<MoveForward name="MoveForward" duration="0.05" _uid="2"/>)") !=
          std::string::npos);
}

TEST_CASE("trace convert: what cannot be converted") {
    MemoryFiles files = recorded("a.scxml", two_states);
    Ran ran = run_words(files, {"trace", "convert", "t.jsonl", "t.btlog"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "trellis: a .btlog is of a tree: a.scxml is a machine; --to chrome takes "
                     "both\n");
    ran = run_words(files, {"trace", "convert", "t.jsonl", "t.txt"});
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: the name \"t.txt\" does not say what to write: give --to chrome or "
                     "--to btlog\n");
    files.content["b.scxml"] = files.content["a.scxml"];
    files.content.erase("a.scxml");
    CHECK(run_words(files, {"trace", "convert", "t.jsonl", "t.json"}).exit == Exit::file);
    CHECK(run_words(files, {"trace", "convert", "t.jsonl", "t.json", "--behaviour", "b.scxml"})
              .exit == Exit::yes);
    ran = run_words(files, {"run", "-", "--trace", "t.jsonl"}, two_states);
    ran = run_words(files, {"trace", "convert", "t.jsonl", "t.json"});
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: the behaviour was read from standard input: name it with "
                     "--behaviour\n");
}

TEST_CASE("trace convert: a tree with more nodes than a .btlog can number") {
    std::string text = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Sequence>";
    for (int i = 0; i < 65'535; ++i) {
        text += "<Script code=\"\"/>";
    }
    MemoryFiles files = recorded("a.xml", text + "</Sequence></BehaviorTree></root>", "1");
    const Ran ran = run_words(files, {"trace", "convert", "t.jsonl", "t.btlog"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "trellis: a .btlog numbers at most 65535 nodes, with 16 bits: a.xml has "
                     "65536\n");
}
