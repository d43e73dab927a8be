// trellis validate: several files, all findings, both formats.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace trellis;
using namespace trellis::test;

namespace {

MemoryFiles three_files() {
    MemoryFiles files;
    files.content = {{"a.xml", forward_tree}, {"b.xml", broken_tree}, {"c.scxml", two_states}};
    return files;
}

}  // namespace

TEST_CASE("validate: every file is checked, and one that is invalid makes the answer no") {
    MemoryFiles files = three_files();
    const Ran ran = run_words(files, {"validate", "a.xml", "b.xml", "c.scxml"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out == "a.xml: ok, 1 node\nc.scxml: ok, 4 nodes\n");
    CHECK(ran.err == "b.xml:3:6: error: unknown node \"Sequenc\"; did you mean \"Sequence\"? "
                     "[unknown-node]\n"
                     "    <Sequenc>\n"
                     "     ^\n"
                     "b.xml:4:20: error: MoveForward has no attribute \"sped\"; did you mean "
                     "\"speed\"? [unknown-attribute]\n"
                     "      <MoveForward sped=\"1\"/>\n"
                     "                   ^\n"
                     "2 errors\n");
    CHECK(run_words(files, {"validate", "a.xml", "c.scxml"}).exit == Exit::yes);
}

TEST_CASE("validate: a file that is not there is worse than one that is invalid") {
    MemoryFiles files = three_files();
    const Ran ran = run_words(files, {"validate", "x.xml", "b.xml", "a.xml"});
    CHECK(ran.exit == Exit::file);
    CHECK(ran.out == "a.xml: ok, 1 node\n");
    CHECK(ran.err.starts_with("trellis: cannot read \"x.xml\": No such file or directory\n"));
}

TEST_CASE("validate: as JSON, with the place of each finding") {
    MemoryFiles files = three_files();
    const Ran ran = run_words(files, {"validate", "b.xml", "a.xml", "--format", "json"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "");
    const auto report = nlohmann::json::parse(ran.out);
    CHECK(report["ok"] == false);
    CHECK(report["files"][0]["diagnostics"].size() == 2);
    CHECK(report["files"][0]["diagnostics"][0] == nlohmann::json::parse(R"({
        "file": "b.xml", "line": 3, "column": 6, "severity": "error", "id": "unknown-node",
        "message": "unknown node \"Sequenc\"; did you mean \"Sequence\"?"})"));
    CHECK(report["files"][1] == nlohmann::json::parse(R"({
        "file": "a.xml", "ok": true, "kind": "tree", "nodes": 1, "declared": [],
        "diagnostics": []})"));
}
