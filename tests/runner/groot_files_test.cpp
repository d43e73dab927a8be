// A file as Groot2 writes it: what an editor notes in it survives fmt and both ways of convert, and
// our palette is one that an editor can open.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const project = R"xml(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4"
      project_name="Cleaner"
      main_tree_to_execute="Main">
  <!-- ////////// -->
  <include ros_pkg="robot_trees" path="trees/escape.xml"/>
  <BehaviorTree ID="Main" editable="true" _description="cleans &amp; escapes&#10;twice" _fullpath="">
    <!-- the root -->
    <Sequence name="root" _uid="1" _fullpath="root">
      <Script code="speed := 0.5; note := 'a &lt; b'" name="init" _uid="2"/>
      <MoveForward name="forward &quot;fast&quot;" speed="{speed}" _uid="3"
                   _onSuccess="speed += 0.1"/>
      <Action ID="Grasp" station="{=}" name="grasp" _uid="4"/>
      <SubTree ID="Escape" name="esc" _autoremap="true" back="{speed}" _uid="5"/>
    </Sequence>
  </BehaviorTree>
  <TreeNodesModel>
    <!-- takes what lies there -->
    <Action ID="Grasp" editable="true">
      <input_port name="station" type="std::string" default="home">where to</input_port>
      <output_port name="contact" type="bool"/>
      <MetadataFields>
        <Metadata author="Ada"/>
        <Metadata version="1.2"/>
      </MetadataFields>
    </Action>
    <Condition ID="IsCharged" editable="true"/>
    <Control ID="Recovery"><input_port name="tries" type="int">how often</input_port></Control>
    <Decorator ID="Rate"/>
    <SubTree ID="Escape" editable="true">
      <input_port name="back" default="0.1" type="double">how fast</input_port>
      <inout_port name="state"/>
    </SubTree>
  </TreeNodesModel>
</root>
)xml";

/// What must be in the file whatever was done to it, each on a line of its own.
const std::vector<std::string> kept = {
    R"(<root BTCPP_format="4" project_name="Cleaner" main_tree_to_execute="Main">)",
    R"(<!-- ////////// -->)",
    R"(<include ros_pkg="robot_trees" path="trees/escape.xml"/>)",
    R"(_description="cleans &amp; escapes&#10;twice")",
    R"(_fullpath="">)",
    R"(<!-- the root -->)",
    R"(<Sequence name="root" _uid="1" _fullpath="root">)",
    R"(<Script code="speed := 0.5; note := 'a &lt; b'" name="init" _uid="2"/>)",
    R"(<MoveForward name='forward "fast"' speed="{speed}" _uid="3" _onSuccess="speed += 0.1"/>)",
    R"(<Action ID="Grasp" station="{=}" name="grasp" _uid="4"/>)",
    R"(<SubTree ID="Escape" name="esc" _autoremap="true" back="{speed}" _uid="5"/>)",
    R"(<!-- takes what lies there -->)",
    R"(<Action ID="Grasp" editable="true">)",
    R"(<input_port name="station" type="std::string" default="home">where to</input_port>)",
    R"(<output_port name="contact" type="bool"/>)",
    R"(<Metadata author="Ada"/>)",
    R"(<Metadata version="1.2"/>)",
    R"(<Condition ID="IsCharged" editable="true"/>)",
    R"(<input_port name="tries" type="int">how often</input_port>)",
    R"(<Decorator ID="Rate"/>)",
    R"(<SubTree ID="Escape" editable="true">)",
    R"(<input_port name="back" default="0.1" type="double">how fast</input_port>)",
    R"(<inout_port name="state"/>)"};

void check_kept(const std::string& text) {
    for (const std::string& part : kept) {
        CHECK_MESSAGE(text.find(part) != std::string::npos, "missing: ", part, "\n", text);
    }
}

}  // namespace

TEST_CASE("groot files: fmt keeps what the editor wrote, and changes nothing a second time") {
    MemoryFiles files;
    files.content["p.xml"] = project;
    CHECK(run_words(files, {"fmt", "p.xml"}).exit == Exit::yes);
    const std::string once = files.content["p.xml"];
    check_kept(once);
    CHECK(run_words(files, {"fmt", "p.xml"}).exit == Exit::yes);
    CHECK(files.content["p.xml"] == once);
}

TEST_CASE("groot files: XML to JSON to XML is the file as fmt lays it out") {
    MemoryFiles files;
    files.content["p.xml"] = project;
    CHECK(run_words(files, {"convert", "p.xml", "p.json"}).exit == Exit::yes);
    CHECK(run_words(files, {"convert", "p.json", "back.xml"}).exit == Exit::yes);
    check_kept(files.content["back.xml"]);
    CHECK(run_words(files, {"fmt", "p.xml"}).exit == Exit::yes);
    CHECK(files.content["back.xml"] == files.content["p.xml"]);
}

TEST_CASE("groot files: its notes and models are no faults") {
    MemoryFiles files;
    files.content["p.xml"] = project;
    files.content["pkg/trees/escape.xml"] =
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Escape\"><Rotate rate=\"{back}\"/>"
        "</BehaviorTree></root>";
    const Ran ran = run_words(files, {"validate", "p.xml", "--ros-pkg", "robot_trees=pkg"});
    CHECK(ran.err == "");
    CHECK(ran.out == "p.xml: ok, 6 nodes; declared only: Grasp\n");
    const Ran without = run_words(files, {"validate", "p.xml"});
    CHECK(without.exit == Exit::no);
    CHECK(without.err.find("cannot read \"trees/escape.xml\"") != std::string::npos);
}

TEST_CASE("groot files: our palette has ports with types, defaults and descriptions") {
    MemoryFiles files;
    const std::string palette = run_words(files, {"nodes", "--xml"}).out;
    CHECK(palette.find("<!-- drive straight until a time has passed; fail on a bump -->\n"
                       "    <Action ID=\"MoveForward\">\n"
                       "      <input_port name=\"speed\" type=\"double\" default=\"0.5\">forwards, "
                       "in m/s</input_port>") != std::string::npos);
    files.content["palette.xml"] = palette;
    CHECK(run_words(files, {"fmt", "--check", "palette.xml"}).exit == Exit::yes);
}
