// What a behaviour can be doing: leaves, subtrees, atomic states.
// SPDX-License-Identifier: MIT
#include "runner/labels.h"

#include "runner/behaviour.h"
#include "runner/command.h"
#include "runner/disk_files.h"
#include "sim/bridge/episode.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

namespace {

const RoombaRegistry registry;

Program compiled(const std::string& text) {
    Diagnostics diagnostics;
    std::optional<Program> program = load({"test", text}, registry, diagnostics);
    REQUIRE_MESSAGE(program, diagnostics.render());
    return std::move(*program);
}

Program from_disk(const std::string& file) {
    std::string why;
    DiskFiles disk;
    return compiled(*disk.read(from_root(file), std::string::npos, why));
}

}  // namespace

TEST_CASE("labels: those of a run are what leaf_label() says, tick for tick") {
    for (const std::string file : {"trees/roomba.xml", "trees/roomba_primitives.xml",
                                   "machines/roomba.scxml", "machines/roomba_leaves.scxml"}) {
        INFO(file);
        const Program program = from_disk(file);
        const Labels labels(program);
        EpisodeSetup setup;
        setup.random = Random(3);
        Episode episode(program, setup);
        bool same = true;
        for (int i = 0; i < 4000; ++i) {
            const LabelId label = labels.of(labels.row(episode.state()));
            const std::string name = label ? labels.names()[label.index] : "-";
            same = same && name == episode.row().leaf;
            episode.tick();
        }
        CHECK(same);
        CHECK(labels.names() ==
              std::vector<std::string>{"MoveForward", "MoveInSpiral", "GoBack", "Rotate"});
    }
}

TEST_CASE("labels: equal names are one label, compound states are none") {
    const Program program = compiled(
        R"(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" datamodel="script">
             <state id="outer"><state id="inner"><transition event="tick" target="end"/></state>
             </state><final id="end"/></scxml>)");
    const Labels labels(program);
    CHECK(labels.names() == std::vector<std::string>{"inner", "end"});
    CHECK(labels.find("end") == LabelId{1});
    CHECK_FALSE(labels.find("outer"));

    const Program twice = compiled(
        R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence><GoBack/><GoBack/>
           <Bumped name="wall"/></Sequence></BehaviorTree></root>)");
    CHECK(Labels(twice).names() == std::vector<std::string>{"GoBack", "wall"});
}
