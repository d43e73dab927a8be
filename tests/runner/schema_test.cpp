// trellis schema: the same bytes as the files in schemas/.
// SPDX-License-Identifier: MIT
#include "runner/command.h"
#include "support/files.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("schema: what is printed is what is checked in") {
    MemoryFiles files;
    for (const std::pair<const char*, const char*>& schema :
         {std::pair{"tree-xsd", "schemas/trellis_tree.xsd"},
          {"machine-xsd", "schemas/trellis_machine.xsd"},
          {"tree-json", "schemas/trellis_tree.schema.json"},
          {"machine-json", "schemas/trellis_machine.schema.json"},
          {"sweep-json", "schemas/trellis_sweep.schema.json"},
          {"world-json", "schemas/trellis_world.schema.json"}}) {
        INFO(std::string(schema.first));
        const Ran ran = run_words(files, {"schema", schema.first});
        CHECK(ran.exit == Exit::yes);
        CHECK((ran.out == read_file(from_root(schema.second))));
    }
}

TEST_CASE("schema: an unknown name") {
    MemoryFiles files;
    const Ran ran = run_words(files, {"schema", "tree-xs"});
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: there is no schema \"tree-xs\"; did you mean \"tree-xsd\"?\n");
}
