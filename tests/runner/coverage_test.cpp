// trellis run --coverage: what it says, as text and as JSON.
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

/// Half a metre forwards, then a turn on the spot, again and again.
constexpr const char* there_and_back = R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence>
  <MoveForward duration="1"/><Rotate least="3.14" most="3.14" rate="2"/>
</Sequence></BehaviorTree></root>)";

}  // namespace

TEST_CASE("coverage: the report says how much, how well and when") {
    MemoryFiles files = with("a.xml", there_and_back);
    const Ran ran = run_words(files, {"run", "a.xml", "--time", "10", "--coverage"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.err == "");
    const std::size_t section = ran.out.find("\ncovered ");
    REQUIRE(section != std::string::npos);
    CHECK(ran.out.substr(section) ==
          "\n"
          "covered   0.9 % of 30.690 m², cells of 0.05 m\n"
          "swept     2.59 times over, 4 turns on the spot\n"
          "gap       30.428 m², the largest\n"
          "\n"
          "part   50 %  80 %  90 %  95 %  99 %\n"
          "after     -     -     -     -     -\n"
          "\n"
          "time     1.0 s  2.0 s  3.0 s  4.0 s  5.0 s  6.0 s  7.0 s  8.0 s  9.0 s  10.0 s\n"
          "covered  0.7 %  0.7 %  0.7 %  0.8 %  0.8 %  0.8 %  0.9 %  0.9 %  0.9 %   0.9 %\n");
}

TEST_CASE("coverage: the same as JSON, on cells of another size") {
    MemoryFiles files = with("a.xml", there_and_back);
    const Ran ran =
        run_words(files, {"run", "a.xml", "--time", "10", "--cell", "0.1", "--format", "json"});
    CHECK(ran.exit == Exit::yes);
    const auto coverage = nlohmann::json::parse(ran.out)["coverage"];
    CHECK(coverage["cell"] == 0.1);
    CHECK(coverage["turns"] == 4);
    CHECK(coverage["reached"]["50"] == nullptr);
    CHECK(coverage["curve"].size() == 10);
    CHECK(coverage["curve"][9]["share"] == coverage["share"]);
    CHECK(coverage["curve"][9]["time"] == 10.0);
}

TEST_CASE("coverage: without being asked for, nothing is said of it") {
    MemoryFiles files = with("a.xml", there_and_back);
    CHECK(run_words(files, {"run", "a.xml"}).out.find("covered") == std::string::npos);
}

TEST_CASE("coverage: cells that make no sense are refused") {
    MemoryFiles files = with("a.xml", there_and_back);
    const Ran ran = run_words(files, {"run", "a.xml", "--cell", "0"});
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: --cell: Value 0 not in range 0.005000 to 1.000000\n"
                     "try: trellis run --help\n");
}
