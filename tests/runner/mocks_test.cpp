// Leaves that answer as they are told: counted for each place, by ID or by name.
// SPDX-License-Identifier: MIT
#include "runner/mocks.h"

#include "exec/step.h"
#include "runner/command.h"
#include "runner/declarations.h"

#include <doctest/doctest.h>

#include <sstream>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const declared_tree = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Sequence><Grasp name="a" force="{f}"/><Holds/><Grasp name="b"/></Sequence>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="Grasp"><input_port name="force" type="double"/></Action>
    <Condition ID="Holds"/>
  </TreeNodesModel>
</root>
)";

}  // namespace

TEST_CASE("mocks: letters one after the other, each place for itself") {
    RoombaRegistry registry;
    MemoryFiles files;
    files.content["a.xml"] = declared_tree;
    std::istringstream in;
    std::ostringstream out;
    Streams streams{in, out, out, files};
    Exit exit = Exit::yes;
    auto behaviour = read_declaring("a.xml", {}, registry, streams, exit);
    REQUIRE(behaviour);
    REQUIRE(behaviour->program);
    Mocks mocks(std::move(*behaviour->program), false);
    CHECK(mocks.untold() == std::vector<std::string>{"Grasp", "Holds"});
    CHECK(mocks.tell("Grasp", "RS") == "");
    CHECK(mocks.tell("b", "K") == "");
    CHECK(mocks.tell("Holds", "R") == "Holds answers at once: it cannot return R");
    CHECK(mocks.tell("Holds", "S") == "");
    CHECK(mocks.untold().empty());
    State state = fresh_state(mocks.program());
    MockCalls calls = mocks.no_calls();
    const auto tick = [&] {
        Mocks::Host host{{}, &mocks, &calls, &state.last_leaf};
        return step(mocks.program(), state, host.robot);
    };
    CHECK(tick() == Status::running);
    CHECK(tick() == Status::success);
    CHECK(calls == MockCalls{0, 0, 2, 1, 1});
    CHECK(tick() == Status::running);
}
