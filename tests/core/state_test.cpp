// States as values: fresh ones, comparison and hashes that agree, bytes and what is refused.
// SPDX-License-Identifier: MIT
#include "core/state.h"

#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace trellis::test {
namespace {

Program sample() {
    return loaded("<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence><Script code='n := 1'/>"
                  "<Leaf script='R'/></Sequence></BehaviorTree></root>");
}

Value object(std::initializer_list<const char*> keys) {
    Value out = Value::object();
    for (const char* key : keys) {
        out.set_member(key, Value::text(key));
    }
    return out;
}

}  // namespace

TEST_CASE("state: a fresh one is idle everywhere and holds the initial values") {
    const Program program = sample();
    const State state = fresh_state(program);
    CHECK(state.tick == 0);
    CHECK(state.status == std::vector<Status>(4, Status::idle));
    CHECK(state.slots == std::vector<Value>(1));
    CHECK_FALSE(state.fault);
    CHECK_FALSE(state.last_leaf);
}

TEST_CASE("state: any difference that matters shows in same() and in the hash") {
    const Program program = sample();
    ScriptRun run(program);
    run.step();
    const State& before = run.state;
    const auto differs = [&](auto change) {
        State other = before;
        change(other);
        CHECK_FALSE(same(program, before, other));
        CHECK(hash(program, before) != hash(program, other));
    };
    differs([](State& s) { ++s.tick; });
    differs([](State& s) { s.status[1] = Status::success; });
    differs([](State& s) { ++s.memory[1]; });
    differs([](State& s) { s.slots[0].set_integer(2); });
    differs([](State& s) { s.entries[0] = EntryType::text; });
    differs([](State& s) { s.woken = true; });
    differs([](State& s) { s.random = Random(std::int64_t{1}); });
    differs([](State& s) { s.session.clock = 3; });
    differs([](State& s) { s.fault.kind = Fault::Kind::budget; });
    State other = before;
    other.inputs[0].set_text("scratch");
    CHECK(same(program, before, other));
    CHECK(hash(program, before) == hash(program, other));
}

TEST_CASE("state: members of objects may come in any order") {
    const Program program = sample();
    State a = fresh_state(program);
    State b = a;
    a.slots[0] = object({"x", "y"});
    b.slots[0] = object({"y", "x"});
    CHECK(same(program, a, b));
    CHECK(hash(program, a) == hash(program, b));
}

TEST_CASE("state: bytes of another program, cut off or with too many are refused") {
    const Program program = sample();
    const std::vector<std::byte> bytes = save(program, fresh_state(program));
    CHECK(restore(program, bytes).has_value());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        CHECK_FALSE(restore(program, std::span(bytes).first(size)).has_value());
    }
    std::vector<std::byte> more = bytes;
    more.push_back(std::byte{0});
    CHECK_FALSE(restore(program, more).has_value());
}

TEST_CASE("state: numbers that the program does not have are refused") {
    const Program program = sample();
    State state = fresh_state(program);
    state.last_leaf = {4};
    CHECK_FALSE(restore(program, save(program, state)).has_value());
    state = fresh_state(program);
    state.memory[1] = 9;
    CHECK_FALSE(restore(program, save(program, state)).has_value());
    state = fresh_state(program);
    state.session.external.push_back({.name = {7}});
    CHECK_FALSE(restore(program, save(program, state)).has_value());
}

}  // namespace trellis::test
