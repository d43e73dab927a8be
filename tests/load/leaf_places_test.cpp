// Which leaves share the bytes of a state, and which prototypes are kept. That no leaf disturbs
// another one is shown by every comparison with recorded runs and with the reference interpreter.
// SPDX-License-Identifier: MIT
#include "core/state.h"
#include "support/loading.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace trellis::test {
namespace {

struct Nothing {};

/// Eight bytes, like Wide; Flag has one, and answers at once.
struct Counter {
    std::int32_t until = 3, count = 0;
    Status tick(Nothing&, const Tick&) const { return Status::running; }
};
struct Wide {
    double speed = 0.5;
    Status tick(Nothing&, const Tick&) const { return Status::running; }
};
struct Stoppable {
    double speed = 0.5;
    Status tick(Nothing&, const Tick&) const { return Status::running; }
    void halt(Nothing&) const {}
};
struct Flag {
    bool value = true;
    bool tick(Nothing&, const Tick&) const { return value; }
};

const Registry& leaves() {
    static Registry registry;
    if (registry.leaves().empty()) {
        registry.add<Counter, Nothing>("Counter", "counts")
            .input("until", &Counter::until)
            .state(&Counter::count);
        registry.add<Wide, Nothing>("Wide", "drives").input("speed", &Wide::speed, "m/s");
        registry.add<Stoppable, Nothing>("Stoppable", "drives").input("speed", &Stoppable::speed);
        registry.add<Flag, Nothing>("Flag", "holds").input("value", &Flag::value);
    }
    return registry;
}

Program tree(const std::string& root) {
    return loaded("<root BTCPP_format='4'><BehaviorTree ID='T'>" + root + "</BehaviorTree></root>",
                  {}, leaves());
}

std::vector<std::uint32_t> places(const Program& program) {
    std::vector<std::uint32_t> out;
    for (const LeafCall& call : program.calls) {
        out.push_back(call.offset);
    }
    return out;
}

}  // namespace

TEST_CASE("leaf places: leaves that take turns share their bytes") {
    const Program program =
        tree("<Sequence><Wide/><Fallback><Counter/><Wide/></Fallback><Counter/></Sequence>");
    CHECK(places(program) == std::vector<std::uint32_t>{0, 0, 0, 0});
    CHECK(program.leaf_bytes == 8);
    CHECK(fresh_state(program).leaves.size() == 8);
}

TEST_CASE("leaf places: leaves that may run at the same time do not") {
    CHECK(places(tree("<Parallel><Wide/><Sequence><Wide/><Wide/></Sequence><Wide/></Parallel>")) ==
          std::vector<std::uint32_t>{0, 8, 8, 16});
    CHECK(places(tree("<ReactiveSequence><Counter/><Wide/></ReactiveSequence>")) ==
          std::vector<std::uint32_t>{0, 8});
    // what takes turns with a Parallel begins where that begins
    const Program program = tree("<Sequence><Parallel><Wide/><Wide/><Wide/></Parallel>"
                                 "<Parallel><Wide/><Wide/></Parallel></Sequence>");
    CHECK(places(program) == std::vector<std::uint32_t>{0, 8, 16, 0, 8});
    CHECK(program.leaf_bytes == 24);
}

TEST_CASE("leaf places: a leaf that answers at once disturbs none that runs") {
    const Program program =
        tree("<ReactiveSequence><Flag/><Flag value='false'/><Wide/></ReactiveSequence>");
    CHECK(places(program) == std::vector<std::uint32_t>{0, 0, 8});
    CHECK(program.leaf_bytes == 16);
}

TEST_CASE("leaf places: a leaf that may be halted late, or come back, has bytes of its own") {
    CHECK(places(tree("<Sequence><Wide/><Stoppable/><Stoppable/><Wide/></Sequence>")) ==
          std::vector<std::uint32_t>{16, 0, 8, 16});
    CHECK(places(tree("<Sequence><Wide/><LoopInt queue='1;2'><Wide/></LoopInt></Sequence>")) ==
          std::vector<std::uint32_t>{8, 0});
}

TEST_CASE("leaf places: structs that are alike on entry are kept once") {
    const Program program =
        tree("<Sequence><Wide/><Wide speed='2'/><Wide/><Counter/><Wide speed='2'/></Sequence>");
    const std::vector<LeafCall>& calls = program.calls;
    CHECK(calls[0].prototype == calls[2].prototype);
    CHECK(calls[1].prototype == calls[4].prototype);
    CHECK(calls[0].prototype != calls[1].prototype);
    CHECK(program.prototypes.size() == 24);
}

}  // namespace trellis::test
