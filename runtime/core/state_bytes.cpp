// States as bytes, and back: saving, restoring, hashing. Covered by
// tests/exec/save_restore_test.cpp and tests/core/state_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/bytes.h"
#include "core/running_leaves.h"
#include "core/state.h"

#include <algorithm>

namespace trellis {

namespace {

template <class Tag>
void put(ByteWriter& out, Id<Tag> id) {
    out.put(id.index);
}
template <class Tag>
void get(ByteReader& in, Id<Tag>& id) {
    in.get(id.index);
}

template <class Tag>
void put(ByteWriter& out, const std::vector<Id<Tag>>& ids) {
    out.put(static_cast<std::uint32_t>(ids.size()));
    for (const Id<Tag> id : ids) {
        put(out, id);
    }
}
template <class Tag>
void get(ByteReader& in, std::vector<Id<Tag>>& ids) {
    std::uint32_t count = 0;
    in.get(count);
    while (in.ok() && count-- != 0) {
        get(in, ids.emplace_back());
    }
}

void put(ByteWriter& out, const Event& event) {
    put(out, event.name);
    out.put(event.unknown);
    out.put(event.type);
    out.put(event.data);
    put(out, event.invoke);
    out.put(event.activation);
    out.put(event.completes);
    out.put(event.origin);
    out.put(event.sendid);
    out.put(event.invokeid);
    out.put(event.raw);
}
void get(ByteReader& in, Event& event) {
    get(in, event.name);
    in.get(event.unknown);
    in.get(event.type);
    in.get(event.data);
    get(in, event.invoke);
    in.get(event.activation);
    in.get(event.completes);
    in.get(event.origin);
    in.get(event.sendid);
    in.get(event.invokeid);
    in.get(event.raw);
}

void put(ByteWriter& out, const std::vector<Event>& events, std::uint32_t next) {
    out.put(static_cast<std::uint32_t>(events.size()) - next);
    for (std::size_t i = next; i < events.size(); ++i) {
        put(out, events[i]);
    }
}
void get(ByteReader& in, std::vector<Event>& events) {
    std::uint32_t count = 0;
    in.get(count);
    while (in.ok() && count-- != 0) {
        get(in, events.emplace_back());
    }
}

void put(ByteWriter& out, const std::vector<Delayed>& messages) {
    out.put(static_cast<std::uint32_t>(messages.size()));
    for (const Delayed& message : messages) {
        out.put(message.due);
        out.put(message.time);
        out.put(message.target);
        put(out, message.event);
    }
}
void get(ByteReader& in, std::vector<Delayed>& messages) {
    std::uint32_t count = 0;
    in.get(count);
    while (in.ok() && count-- != 0) {
        Delayed& message = messages.emplace_back();
        in.get(message.due);
        in.get(message.time);
        in.get(message.target);
        get(in, message.event);
    }
}

// Of the active states only the list is written: the last of them follows.
void put(ByteWriter& out, const Session& session) {
    out.put(session.id);
    put(out, session.active);
    put(out, session.pending);
    put(out, session.invokes);
    for (const std::vector<RowId>& stored : session.histories) {
        put(out, stored);
    }
    put(out, session.internal, session.internal_next);
    put(out, session.external, session.external_next);
    put(out, session.delayed);
    out.put(session.made_ids);
    out.put(session.sessions);
    out.put(session.clock);
    put(out, session.final);
}
void get(ByteReader& in, Session& session) {
    in.get(session.id);
    get(in, session.active);
    if (!session.active.empty()) { session.atom = session.active.back(); }
    get(in, session.pending);
    get(in, session.invokes);
    for (std::vector<RowId>& stored : session.histories) {
        get(in, stored);
    }
    get(in, session.internal);
    get(in, session.external);
    get(in, session.delayed);
    in.get(session.made_ids);
    in.get(session.sessions);
    in.get(session.clock);
    get(in, session.final);
}

void write(ByteWriter& out, const Program& outermost, const Program& program, const State& state) {
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
    for_each_member(program, state.status, [&](std::size_t at, std::size_t size) {
        out.put_bytes(&state.leaves[at], size);
    });
    const std::vector<std::uint64_t> words = state.random.words();
    out.put(static_cast<std::uint32_t>(words.size()));
    for (const std::uint64_t word : words) {
        out.put(word);
    }
    put(out, state.session);
    out.put(static_cast<std::uint32_t>(state.children.size()));
    for (const Child& child : state.children) {
        put(out, child.invoke);
        put(out, child.machine);
        write(out, outermost, program_of(outermost, child), child.state);
    }
    out.put(state.fault.kind);
    put(out, state.fault.row);
    out.put(Value::text(state.fault.message));
}

bool is_state(const Program& program, RowId n) {
    return n.index < program.rows.size() && op_table()[program.at(n).op].group == OpGroup::state;
}

bool runs_machines(Op op) {
    return op == Op::invoke || op == Op::run_machine;
}

/// Whether the active states are a legal configuration (SCXML 3.13): with each state the one around
/// it, one child of a compound state, all of a parallel one.
bool is_configuration(const Program& program, const State& state) {
    const std::vector<RowId>& active = state.session.active;
    std::vector<std::uint32_t> inside(program.rows.size());
    for (std::size_t i = 0; i < active.size(); ++i) {
        const RowId n = active[i];
        if (n.index == 0 || !is_state(program, n) || (i != 0 && n <= active[i - 1])) {
            return false;
        }
        ++inside[program.at(n).parent.index];
    }
    for (std::uint32_t i = 0; i < program.rows.size(); ++i) {
        if (!is_state(program, {i})) { continue; }
        const bool runs = i == 0 ? !active.empty() : state.status[i] == Status::running;
        std::uint32_t states = program.rows[i].op == Op::parallel_state ? 0 : 1;
        if (states == 0) {
            for (const RowId child : children(program, {i})) {
                states += is_state(program, child) ? 1 : 0;
            }
        }
        if (program.state({i}).atomic || !runs) { states = 0; }
        if (inside[i] != states) { return false; }
    }
    return std::all_of(active.begin(), active.end(),
                       [&](RowId n) { return state.status[n.index] == Status::running; });
}

/// Whether every number in a restored session names something of the program.
bool is_possible(const Program& program, const Session& session) {
    const auto state_row = [&](RowId n) { return is_state(program, n); };
    const auto invoke_row = [&](RowId n) {
        return n.index < program.rows.size() && program.at(n).op == Op::invoke;
    };
    const auto event = [&](const Event& e) {
        return e.name.index < program.events.size() && e.type <= Event::Type::platform &&
               (!e.invoke || invoke_row(e.invoke));
    };
    const auto invoke_rows = [&](const std::vector<RowId>& rows) {
        return std::all_of(rows.begin(), rows.end(), invoke_row);
    };
    return std::all_of(session.active.begin(), session.active.end(), state_row) &&
           invoke_rows(session.pending) && invoke_rows(session.invokes) &&
           std::all_of(session.internal.begin(), session.internal.end(), event) &&
           std::all_of(session.external.begin(), session.external.end(), event) &&
           std::all_of(session.delayed.begin(), session.delayed.end(),
                       [&](const Delayed& d) { return event(d.event); }) &&
           std::all_of(session.histories.begin(), session.histories.end(),
                       [&](const std::vector<RowId>& stored) {
                           return std::all_of(stored.begin(), stored.end(), state_row);
                       }) &&
           (!session.final || state_row(session.final));
}

/// The bits of State::memory that are no child's number, of a control (exec/stepper.h).
std::uint32_t flags_in_memory(Op op) {
    switch (op) {
    case Op::sequence:
    case Op::fallback:
    case Op::async_sequence:
    case Op::async_fallback:
    case Op::sequence_with_memory: return 0x80000000;
    case Op::try_catch: return 0xC0000000;
    default: return 0;
    }
}

/// The same for a whole restored state, without its children.
bool is_possible(const Program& program, const State& state) {
    const auto row = [&](RowId n) { return !n || n.index < program.rows.size(); };
    // what a control remembers is one of its children
    for (std::uint32_t i = 0; i < program.rows.size(); ++i) {
        if (op_table()[program.rows[i].op].group != OpGroup::control) { continue; }
        const RowId child{state.memory[i] & ~flags_in_memory(program.rows[i].op)};
        if (child.index != 0 && (!row(child) || program.at(child).parent != RowId{i})) {
            return false;
        }
    }
    const bool begun = program.is_machine() && state.started && !state.session.final;
    return std::all_of(state.status.begin(), state.status.end(),
                       [](Status s) { return s <= Status::skipped; }) &&
           std::all_of(state.entries.begin(), state.entries.end(),
                       [](EntryType t) { return t <= EntryType::text; }) &&
           std::all_of(state.queues.begin(), state.queues.end(),
                       [](const Value& queue) {
                           return queue.is(Value::Kind::undefined) || queue.is(Value::Kind::array);
                       }) &&
           row(state.last_leaf) && row(state.fault.row) && state.fault.kind <= Fault::Kind::node &&
           is_possible(program, state.session) &&
           (state.fault || (is_configuration(program, state) &&
                            begun == (!state.session.active.empty() && !state.session.final)));
}

/// Reads what write() has written of a session inside `around` others. False if it does not fit the
/// program.
bool read(ByteReader& in, const Program& outermost, const Program& program, State& state,
          std::uint32_t around = 0) {
    if (around == max_session_depth) { return false; }
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
    for_each_running(program, state.status, [&](const LeafCall& call) {
        std::copy_n(program.prototypes.data() + call.prototype, call.fresh_size,
                    state.leaves.data() + call.offset);
    });
    for_each_member(program, state.status, [&](std::size_t at, std::size_t size) {
        in.get_bytes(&state.leaves[at], size);
    });
    std::uint32_t count = 0;
    in.get(count);
    std::vector<std::uint64_t> words;
    while (in.ok() && count-- != 0) {
        in.get(words.emplace_back());
    }
    state.random = Random::from_words(words);
    get(in, state.session);
    in.get(count);
    while (in.ok() && count-- != 0) {
        Child& child = state.children.emplace_back();
        get(in, child.invoke);
        get(in, child.machine);
        if (!in.ok() || child.machine.index >= outermost.machines.size() ||
            child.invoke.index >= program.rows.size() ||
            !runs_machines(program.at(child.invoke).op)) {
            return false;
        }
        const Program& machine = program_of(outermost, child);
        child.state = fresh_state(machine);
        if (!read(in, outermost, machine, child.state, around + 1)) { return false; }
    }
    in.get(state.fault.kind);
    get(in, state.fault.row);
    Value message;
    in.get(message);
    if (!in.ok() || !message.is(Value::Kind::text)) { return false; }
    state.fault.message = message.as_text();
    return is_possible(program, state);
}

}  // namespace

std::vector<std::byte> save(const Program& program, const State& state) {
    ByteWriter out;
    write(out, program, program, state);
    return std::move(out).bytes();
}

std::optional<State> restore(const Program& program, std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    State state = fresh_state(program);
    if (!read(in, program, program, state) || !in.at_end()) { return {}; }
    return state;
}

// FNV-1a over what save() writes, with hashes in the place of values: members of equal objects may
// come in any order.
std::uint64_t hash(const Program& program, const State& state) {
    std::uint64_t h = 0xCBF29CE484222325;
    ByteWriter out(ByteWriter::Values::hashed);
    write(out, program, program, state);
    for (const std::byte byte : std::move(out).bytes()) {
        h = (h ^ static_cast<std::uint64_t>(byte)) * 0x100000001B3;
    }
    return h;
}

}  // namespace trellis
