// The schemas that are checked in are those that the grammar and the Roomba's leaves give today.
// TRELLIS_UPDATE_GOLDENS=1 writes them.
// SPDX-License-Identifier: MIT
#include "load/grammar.h"
#include "load/schema_json.h"
#include "load/schema_xsd.h"
#include "sim/bridge/leaves.h"
#include "sim/bridge/world_grammar.h"
#include "support/goldens.h"

#include <doctest/doctest.h>

#include <string>

using namespace trellis;

TEST_CASE("schemas: the files in schemas/ are fresh") {
    Registry registry;
    register_roomba(registry);
    const auto check = [](const std::string& name, const std::string& text) {
        CAPTURE(name);
        const auto recorded = test::golden("../../schemas/" + name, text);
        if (recorded) { CHECK(*recorded == text); }
    };
    check("trellis_tree.xsd", xsd(tree_grammar(registry)));
    check("trellis_machine.xsd", xsd(machine_grammar()));
    check("trellis_tree.schema.json", json_schema(tree_grammar(registry)));
    check("trellis_machine.schema.json", json_schema(machine_grammar()));
    check("trellis_world.schema.json", file_schema(world_grammar()));
}
