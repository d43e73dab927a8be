// trellis run: reports, traces, logs and how it ends. The recorded runs of the lab, byte for byte,
// are in program_test.cpp.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace trellis;
using namespace trellis::test;

namespace {

MemoryFiles with(const std::string& name, const std::string& text) {
    MemoryFiles files;
    files.content[name] = text;
    return files;
}

}  // namespace

TEST_CASE("run: the report of a machine that comes to its end") {
    MemoryFiles files = with("a.scxml", two_states);
    const Ran ran = run_words(files, {"run", "a.scxml"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.err == "");
    CHECK(ran.out == "file      a.scxml (machine)\n"
                     "time      0.067 s, 4 ticks of 1/60 s\n"
                     "random    seed 0\n"
                     "start     x 3.200 m, y 2.400 m, rotation 0.000 rad\n"
                     "end       x 3.220 m, y 2.400 m, rotation 0.000 rad\n"
                     "driven    0.020 m, 0 bumps\n"
                     "ended     final: done\n"
                     "\n"
                     "state  entered     time   share\n"
                     "go           1  0.050 s  75.0 %\n"
                     "done         1  0.017 s  25.0 %\n");
}

TEST_CASE("run: the report of a tree, which starts again when its root has ended") {
    MemoryFiles files = with("a.xml", forward_tree);
    const Ran ran = run_words(files, {"run", "a.xml", "--ticks", "5", "--seed", "7"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out == "file      a.xml (tree)\n"
                     "time      0.083 s, 5 ticks of 1/60 s\n"
                     "random    seed 7\n"
                     "start     x 3.200 m, y 2.400 m, rotation 0.000 rad\n"
                     "end       x 3.242 m, y 2.400 m, rotation 0.000 rad\n"
                     "driven    0.042 m, 0 bumps\n"
                     "root      succeeded 1 time, failed 0 times\n"
                     "ended     time is up\n"
                     "\n"
                     "leaf         entered     time    share\n"
                     "MoveForward        2  0.083 s  100.0 %\n");
}

TEST_CASE("run: the same as JSON, with the log") {
    MemoryFiles files = with("a.scxml", two_states);
    const Ran ran = run_words(files, {"run", "a.scxml", "--format", "json", "--log"});
    CHECK(ran.exit == Exit::yes);
    const auto report = nlohmann::json::parse(ran.out);
    CHECK(report["kind"] == "machine");
    CHECK(report["ticks"] == 4);
    CHECK(report["ended"] == "final: done");
    CHECK(report["end"]["x"] == 3.2199999999999998);
    CHECK(report["states"][0] == nlohmann::json::parse(
                                     R"({"name": "go", "entered": 1, "ticks": 3, "time": 0.05,
                                         "share": 0.75})"));
    CHECK(report["log"] == nlohmann::json::parse(R"(["now: going"])"));
}

TEST_CASE("run: a trace of ticks and a trace of events, and log lines before the report") {
    MemoryFiles files = with("a.scxml", two_states);
    const Ran ran =
        run_words(files, {"run", "a.scxml", "--log", "--trace", "t.csv", "--trace", "e.jsonl"});
    CHECK(ran.out.starts_with("now: going\nfile "));
    CHECK(files.content["t.csv"] == "tick,t,x,y,rotation,v,w,bumper,leaf\n"
                                    "0,0.0,3.2,2.4,0.0,0.0,0.0,0,go\n"
                                    "1,0.016666666666666666,3.205,2.4,0.0,0.3,0.0,0,go\n"
                                    "2,0.03333333333333333,3.21,2.4,0.0,0.3,0.0,0,go\n"
                                    "3,0.05,3.215,2.4,0.0,0.3,0.0,0,go\n"
                                    "4,0.06666666666666667,3.2199999999999998,2.4,0.0,0.3,0.0,0,"
                                    "done\n");
    const std::string& events = files.content["e.jsonl"];
    CHECK(events.starts_with(
        R"({"tick": 0, "event": "run", "row": 0, "name": "machine", "file": "a.scxml", "rows": 5, )"
        R"("dt": 0.016666666666666666, "random": "seed 0"}
{"tick": 0, "event": "enter", "row": 1, "name": "go"}
{"tick": 0, "event": "log", "row": 1, "name": "go", "text": "now: going"}
{"tick": 0, "event": "status", "row": 2, "name": "go.1", "from": "IDLE", "to": "RUNNING"}
{"tick": 1, "event": "tick", "row": 3, "name": "SetVelocity", "status": "RUNNING"}
)"));
    CHECK(events.ends_with(R"({"tick": 4, "event": "end", "text": "final: done"}
)"));
    CHECK(events.find(R"({"tick": 4, "event": "transition", "row": 1, "name": "go", "index": 1, )"
                      R"("to": ["done"]}
)") != std::string::npos);
}

TEST_CASE("run: with a trace or a picture on standard output, the report is a message") {
    MemoryFiles files = with("a.xml", forward_tree);
    const Ran trace = run_words(files, {"run", "a.xml", "--ticks", "1", "--trace", "-"});
    CHECK(trace.out.starts_with("tick,t,x"));
    CHECK(trace.out.find("file") == std::string::npos);
    CHECK(trace.err.starts_with("file      a.xml (tree)\n"));
    const Ran picture = run_words(files, {"run", "a.xml", "--ticks", "9", "--svg", "-"});
    CHECK(picture.out.starts_with("<svg"));
    CHECK(picture.out.find("MoveForward 100 %") != std::string::npos);
}

TEST_CASE("run: files that cannot be written") {
    MemoryFiles files = with("a.xml", forward_tree);
    files.refused = {"no.csv"};
    files.full = {"full.csv", "full.svg"};
    const auto message = [&](const char* option, const char* path) {
        const Ran ran = run_words(files, {"run", "a.xml", option, path});
        CHECK(ran.exit == Exit::file);
        CHECK(ran.out == "");
        return ran.err;
    };
    CHECK(message("--trace", "no.csv") == "trellis: cannot write \"no.csv\": Permission denied\n");
    CHECK(message("--trace", "full.csv") ==
          "trellis: cannot write \"full.csv\": No space left on device\n");
    CHECK(message("--svg", "full.svg") ==
          "trellis: cannot write \"full.svg\": No space left on device\n");
    CHECK(files.content.size() == 1);
}

TEST_CASE("run: a behaviour that fails says where, and reports what it did until then") {
    MemoryFiles files = with("a.xml", R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Rotate/>
  </BehaviorTree>
</root>
)");
    files.content["none.txt"] = "# no numbers\n";
    const Ran ran = run_words(files, {"run", "a.xml", "--draws", "none.txt"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "a.xml:3:6: error: Rotate: there are no random numbers left (tick 1)\n");
    CHECK(ran.out.find("ended     fault\n") != std::string::npos);
}

TEST_CASE("run: without a world only the final state is told") {
    MemoryFiles files = with("a.scxml", R"(<scxml xmlns="http://www.w3.org/2005/07/scxml"
  version="1.0" datamodel="script">
  <state id="s"><onentry><log label="a" expr="1"/></onentry><transition target="pass"/></state>
  <final id="pass"/>
</scxml>
)");
    Ran ran = run_words(files, {"run", "a.scxml", "--world", "none", "--log"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out == "a: 1\nfinal: pass\n");

    files.content["b.scxml"] = R"(<scxml xmlns="http://www.w3.org/2005/07/scxml"
  version="1.0" datamodel="script"><state id="s"/></scxml>
)";
    ran = run_words(files, {"run", "b.scxml", "--world", "none"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out == "final: -\n");

    files.content["c.scxml"] = two_states;
    ran = run_words(files, {"run", "c.scxml", "--world", "none"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "trellis: c.scxml needs a robot: only a machine whose leaves and expressions "
                     "need none runs without one\n");
}

TEST_CASE("run: an invalid file is not run") {
    MemoryFiles files = with("a.xml", broken_tree);
    const Ran ran = run_words(files, {"run", "a.xml", "--trace", "t.csv"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out == "");
    CHECK(ran.err.ends_with("2 errors\n"));
    CHECK(files.content.count("t.csv") == 0);
}
