// trellis sweep on files in memory: rows, summary, threads, parts, and what it says when something
// is wrong. What needs a process or a disk is in sweep_program_test.cpp.
// SPDX-License-Identifier: MIT
#include "runner/command.h"
#include "runner/sweep/crew.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <stdexcept>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const turning_tree = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Sequence>
      <Script code="speed:=0.5"/>
      <MoveForward speed="{speed}" duration="0.5"/>
      <Rotate rate="1"/>
    </Sequence>
  </BehaviorTree>
</root>
)";

const char* const sweep_file = R"({"name": "n",
"behaviours": [{"name": "turning, it is", "file": "a.scxml"}, {"file": "b/b.xml"}],
"parameters": [{"name": "speed", "values": [0.3, 0.5], "of": ["turning, it is"]}],
"seeds": {"first": 3, "count": 2}, "times": [2, 4], "marks": [1, 3]})";

const char* const machine =
    R"xml(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" datamodel="script">
  <datamodel><data id="speed" expr="0.1"/><data id="angle" expr="0.0"/></datamodel>
  <state id="go">
    <invoke type="leaf" src="SetVelocity"><param name="linear" expr="speed"/></invoke>
    <transition event="tick" cond="elapsed() &gt; 0.5" target="turn"/>
  </state>
  <state id="turn">
    <onentry><assign location="angle" expr="uniform(-3, 3)"/></onentry>
    <invoke type="leaf" src="SetVelocity"><param name="angular" expr="angle"/></invoke>
    <transition event="tick" cond="elapsed() &gt; 0.5" target="go"/>
  </state>
</scxml>
)xml";

MemoryFiles sweep_files() {
    MemoryFiles files;
    files.content["d/s.json"] = sweep_file;
    files.content["d/a.scxml"] = machine;
    files.content["d/b/b.xml"] = turning_tree;
    return files;
}

/// One field of a JSON row, as JSON.
std::string field(const std::string& row, const std::string& name) {
    return nlohmann::json::parse(row)[name].dump();
}

std::string line(const std::string& text, std::size_t wanted) {
    std::size_t at = 0;
    for (; wanted != 0; --wanted)
        at = text.find('\n', at) + 1;
    return text.substr(at, text.find('\n', at) - at);
}

}  // namespace

