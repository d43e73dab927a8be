// Making, comparing, hashing, saving and restoring states.
// SPDX-License-Identifier: MIT
#include "core/state.h"

#include "core/bytes.h"

#include <algorithm>
#include <cstring>

namespace trellis {

namespace {

/// Calls `visit(leaf struct offset, member)` for every registered state member of every leaf use.
template <class Visit>
void for_each_member(const Program& program, Visit visit) {
    for (const LeafCall& call : program.calls) {
        for (const StateMember& member : call.type->state) {
            visit(call.offset + member.offset, member.size);
        }
    }
}

template <class Tag>
void put(ByteWriter& out, Id<Tag> id) {
    out.put(id.index);
}
template <class Tag>
void get(ByteReader& in, Id<Tag>& id) {
    in.get(id.index);
}

void put(ByteWriter& out, const std::vector<Event>& events, std::uint32_t next) {
    out.put(static_cast<std::uint32_t>(events.size()) - next);
    for (std::size_t i = next; i < events.size(); ++i) {
        const Event& event = events[i];
        put(out, event.name);
        out.put(event.unknown);
        out.put(event.type);
        out.put(event.data);
        put(out, event.invoke);
        out.put(event.activation);
    }
}

void get(ByteReader& in, std::vector<Event>& events) {
    std::uint32_t count = 0;
    in.get(count);
    while (in.ok() && count-- != 0) {
        Event event;
        get(in, event.name);
        in.get(event.unknown);
        in.get(event.type);
        in.get(event.data);
        get(in, event.invoke);
        in.get(event.activation);
        events.push_back(std::move(event));
    }
}

void write(ByteWriter& out, const Program& program, const State& state) {
    out.put(state.tick);
    out.put(state.started);
    out.put(state.woken);
    put(out, state.last_leaf);
    for (const Status status : state.status) {
        out.put(status);
    }
    for (const std::uint32_t word : state.memory) {
        out.put(word);
    }
    for (const Value& value : state.slots) {
        out.put(value);
    }
    for (const EntryType type : state.entries) {
        out.put(type);
    }
    for (const std::uint64_t word : state.words) {
        out.put(word);
    }
    for (const Value& queue : state.queues) {
        out.put(queue);
    }
    for (const std::uint32_t writes : state.writes) {
        out.put(writes);
    }
    for_each_member(
        program, [&](std::size_t at, std::size_t size) { out.put_bytes(&state.leaves[at], size); });
    const std::vector<std::uint64_t> words = state.random.words();
    out.put(static_cast<std::uint32_t>(words.size()));
    for (const std::uint64_t word : words) {
        out.put(word);
    }
    const Session& session = state.session;
    put(out, session.atom);
    out.put(static_cast<std::uint32_t>(session.invokes.size()));
    for (const RowId n : session.invokes) {
        put(out, n);
    }
    put(out, session.internal, session.internal_next);
    put(out, session.external, session.external_next);
    out.put(session.clock);
    put(out, session.final);
    out.put(state.fault.kind);
    put(out, state.fault.row);
    out.put(Value::text(state.fault.message));
}

/// Whether every number in a restored state names something of the program.
bool is_possible(const Program& program, const State& state) {
    const auto row = [&](RowId n) { return !n || n.index < program.rows.size(); };
    const auto state_row = [&](RowId n) {
        return !n || (row(n) && op_table()[program.at(n).op].group == OpGroup::state);
    };
    const auto invoke_row = [&](RowId n) { return row(n) && n && program.at(n).op == Op::invoke; };
    const auto event = [&](const Event& e) {
        return e.name.index < program.events.size() && e.type <= Event::Type::platform &&
               (!e.invoke || invoke_row(e.invoke));
    };
    // what a control remembers is one of its children
    for (std::uint32_t i = 0; i < program.rows.size(); ++i) {
        if (op_table()[program.rows[i].op].group != OpGroup::control) { continue; }
        const RowId child{state.memory[i] & 0x3FFFFFFF};
        if (child.index != 0 && (!row(child) || program.at(child).parent != RowId{i})) {
            return false;
        }
    }
    const Session& session = state.session;
    return std::all_of(state.status.begin(), state.status.end(),
                       [](Status s) { return s <= Status::skipped; }) &&
           std::all_of(state.entries.begin(), state.entries.end(),
                       [](EntryType t) { return t <= EntryType::text; }) &&
           std::all_of(state.queues.begin(), state.queues.end(),
                       [](const Value& queue) {
                           return queue.is(Value::Kind::undefined) || queue.is(Value::Kind::array);
                       }) &&
           std::all_of(session.invokes.begin(), session.invokes.end(), invoke_row) &&
           std::all_of(session.internal.begin(), session.internal.end(), event) &&
           std::all_of(session.external.begin(), session.external.end(), event) &&
           row(state.last_leaf) && row(state.fault.row) && state_row(session.atom) &&
           state_row(session.final) && state.fault.kind <= Fault::Kind::node &&
           (!program.is_machine() || !state.started || session.atom);
}

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
    state.derived.resize(program.derived.size());
    state.leaves = program.prototypes;
    return state;
}

bool same(const Program& program, const State& a, const State& b) {
    bool members = true;
    for_each_member(program, [&](std::size_t at, std::size_t size) {
        members = members && std::memcmp(&a.leaves[at], &b.leaves[at], size) == 0;
    });
    const Session& s = a.session;
    const Session& t = b.session;
    return members && a.tick == b.tick && a.started == b.started && a.woken == b.woken &&
           a.last_leaf == b.last_leaf && a.status == b.status && a.memory == b.memory &&
           a.slots == b.slots && a.entries == b.entries && a.words == b.words &&
           a.queues == b.queues && a.writes == b.writes && a.random == b.random &&
           s.atom == t.atom && s.invokes == t.invokes &&
           same_queue(s.internal, s.internal_next, t.internal, t.internal_next) &&
           same_queue(s.external, s.external_next, t.external, t.external_next) &&
           s.clock == t.clock && s.final == t.final && a.fault == b.fault;
}

std::vector<std::byte> save(const Program& program, const State& state) {
    ByteWriter out;
    write(out, program, state);
    return std::move(out).bytes();
}

std::optional<State> restore(const Program& program, std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    State state = fresh_state(program);
    in.get(state.tick);
    in.get(state.started);
    in.get(state.woken);
    get(in, state.last_leaf);
    for (Status& status : state.status) {
        in.get(status);
    }
    for (std::uint32_t& word : state.memory) {
        in.get(word);
    }
    for (Value& value : state.slots) {
        in.get(value);
    }
    for (EntryType& type : state.entries) {
        in.get(type);
    }
    for (std::uint64_t& word : state.words) {
        in.get(word);
    }
    for (Value& queue : state.queues) {
        in.get(queue);
    }
    for (std::uint32_t& writes : state.writes) {
        in.get(writes);
    }
    for_each_member(
        program, [&](std::size_t at, std::size_t size) { in.get_bytes(&state.leaves[at], size); });
    std::uint32_t count = 0;
    in.get(count);
    std::vector<std::uint64_t> words;
    while (in.ok() && count-- != 0) {
        in.get(words.emplace_back());
    }
    state.random = Random::from_words(words);
    Session& session = state.session;
    get(in, session.atom);
    in.get(count);
    while (in.ok() && count-- != 0) {
        get(in, session.invokes.emplace_back());
    }
    get(in, session.internal);
    get(in, session.external);
    in.get(session.clock);
    get(in, session.final);
    in.get(state.fault.kind);
    get(in, state.fault.row);
    Value message;
    in.get(message);
    if (!in.ok() || !in.at_end() || !message.is(Value::Kind::text)) { return {}; }
    state.fault.message = message.as_text();
    if (!is_possible(program, state)) { return {}; }
    return state;
}

// FNV-1a over what save() writes, with hashes in the place of values: members of equal objects may
// come in any order.
std::uint64_t hash(const Program& program, const State& state) {
    std::uint64_t h = 0xCBF29CE484222325;
    ByteWriter out(ByteWriter::Values::hashed);
    write(out, program, state);
    for (const std::byte byte : std::move(out).bytes()) {
        h = (h ^ static_cast<std::uint64_t>(byte)) * 0x100000001B3;
    }
    return h;
}

}  // namespace trellis
