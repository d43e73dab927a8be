// Rows and transitions to elements.
// SPDX-License-Identifier: MIT
#include "runner/places.h"

#include "runner/behaviour.h"
#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("places: rows and transitions, as XML and as JSON") {
    const RoombaRegistry registry;
    MemoryFiles files;
    files.content["a.scxml"] = two_states;
    REQUIRE(run_words(files, {"convert", "a.scxml", "a.json"}).exit == Exit::yes);
    for (const auto& file : files.content) {
        const std::string& name = file.first;
        const std::string& text = file.second;
        CAPTURE(name);
        Diagnostics diagnostics;
        const auto program = load({name, text}, registry, diagnostics);
        const auto document = read({name, text}, diagnostics);
        REQUIRE(program);
        const Places places(*program, *document);
        CHECK(document->value(places.of(RowId{1}), "id") == "go");
        CHECK(document->value(places.of(RowId{4}), "id") == "done");
        const StateInfo& state = program->state({1});
        REQUIRE(state.transition_count == 1);
        CHECK(document->value(places.of(TransitionId{state.first_transition}), "target") == "done");
        CHECK_FALSE(places.of(program->state({0}).initial));
    }
}
