// Machines as nodes of trees: status, values both ways, halting, nesting, saving, comparing with
// the machine alone.
// SPDX-License-Identifier: MIT
#include "exec/step.h"
#include "sim/bridge/episode.h"
#include "sim/bridge/leaves.h"
#include "support/behaviours.h"
#include "support/disk.h"
#include "support/machine_story.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {
namespace {

/// Ends with "b" after two ticks unless `again` is true; `seen` counts them.
constexpr std::string_view two_ticks = R"xml(
    <datamodel><data id="seen" expr="0"/><data id="again" expr="false"/></datamodel>
    <state id="a">
      <transition event="tick" cond="seen == 2 &amp;&amp; !again" target="b"/>
      <transition event="tick"><assign location="seen" expr="seen + 1"/></transition>
      <onexit><log label="bye"/></onexit>
    </state>
    <final id="b"/>)xml";

std::string tree_of(std::string_view nodes) {
    return "<root BTCPP_format='4'><BehaviorTree ID='T'>" + std::string(nodes) +
           "</BehaviorTree></root>";
}

/// A tree whose nodes run machines of the files "m.xml" and "n.xml", and their story.
struct Tree {
    Texts texts;
    Program program;
    ScriptRun run;
    Story story;

    explicit Tree(std::string_view nodes, std::string_view m = two_ticks, std::string_view n = {})
        : texts(files(m, n)), program(loaded(tree_of(nodes), {.reader = &texts})), run(program),
          story(program) {}

    /// Status and story of a tick.
    std::string tick() {
        const std::string status(name_of(run.step({.dt = 1.0, .trace = &story})));
        const std::string told = story.take();
        return told.empty() ? status : status + ' ' + told;
    }
    std::string entry(std::string_view name) const {
        for (std::size_t i = 0; i < program.slots.size(); ++i) {
            if (program.slots[i].name == name) { return print(run.state.slots[i]); }
        }
        return "-";
    }

    static Texts files(std::string_view m, std::string_view n) {
        Texts all;
        all.add("m.xml", machine_file(m));
        if (!n.empty()) { all.add("n.xml", machine_file(n)); }
        return all;
    }
};

std::string faults(std::string_view nodes, std::string_view m = two_ticks) {
    Texts texts = Tree::files(m, {});
    return complaints(tree_of(nodes), {.reader = &texts});
}

}  // namespace

TEST_CASE("machine node: it runs until its machine ends, and begins anew after that") {
    Tree t("<Machine src='m.xml'/>");
    for (int i = 0; i < 2; ++i) {
        CHECK(t.tick() == "RUNNING +a");
        CHECK(t.tick() == "RUNNING");
        CHECK(t.tick() == "SUCCESS (bye) -a +b -b");
        CHECK(t.run.state.children.empty());
    }
}

TEST_CASE("machine node: the final state or the status of its donedata decides") {
    const auto ends = [](std::string_view final) {
        Tree t("<Machine src='m.xml'/>", final);
        const std::string status = t.tick();
        return t.run.state.fault ? describe_fault(t.program, t.run.state) : status;
    };
    CHECK(ends("<final id='success'/>") == "SUCCESS +success -success");
    CHECK(ends("<final id='failure'/>") == "FAILURE +failure -failure");
    CHECK(ends("<final id='x'><donedata><param name='status' expr=\"'failure'\"/></donedata>"
               "</final>") == "FAILURE +x -x");
    CHECK(ends("<final id='failure'><donedata><content expr=\"{'status': 'success'}\"/></donedata>"
               "</final>") == "SUCCESS +failure -failure");
    CHECK(ends("<final id='failure'><donedata><content expr='3'/></donedata></final>") ==
          "FAILURE +failure -failure");
    CHECK(ends("<final id='x'><donedata><param name='status' expr='7'/></donedata></final>") ==
          "test:1:46: error: Machine: in its machine: x: the status of a machine is \"success\" or "
          "\"failure\", not 7.0 (tick 1)");
}

TEST_CASE("machine node: literals and entries are its variables, entries are shared") {
    Tree t("<Sequence><Script code='n := 1'/>"
           "<Machine src='m.xml' seen='{n}' again='{more}'/><Script code='after := n'/>"
           "</Sequence>");
    CHECK(t.tick() == "RUNNING +a");
    CHECK(t.entry("n") == "2.0");
    CHECK(t.entry("more") == "false");
    // what the tree writes while the machine runs, it reads
    for (std::size_t i = 0; i < t.program.slots.size(); ++i) {
        if (t.program.slots[i].name == "n") { t.run.state.slots[i] = Value::integer(0); }
    }
    CHECK(t.tick() == "RUNNING");
    CHECK(t.entry("n") == "1.0");
    CHECK(t.tick() == "RUNNING");
    CHECK(t.tick() == "SUCCESS (bye) -a +b -b");
    CHECK(t.entry("after") == "2.0");

    Tree literal("<Machine src='m.xml' seen='2'/>");
    CHECK(literal.tick() == "SUCCESS +a (bye) -a +b -b");
}

