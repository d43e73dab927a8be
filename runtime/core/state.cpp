// Making and comparing states.
// SPDX-License-Identifier: MIT
#include "core/state.h"

#include "core/running_leaves.h"

#include <algorithm>
#include <cstring>

namespace trellis {

namespace {

/// Events not yet taken are what counts of a queue.
bool same_queue(const std::vector<Event>& a, std::uint32_t a_next, const std::vector<Event>& b,
                std::uint32_t b_next) {
    return std::equal(a.begin() + a_next, a.end(), b.begin() + b_next, b.end());
}

}  // namespace

State fresh_state(const Program& program) {
    State state;
    state.status.assign(program.rows.size(), Status::idle);
    state.memory.assign(program.rows.size(), 0);
    for (const Slot& slot : program.slots) {
        state.slots.push_back(slot.initial);
        state.entries.push_back(slot.type);
    }
    state.words.assign(program.words, 0);
    state.queues.resize(program.queues);
    if (program.counts_writes) {
        // a value that is there from the beginning was written once
        for (const Slot& slot : program.slots) {
            state.writes.push_back(slot.initial.is(Value::Kind::undefined) ? 0 : 1);
        }
    }
    state.temporaries.resize(program.code.temporaries);
    state.inputs.resize(program.live_inputs.size());
    state.leaves.resize(program.leaf_bytes);
    if (program.is_machine()) { state.work.marks.resize(program.rows.size()); }
    state.work.loops.resize(program.loops.size());
    state.session.histories.resize(program.histories.size());
    return state;
}

namespace {

bool same(const Session& s, const Session& t) {
    return s.id == t.id && s.active == t.active && s.pending == t.pending &&
           s.invokes == t.invokes && s.histories == t.histories &&
           same_queue(s.internal, s.internal_next, t.internal, t.internal_next) &&
           same_queue(s.external, s.external_next, t.external, t.external_next) &&
           s.delayed == t.delayed && s.made_ids == t.made_ids && s.sessions == t.sessions &&
           s.clock == t.clock && s.final == t.final;
}

bool same(const Program& outermost, const Program& program, const State& a, const State& b) {
    bool members = a.status == b.status;
    if (members) {
        for_each_member(program, a.status, [&](std::size_t at, std::size_t size) {
            members = members && std::memcmp(&a.leaves[at], &b.leaves[at], size) == 0;
        });
    }
    return members && a.tick == b.tick && a.started == b.started && a.woken == b.woken &&
           a.last_leaf == b.last_leaf && a.memory == b.memory && a.slots == b.slots &&
           a.entries == b.entries && a.words == b.words && a.queues == b.queues &&
           a.writes == b.writes && a.random == b.random && same(a.session, b.session) &&
           a.fault == b.fault &&
           std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(),
                      [&](const Child& c, const Child& d) {
                          return c.invoke == d.invoke && c.machine == d.machine &&
                                 same(outermost, program_of(outermost, c), c.state, d.state);
                      });
}

}  // namespace

bool same(const Program& program, const State& a, const State& b) {
    return same(program, program, a, b);
}

}  // namespace trellis