TEST_CASE("sweep: a row for every run and time, in order") {
    MemoryFiles files = sweep_files();
    const Ran ran = run_words(files, {"sweep", "d/s.json", "--out", "rows.csv"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.err == "");
    const std::string rows = files.content["rows.csv"];
    CHECK(line(rows, 0) == "run,behaviour,world,speed,seed,time,covered,covered_at_1,covered_at_3,"
                           "to_50,to_80,to_90,to_95,to_99,path,overlap,turns,bumps,largest_gap,"
                           "dirt,ended,ended_at");
    CHECK(line(rows, 1).starts_with("0,\"turning, it is\",lab,0.3,3,2,"));
    CHECK(line(rows, 2).starts_with("0,\"turning, it is\",lab,0.3,3,4,"));
    CHECK(line(rows, 3).starts_with("1,\"turning, it is\",lab,0.3,4,2,"));
    CHECK(line(rows, 5).starts_with("2,\"turning, it is\",lab,0.5,3,2,"));
    CHECK(line(rows, 9).starts_with("4,b/b.xml,lab,,3,2,"));
    CHECK(line(rows, 12).starts_with("5,b/b.xml,lab,,4,4,"));
    CHECK(line(rows, 12).ends_with(",time,4"));
    CHECK(line(rows, 13) == "");
    CHECK(files.content.count("rows.csv.runs") == 0);
}

TEST_CASE("sweep: a row says what trellis run says") {
    MemoryFiles files = sweep_files();
    REQUIRE(run_words(files, {"sweep", "d/s.json", "--out", "rows.jsonl"}).exit == Exit::yes);
    const std::string row = line(files.content["rows.jsonl"], 3);
    const Ran run = run_words(files, {"run", "d/a.scxml", "--set", "speed=0.3", "--seed", "4",
                                      "--time", "4", "--coverage", "--format", "json"});
    const auto report = nlohmann::json::parse(run.out);
    CHECK(field(row, "run") == "1");
    CHECK(field(row, "seed") == "4");
    CHECK(field(row, "path") == report["distance"].dump());
    CHECK(field(row, "bumps") == report["bumps"].dump());
    CHECK(field(row, "turns") == report["coverage"]["turns"].dump());
    CHECK(field(row, "overlap") == report["coverage"]["overlap"].dump());
    CHECK(field(row, "to_50") == "null");
    CHECK(field(row, "covered_at_3") != "null");
    CHECK(nlohmann::json::parse(row)["covered"].get<double>() ==
          doctest::Approx(100.0 * report["coverage"]["share"].get<double>()));
    CHECK(nlohmann::json::parse(row)["largest_gap"].get<double>() ==
          doctest::Approx(report["coverage"]["largest_gap"].get<double>()));
    // a mark beyond the row's time says nothing
    CHECK(field(line(files.content["rows.jsonl"], 2), "covered_at_3") == "null");
}

TEST_CASE("sweep: threads and parts change nothing") {
    MemoryFiles files = sweep_files();
    const Ran one = run_words(files, {"sweep", "d/s.json", "--out", "1.csv", "--jobs", "1"});
    const Ran eight = run_words(files, {"sweep", "d/s.json", "--out", "8.csv", "--jobs", "8"});
    CHECK(one.out == eight.out);
    CHECK(files.content["1.csv"] == files.content["8.csv"]);

    std::vector<std::string> merge{"sweep", "merge", "d/s.json", "--out", "3.csv"};
    for (const std::string part : {"2", "3", "1"}) {
        const Ran ran =
            run_words(files, {"sweep", "d/s.json", "--out", "p.csv", "--shard", part + "/3"});
        CHECK(ran.exit == Exit::yes);
        CHECK(ran.out == "part " + part + " of 3 is in p.csv." + part +
                             "-of-3.runs; trellis sweep merge puts all parts together\n");
        merge.push_back("p.csv." + part + "-of-3.runs");
    }
    const Ran merged = run_words(files, merge);
    CHECK(merged.exit == Exit::yes);
    CHECK(merged.out == one.out);
    CHECK(files.content["3.csv"] == files.content["1.csv"]);

    merge.pop_back();
    const Ran missing = run_words(files, merge);
    CHECK(missing.exit == Exit::no);
    CHECK(missing.err == "trellis: 2 of 6 runs are missing: give all parts, and finish them with "
                         "--resume\n");
}

TEST_CASE("sweep: the summary, as text and as JSON") {
    MemoryFiles files = sweep_files();
    const Ran text = run_words(files, {"sweep", "d/s.json"});
    CHECK(text.out.starts_with("after 2 s, seeds 3 to 4\n\ncovered, %"));
    CHECK(text.out.find("\nturning, it is speed=0.3 ") != std::string::npos);
    CHECK(text.out.find("\nequal seeds, % ") != std::string::npos);
    const Ran ran = run_words(files, {"sweep", "d/s.json", "--format", "json"});
    const auto json = nlohmann::json::parse(ran.out);
    REQUIRE(json["cases"].size() == 6);
    CHECK(json["cases"][1]["parameters"]["speed"] == "0.5");
    CHECK(json["cases"][1]["covered"]["count"] == 2);
    CHECK(json["cases"][1]["ended"]["time"] == 2);
    REQUIRE(json["differences"].size() == 4);
    CHECK(json["differences"][0]["against"] == "turning, it is speed=0.3");
    const double difference = json["cases"][1]["covered"]["mean"].get<double>() -
                              json["cases"][0]["covered"]["mean"].get<double>();
    CHECK(json["differences"][0]["covered"]["mean"].get<double>() == doctest::Approx(difference));
}

TEST_CASE("sweep: with the rows on standard output the summary goes elsewhere") {
    MemoryFiles files = sweep_files();
    const Ran ran = run_words(files, {"sweep", "d/s.json", "--out", "-"});
    CHECK(ran.out.starts_with("run,behaviour,"));
    CHECK(ran.err.starts_with("after 2 s"));
}

TEST_CASE("sweep: a full disk loses nothing that was done") {
    MemoryFiles files = sweep_files();
    REQUIRE(run_words(files, {"sweep", "d/s.json", "--out", "good.csv"}).exit == Exit::yes);
    files.full = {"rows.csv", "rows.csv.runs"};
    files.room = 1500;
    const Ran full = run_words(files, {"sweep", "d/s.json", "--out", "rows.csv", "--jobs", "1"});
    CHECK(full.exit == Exit::file);
    CHECK(full.err == "trellis: cannot write \"rows.csv.runs\": No space left on device; what is "
                      "done so far is kept: go on with --resume\n");
    files.full = {"rows.csv"};
    const Ran rows = run_words(files, {"sweep", "d/s.json", "--out", "rows.csv", "--resume"});
    CHECK(rows.exit == Exit::file);
    CHECK(rows.err == "trellis: cannot write \"rows.csv\": No space left on device\n");
    files.full = {};
    CHECK(run_words(files, {"sweep", "d/s.json", "--out", "rows.csv", "--resume"}).exit ==
          Exit::yes);
    CHECK(files.content["rows.csv"] == files.content["good.csv"]);
    CHECK(files.content.count("rows.csv.runs") == 0);
}

TEST_CASE("sweep: what cannot be read or written") {
    MemoryFiles files = sweep_files();
    files.refused = {"rows.csv.runs"};
    const Ran refused = run_words(files, {"sweep", "d/s.json", "--out", "rows.csv"});
    CHECK(refused.exit == Exit::file);
    CHECK(refused.err == "trellis: cannot write \"rows.csv.runs\": Permission denied\n");
    CHECK(run_words(files, {"sweep", "none.json"}).exit == Exit::file);
    files.content.erase("d/a.scxml");
    const Ran gone = run_words(files, {"sweep", "d/s.json"});
    CHECK(gone.exit == Exit::file);
    CHECK(gone.err == "trellis: cannot read \"d/a.scxml\": No such file or directory\n");
}

TEST_CASE("sweep: options that make no sense") {
    MemoryFiles files = sweep_files();
    CHECK(run_words(files, {"sweep"}).err ==
          "trellis: which sweep file? try: trellis sweep --help\n");
    CHECK(run_words(files, {"sweep", "d/s.json", "--shard", "4/3", "--out", "a.csv"}).err ==
          "trellis: --shard: expected i/n as in 1/3, found \"4/3\"\n");
    CHECK(run_words(files, {"sweep", "d/s.json", "--shard", "1/3"}).err ==
          "trellis: a part of a sweep needs --out FILE: its runs are kept beside that file\n");
    CHECK(run_words(files, {"sweep", "d/s.json", "--out", "a.txt"}).exit == Exit::usage);
}

TEST_CASE("sweep: variables that a behaviour does not have, at their place in the sweep file") {
    MemoryFiles files = sweep_files();
    files.content["d/s.json"] = R"({"behaviours": [{"file": "a.scxml", "set": {"sped": 1}}],
"parameters": [{"name": "angel", "values": [1]}], "times": [1]})";
    const Ran ran = run_words(files, {"sweep", "d/s.json"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.starts_with("d/s.json:1:46: error: \"a.scxml\" has no variable \"sped\"; did you "
                              "mean \"speed\"? [unknown-variable]\n"));
    CHECK(ran.err.find("d/s.json:2:26: error: \"a.scxml\" has no variable \"angel\"; did you mean "
                       "\"angle\"? [unknown-variable]\n") != std::string::npos);
}

