// trellis trace diff, and reading traces.
// SPDX-License-Identifier: MIT
#include "runner/command.h"
#include "runner/trace_file.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const trace = "tick,t,x,bumper,leaf\n"
                          "0,0.0,1.0,0,-\n"
                          "1,0.5,1.5,0,A\n"
                          "2,1.0,2.0,0,A\n"
                          "3,1.5,2.5,1,B\n";

MemoryFiles two(const std::string& a, const std::string& b) {
    MemoryFiles files;
    files.content = {{"a.csv", a}, {"b.csv", b}};
    return files;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

}  // namespace

TEST_CASE("trace diff: equal traces, and numbers within the tolerance") {
    MemoryFiles files = two(trace, replaced(trace, "2.5", "2.5000000001"));
    Ran ran = run_words(files, {"trace", "diff", "a.csv", "b.csv"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out == "4 rows are the same\n");
    ran = run_words(files, {"trace", "diff", "a.csv", "b.csv", "--tolerance", "0"});
    CHECK(ran.exit == Exit::no);
}

TEST_CASE("trace diff: the first differences, with what came before") {
    MemoryFiles files = two(trace, replaced(replaced(trace, "2.0,0,A", "2.1,0,C"), "1,B", "0,B"));
    const Ran ran = run_words(files, {"trace", "diff", "a.csv", "b.csv"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out == "--- a.csv\n"
                     "+++ b.csv\n"
                     "  0,0.0,1.0,0,-\n"
                     "  1,0.5,1.5,0,A\n"
                     "- 2,1.0,2.0,0,A\n"
                     "+ 2,1.0,2.1,0,C\n"
                     "  (x, leaf)\n"
                     "- 3,1.5,2.5,1,B\n"
                     "+ 3,1.5,2.5,0,B\n"
                     "  (bumper)\n"
                     "2 of 4 rows differ\n");
}

TEST_CASE("trace diff: a trace that is shorter") {
    MemoryFiles files = two(trace, replaced(trace, "3,1.5,2.5,1,B\n", ""));
    const Ran ran = run_words(files, {"trace", "diff", "a.csv", "b.csv"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out == "0 of 3 rows differ\na.csv has 4 rows, b.csv has 3\n");
}

TEST_CASE("trace diff: as JSON") {
    MemoryFiles files = two(trace, replaced(trace, "1,B", "1,C"));
    const Ran ran = run_words(files, {"trace", "diff", "a.csv", "b.csv", "--format", "json"});
    CHECK(nlohmann::json::parse(ran.out) == nlohmann::json::parse(R"({
        "equal": false, "tolerance": 1e-9, "rows": [4, 4], "differing": 1,
        "first": [{"row": 3, "columns": [{"name": "leaf", "a": "B", "b": "C"}]}]})"));
}

TEST_CASE("trace diff: what is not a trace") {
    MemoryFiles files = two(trace, "tick,t\n1,2,3\n");
    Ran ran = run_words(files, {"trace", "diff", "a.csv", "b.csv"});
    CHECK(ran.exit == Exit::file);
    CHECK(ran.err == "b.csv:2:1: error: expected 2 fields, found 3 [bad-trace]\n"
                     "1,2,3\n"
                     "^\n"
                     "1 error\n");
    files.content["b.csv"] = "tick,t\n0,0.0\n";
    ran = run_words(files, {"trace", "diff", "a.csv", "b.csv"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "trellis: the columns of a.csv and b.csv differ\n");
    CHECK(run_words(files, {"trace", "diff", "a.csv", "c.csv"}).exit == Exit::file);
}

TEST_CASE("trace file: quoted fields, and quotes that are wrong") {
    Diagnostics diagnostics;
    const std::string text = "tick,leaf\r\n1,\"a,\"\"b\"\"\nc\"\r\n2,d";
    const auto table = read_trace("a.csv", text, diagnostics);
    REQUIRE(table);
    CHECK(table->rows == std::vector<std::vector<std::string>>{{"1", "a,\"b\"\nc"}, {"2", "d"}});
    for (const char* wrong : {"tick\n\"a\n", "tick\n\"a\"b\n", "leaf\n1\n", ""}) {
        Diagnostics findings;
        CHECK_FALSE(read_trace("a.csv", wrong, findings));
        CHECK(findings.errors() == 1);
    }
}