TEST_CASE("machine node: halting it leaves its states, and its messages are dropped") {
    Tree t("<ReactiveSequence><Cond id='c' script='SSF'/><Machine src='m.xml' again='true'/>"
           "</ReactiveSequence>",
           "<datamodel><data id='again' expr='false'/></datamodel><state id='a'><onexit>"
           "<log label='bye'/><send event='x' target='#_parent'/></onexit></state>");
    CHECK(t.tick() == "RUNNING +a");
    CHECK(t.tick() == "RUNNING");
    CHECK(t.tick() == "FAILURE (bye) -a");
    CHECK(t.run.state.children.empty());
    CHECK(t.tick() == "RUNNING +a");
    t.run.halt();
    CHECK(t.run.state.children.empty());
}

TEST_CASE("machine node: a machine in a tree has no parent to send to") {
    Tree t("<Machine src='m.xml'/>",
           "<state id='a'><onentry><send event='x' target='#_parent'/></onentry>"
           "<transition event='error.communication' target='failure'/></state>"
           "<final id='failure'/>");
    CHECK(t.tick() == "FAILURE +a ! -a +failure -failure");
}

TEST_CASE("machine node: machines, trees in them and machines in those keep to themselves") {
    // m runs a tree that runs n, and a machine beside it
    Texts texts;
    texts.add("m.xml",
              machine_file("<state id='a'><invoke type='tree' src='t.xml'/>"
                           "<invoke id='k'><content><scxml version='1.0'><state id='c'>"
                           "<transition event='hi' target='d'/></state><final id='d'/>"
                           "</scxml></content></invoke>"
                           "<transition event='done.invoke.a.1.success' target='b'/>"
                           "<transition event='done.invoke.k'><log label='k'/></transition>"
                           "<transition event='tick' cond='elapsed() == 1'><send "
                           "event='hi' target='#_k'/></transition></state>"
                           "<final id='b'/>"));
    texts.add("n.xml", machine_file(two_ticks));
    texts.add("t.xml", tree_of("<Machine src='n.xml'/>"));
    const Program program = loaded(tree_of("<Machine src='m.xml'/>"), {.reader = &texts});
    ScriptRun run(program);
    Story story(program);
    std::string told;
    Status status = Status::running;
    for (int i = 0; i < 8 && status == Status::running; ++i) {
        status = run.step({.dt = 1.0, .trace = &story});
        told += story.take() + '|';
        // at every tick: what is saved and read again goes on in the same way
        const std::optional<State> again = restore(program, save(program, run.state));
        REQUIRE(again);
        REQUIRE(same(program, run.state, *again));
        run.state = *again;
    }
    CHECK(told == "+a +c +a|-c +d -d (k)|(bye) -a +b -b|-a +b -b|");
    CHECK(status == Status::success);
}

TEST_CASE("machine node: machines without end inside each other are a fault, not a crash") {
    Texts texts;
    texts.add("m.xml", machine_file("<state id='a'><invoke type='tree' src='t.xml'/></state>"));
    texts.add("t.xml", tree_of("<Machine src='m.xml'/>"));
    const Program program = loaded(tree_of("<Machine src='m.xml'/>"), {.reader = &texts});
    ScriptRun run(program);
    CHECK(run.step() == Status::idle);
    CHECK(describe_fault(program, run.state).find("machines invoke each other 64 deep") !=
          std::string::npos);
}

TEST_CASE("machine node: faults are found when the file is loaded") {
    CHECK(faults("<Machine src='no.xml'/>") == "1:59: unreadable-file: cannot read \"no.xml\"\n");
    CHECK(faults("<Machine/>") == "1:46: missing-attribute: Machine needs the attribute \"src\"\n");
    CHECK(faults("<Machine src='m.xml' sen='1'/>") ==
          "1:66: unknown-port: this machine has no variable \"sen\"; did you mean \"seen\"?\n");
    CHECK(faults("<Machine src='m.xml'><AlwaysSuccess/></Machine>") ==
          "1:67: child-count: Machine takes no children, found 1\n");
    CHECK(faults("<Machine src='m.xml'/>", "<state id='a'><transition target='x'/></state>") ==
          "1:125: unknown-state: there is no state \"x\"\n");
}

TEST_CASE("machine node: the lab's machine in a tree drives as it does alone") {
    Registry registry;
    register_roomba(registry);
    Disk disk;
    Diagnostics diagnostics;
    const std::string name = std::string(TRELLIS_SOURCE_DIR) + "/machines/t.xml";
    const std::optional<Program> node = load({name, tree_of("<Machine src='roomba.scxml'/>")},
                                             registry, diagnostics, {.reader = &disk});
    REQUIRE(node);
    const Program alone = program_of("machines/roomba.scxml", registry);
    Episode inside(*node, {.random = Random(4)});
    Episode outside(alone, {.random = Random(4)});
    for (int i = 0; i < 20'000; ++i) {
        REQUIRE(inside.tick());
        REQUIRE(outside.tick());
        REQUIRE(inside.robot() == outside.robot());
    }
}

}  // namespace trellis::test