TEST_CASE("sweep: a tree whose variables only the sweep gives values to") {
    MemoryFiles files;
    files.content["s.json"] = R"({"behaviours": [{"file": "t.xml", "set": {"rate": 2}}],
"parameters": [{"name": "speed", "values": [0.1, 0.4]}], "times": [1]})";
    files.content["t.xml"] = R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence>
<MoveForward speed="{speed}"/><Rotate rate="{rate}"/></Sequence></BehaviorTree></root>)";
    const Ran ran = run_words(files, {"sweep", "s.json", "--out", "rows.csv"});
    CHECK(ran.err == "");
    CHECK(ran.exit == Exit::yes);
    CHECK(line(files.content["rows.csv"], 2).starts_with("1,t.xml,lab,0.4,0,1,"));
}

TEST_CASE("sweep: behaviours that fail are counted, and their rows say so") {
    MemoryFiles files = sweep_files();
    files.content["d/s.json"] = R"({"behaviours": [{"file": "b.xml"}], "times": [1],
"seeds": {"count": 2}})";
    files.content["d/b.xml"] = R"(<root BTCPP_format="4"><BehaviorTree ID="T">
<Fallback><Sequence><AlwaysFailure/><Script code="x:=1.0"/></Sequence>
<Sequence><MoveForward duration="0.5"/><MoveForward duration="{x}"/></Sequence></Fallback></BehaviorTree></root>)";
    const Ran ran = run_words(files, {"sweep", "d/s.json", "--out", "rows.csv"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("trellis: 2 runs of 2 failed; the first is that of b.xml, seed 0\n") !=
          std::string::npos);
    CHECK(ran.err.find("d/b.xml:3:41: error: MoveForward: input \"duration\"") !=
          std::string::npos);
    CHECK(line(files.content["rows.csv"], 1).find(",fault,0.5") != std::string::npos);
}

TEST_CASE("sweep crew: each number once, in as many threads as are asked for") {
    for (const unsigned threads : {0U, 1U, 3U, 16U}) {
        std::vector<std::atomic<int>> done(100);
        share_out(done.size(), threads, [&](std::size_t i) {
            ++done[i];
            return true;
        });
        for (const std::atomic<int>& times : done)
            CHECK(times == 1);
    }
    int calls = 0;
    share_out(10, 1, [&](std::size_t) { return ++calls < 3; });
    CHECK(calls == 3);
    CHECK_THROWS_AS(share_out(10, 4, [](std::size_t) -> bool { throw std::runtime_error("no"); }),
                    std::runtime_error);
}
