// What a drawing of trees shows, apart from its look.
// SPDX-License-Identifier: MIT
#include "runner/drawing/tree_model.h"

#include "core/leaf.h"
#include "drawing/samples.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::drawing;
using namespace trellis::test;

namespace {

struct Always {
    bool tick(const Tick&) { return true; }
};

}  // namespace

TEST_CASE("tree_model: the registry, the palette and the long form tell conditions") {
    Registry registry;
    registry.add<Always, int>("Registered", "succeed");
    DrawingOptions options;
    options.registry = &registry;
    const TreeModel model = tree_model(document_of(R"(<root><BehaviorTree ID="T"><Mine>
        <Registered/><Listed/><Condition ID="Long"/><Other/><Wrap><Other/></Wrap></Mine></BehaviorTree>
        <TreeNodesModel><Condition ID="Listed"/></TreeNodesModel></root>)"),
                                       options);
    const std::vector expected{NodeShape::control,   NodeShape::condition, NodeShape::condition,
                               NodeShape::condition, NodeShape::action,    NodeShape::decorator,
                               NodeShape::action};
    REQUIRE(model.nodes.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(model.nodes[i].shape == expected[i]);
    CHECK(model.nodes[3].type == "Long");
}

TEST_CASE("tree_model: ports, tags and the code of a script are told apart") {
    const TreeModel model = tree_model(
        document_of(R"(<root><BehaviorTree><Script name="n" code="a  := 1" _skipIf="b" x="{y}"
                        _autoremap="1" _uid="4"/></BehaviorTree></root>)"),
        {});
    const DrawnNode& node = model.nodes.at(0);
    CHECK(node.name == "n");
    CHECK(node.code == "a := 1");
    CHECK(node.ports == std::vector<std::string>{"x = {y}", "_autoremap = 1"});
    CHECK(node.tags == std::vector<std::string>{"skip if b"});
}

TEST_CASE("tree_model: every tree opens once, the main tree first") {
    const TreeModel model = tree_model(sample("every_kind.xml"), {});
    REQUIRE(model.trees.size() == 2);
    CHECK(model.trees[0].id == "Main");
    CHECK(model.trees[1].id == "Unused");
    std::size_t opened = 0;
    for (const DrawnNode& node : model.nodes)
        opened += node.opened;
    CHECK(opened == 1);
    DrawingOptions options;
    options.main_tree = "Shared";
    CHECK(tree_model(sample("every_kind.xml"), options).trees[0].id == "Shared");
}

TEST_CASE("tree_model: trees that only use each other are drawn all the same") {
    const TreeModel model = tree_model(document_of(R"(<root>
        <BehaviorTree ID="A"><SubTree ID="B"/></BehaviorTree>
        <BehaviorTree ID="B"><SubTree ID="A"/></BehaviorTree></root>)"),
                                       {});
    REQUIRE(model.trees.size() == 1);
    CHECK(model.trees[0].id == "A");
    CHECK(model.nodes.size() == 2);
}
