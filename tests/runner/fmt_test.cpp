// trellis fmt: stable, and nothing that Groot2 writes is lost.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const uneven = R"(<root   BTCPP_format="4" main_tree_to_execute='Main'>
<!-- drives -->
<BehaviorTree ID="Main" _fullpath="" editor_x="3"><MoveForward _uid="1"
   _description="first" name="go"/></BehaviorTree>
      <TreeNodesModel><Action ID="MoveForward" editable="true"/></TreeNodesModel></root>)";

const char* const even = R"(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4" main_tree_to_execute="Main">
  <!-- drives -->
  <BehaviorTree ID="Main" _fullpath="" editor_x="3">
    <MoveForward _uid="1" _description="first" name="go"/>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="MoveForward" editable="true"/>
  </TreeNodesModel>
</root>
)";

}  // namespace

TEST_CASE("fmt: lays a file out, once and for all") {
    MemoryFiles files;
    files.content["a.xml"] = uneven;
    CHECK(run_words(files, {"fmt", "a.xml"}).exit == Exit::yes);
    CHECK(files.content["a.xml"] == even);
    files.full = {"a.xml"};  // it is not even written again
    CHECK(run_words(files, {"fmt", "a.xml"}).exit == Exit::yes);
}

TEST_CASE("fmt: --check names the files that would change") {
    MemoryFiles files;
    files.content = {{"a.xml", uneven}, {"b.xml", even}, {"c.json", "{\"states\": []"}};
    Ran ran = run_words(files, {"fmt", "--check", "a.xml", "b.xml"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out == "a.xml\n");
    CHECK(files.content["a.xml"] == uneven);
    CHECK(run_words(files, {"fmt", "--check", "b.xml"}).exit == Exit::yes);
    CHECK(run_words(files, {"fmt", "c.json"}).exit == Exit::no);
    CHECK(run_words(files, {"fmt", "none.xml", "a.xml"}).exit == Exit::file);
    CHECK(files.content["a.xml"] == even);
}

TEST_CASE("fmt: from standard input to standard output, in its spelling") {
    MemoryFiles files;
    files.content["a.scxml"] = two_states;
    const Ran xml = run_words(files, {"fmt", "-"}, uneven);
    CHECK(xml.out == even);
    const std::string json = run_words(files, {"convert", "a.scxml", "-", "--to", "json"}).out;
    CHECK(run_words(files, {"fmt", "-"}, json).out == json);
}
