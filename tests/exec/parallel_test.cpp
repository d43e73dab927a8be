// Parallel states, histories, conflicts and done events, one behaviour per case. Section numbers
// are those of the SCXML Recommendation.
// SPDX-License-Identifier: MIT
#include "support/machine_story.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace trellis::test {
namespace {

constexpr std::string_view two_regions =
    "<parallel id='p'><transition event='again' target='p'/>"
    "<state id='a'><state id='a1'><transition event='e' target='a2'/><transition event='self' "
    "target='a'/></state><state id='a2'><transition event='out' target='x'/></state></state>"
    "<state id='b'><state id='b1'><transition event='e' target='b2'/></state>"
    "<state id='b2'><transition event='out' target='y'/></state></state></parallel>"
    "<state id='x'/><state id='y'/>";

}  // namespace

TEST_CASE("parallel: all regions are entered, each with its default (3.4)") {
    CHECK(Machine(two_regions).start() == "+p +a +a1 +b +b1");
}

TEST_CASE("parallel: an event is answered in every region, in three phases over all (3.13)") {
    Machine m("<parallel id='p'><state id='a'><state id='a1'><onexit><log label='out a'/></onexit>"
              "<transition event='e' target='a2'><log label='do a'/></transition></state>"
              "<state id='a2'/></state><state id='b'><state id='b1'><onexit><log label='out b'/>"
              "</onexit><transition event='e' target='b2'><log label='do b'/></transition></state>"
              "<state id='b2'/></state></parallel>");
    m.start();
    CHECK(m.step({"e"}) == "(out b) -b1 (out a) -a1 (do a) (do b) +a2 +b2");
}

TEST_CASE("parallel: of two transitions that leave the same, the earlier region's is taken") {
    Machine m(two_regions);
    m.start();
    m.step({"e"});
    CHECK(m.step({"out"}) == "-b2 -b -a2 -a -p +x");
}

TEST_CASE("parallel: a transition from a region to itself leaves all regions (LCCA)") {
    Machine m(two_regions);
    m.start();
    CHECK(m.step({"self"}) == "-b1 -b -a1 -a -p +p +a +a1 +b +b1");
}

TEST_CASE("parallel: targets deep in regions keep the other regions from their defaults") {
    Machine m("<state id='s'><transition event='e' target='b2 a2'/></state>" +
              std::string(two_regions));
    m.start();
    CHECK(m.step({"e"}) == "-s +p +a +a2 +b +b2");
}

TEST_CASE("parallel: internal is external when the source is a parallel state (3.5)") {
    Machine m("<parallel id='p'><transition event='e' type='internal' target='a'/><state id='a'/>"
              "<state id='b'/></parallel>");
    m.start();
    CHECK(m.step({"e"}) == "-b -a -p +p +a +b");
}

TEST_CASE("parallel: is done when all its regions are, and so are those around it (3.4)") {
    Machine m("<parallel id='p'><transition event='done.state.p'><log label='all'/></transition>"
              "<parallel id='q'><transition event='done.state.q'><log label='both'/></transition>"
              "<state id='a'><state id='a1'><transition event='x' target='a2'/></state>"
              "<final id='a2'/></state><state id='b'><state id='b1'><transition event='y' "
              "target='b2'/></state><final id='b2'/></state></parallel><state id='c'>"
              "<state id='c1'><transition event='z' target='c2'/></state><final id='c2'/></state>"
              "</parallel>");
    m.start();
    CHECK(m.step({"z"}) == "-c1 +c2");
    CHECK(m.step({"x"}) == "-a1 +a2");
    CHECK(m.step({"y"}) == "-b1 +b2 (both) (all)");
}

TEST_CASE("history: shallow remembers the child, deep the innermost states (3.10)") {
    const std::string states =
        "<state id='s'><transition event='out' target='o'/><history id='h' type='TYPE'><transition "
        "target='a'><log label='first'/></transition></history><state id='a'/><state id='b'>"
        "<state id='b1'/><state id='b2'/></state></state><state id='o' ><transition event='back' "
        "target='h'/><transition event='b2' target='b2'/></state>";
    const auto with = [&](const char* type) {
        std::string text = states;
        return text.replace(text.find("TYPE"), 4, type);
    };
    Machine shallow(with("shallow"), "initial='o'");
    shallow.start();
    CHECK(shallow.step({"back"}) == "-o +s (first) +a");
    shallow.step({"out"});
    shallow.step({"b2"});
    shallow.step({"out"});
    CHECK(shallow.step({"back"}) == "-o +s +b +b1");
    Machine deep(with("deep"), "initial='o'");
    deep.start();
    deep.step({"b2"});
    deep.step({"out"});
    CHECK(deep.step({"back"}) == "-o +s +b +b2");
}

TEST_CASE("history: that stands first is not where a state begins") {
    CHECK(Machine("<state id='s'><history id='h'><transition target='b'/></history><state id='a'/>"
                  "<state id='b'/></state>")
              .start() == "+s +a");
}

TEST_CASE("history: of a parallel state brings back every region") {
    Machine m("<state id='o'><transition event='in' target='h'/></state><parallel id='p'>"
              "<history id='h' type='deep'><transition target='a b'/></history><transition "
              "event='out' target='o'/><state id='a'><state id='a1'><transition event='e' "
              "target='a2'/></state><state id='a2'/></state><state id='b'><state id='b1'>"
              "<transition event='f' target='b2'/></state><state id='b2'/></state></parallel>");
    m.start();
    CHECK(m.step({"in"}) == "-o +p +a +a1 +b +b1");
    m.step({"f", "out"});
    CHECK(m.step({"in"}) == "-o +p +a +a1 +b +b2");
}

TEST_CASE("donedata: is the data of the event, and an error comes before it (5.5)") {
    Machine m("<datamodel><data id='v'/></datamodel><state id='s'><transition event='error' "
              "><log label='error'/></transition><transition event='done.state.s'><log label='sum' "
              "expr='_event.data.sum'/></transition><state id='a'><transition event='e' "
              "target='f'/></state><final id='f'><donedata><param name='sum' expr='1 + 2'/><param "
              "name='bad' location='v.w'/></donedata></final></state>");
    m.start();
    CHECK(m.step({"e"}) == "-a +f ! (error) (sum: 3)");
}

TEST_CASE("parallel: ten thousand regions answer an event") {
    std::string regions;
    for (int i = 0; i < 10'000; ++i) {
        const std::string n = std::to_string(i);
        regions += "<state id='r" + n + "'><state id='a" + n + "'><transition event='e' target='b" +
                   n + "'/></state><state id='b" + n + "'><transition event='e' target='a" + n +
                   "'/></state></state>";
    }
    const Program program = loaded(machine_file("<parallel id='p'>" + regions + "</parallel>"));
    ScriptRun run(program);
    run.start();
    for (int i = 0; i < 5; ++i) {
        send(program, run.state, "e");
        run.step();
    }
    REQUIRE_FALSE(run.state.fault);
    CHECK(run.state.session.active.size() == 20'001);
    CHECK(program.name(run.state.session.active[2]) == "b0");
}

}  // namespace trellis::test
