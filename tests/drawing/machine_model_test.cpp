// What a drawing of a machine shows, apart from its look.
// SPDX-License-Identifier: MIT
#include "runner/drawing/machine_model.h"

#include "drawing/samples.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::drawing;
using namespace trellis::test;

namespace {

MachineModel model_of(std::string_view xml) {
    return machine_model(document_of(xml));
}

}  // namespace

TEST_CASE("machine_model: executable content is said in a line") {
    const MachineModel model = model_of(R"(<scxml><state id="s"><onentry>
        <assign location="x" expr="1"/><raise event="e"/><log label="l" expr="x"/>
        <if cond="a"><raise event="b"/><elseif cond="c"/><cancel sendid="i"/><else/><script>y
        = 2</script></if><foreach item="i" array="xs"><raise event="f"/></foreach>
        <send event="g" target="#_parent" delay="2s"/></onentry><onexit/></state></scxml>)");
    REQUIRE(model.states.size() == 3);
    CHECK(model.states[2].lines ==
          std::vector<std::string>{"entry / x = 1; raise e; log l x; if a: raise b else if c: "
                                   "cancel i else y = 2; for each i in xs: raise f; "
                                   "send g to #_parent after 2s",
                                   "exit / "});
}

TEST_CASE("machine_model: invocations, and transitions without a target, are lines") {
    const MachineModel model = model_of(R"(<scxml><state id="s">
        <invoke type="leaf" src="Go"><param name="v" expr="1"/></invoke><invoke type="scxml"/>
        <transition event="e" cond="c"><raise event="f"/></transition>
        <transition event="g" target="nowhere"/></state></scxml>)");
    CHECK(model.states[2].lines == std::vector<std::string>{"do / Go", "v = 1", "do / scxml",
                                                            "e [c] / raise f", "g → nowhere"});
    CHECK(model.states[2].inside == std::vector<bool>{false, true, false, false, false});
    CHECK(model.transitions.size() == 1);  // of the dot
}

TEST_CASE("machine_model: a dot points where a state begins") {
    const MachineModel model = model_of(R"(<scxml initial="b"><state id="a"/><state id="b">
        <history id="h"/><state id="c"/><state id="d"/></state><state id="e">
        <initial><transition target="g"><raise event="x"/></transition></initial>
        <state id="f"/><state id="g"/></state><state><state/></state></scxml>)");
    std::vector<std::string> targets;
    for (const DrawnTransition& t : model.transitions)
        targets.push_back(model.states[t.target.index].id + words_of(t));
    CHECK(targets == std::vector<std::string>{"b", "c", "g/ raise x", ""});
}

TEST_CASE("machine_model: several targets are several arrows, said once") {
    const MachineModel model =
        model_of(R"(<scxml><state id="a"><transition event="e" target="b  c"/>
        </state><parallel id="p"><state id="b"/><state id="c"/></parallel></scxml>)");
    REQUIRE(model.transitions.size() == 3);
    CHECK(words_of(model.transitions[1]) == "e");
    CHECK(words_of(model.transitions[2]).empty());
    CHECK(model.states[model.transitions[2].target.index].id == "c");
}

TEST_CASE("machine_model: a machine inside an invocation is not part of the picture") {
    const MachineModel model = model_of(R"(<scxml><state id="a"><invoke><content><scxml>
        <state id="inner"/></scxml></content></invoke></state></scxml>)");
    CHECK(model.states.size() == 3);
}
