// Everything that changes while a Program runs, as one value: copy it to save, assign it back to
// restore, compare it, hash it, write it to bytes. Covered by tests/core/state_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/program.h"
#include "core/random.h"
#include "core/status.h"
#include "core/value.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace trellis {

/// Why a run cannot go on. A State with a fault must not be stepped again.
struct Fault {
    enum class Kind : std::uint8_t {
        none,
        expression,   ///< a script or an input of `row` could not be evaluated
        output,       ///< an output of leaf `row` does not fit its variable
        leaf_status,  ///< leaf `row` returned a status that its kind may not return
        budget,       ///< the tick took more steps than allowed; `row` is where it was
        livelock,     ///< machine `row` took more microsteps in one macrostep than allowed
        draws,        ///< the list of random numbers to replay is used up
        node,         ///< built-in node `row` cannot do what it is asked to
    };
    Kind kind = Kind::none;
    RowId row;
    std::string message;  ///< what failed, in words; without the place

    explicit operator bool() const { return kind != Kind::none; }
    friend bool operator==(const Fault&, const Fault&) = default;
};

/// An event in a queue of a machine.
struct Event {
    enum class Type : std::uint8_t { internal, external, platform };

    EventId name = {};
    Value unknown = {};  ///< the whole name as text, if `name` is only its longest known prefix
    Type type = Type::internal;
    Value data = {};
    RowId invoke = {};             ///< the row whose activity sent it; else none
    std::uint32_t activation = 0;  ///< of `invoke`
    bool completes = false;        ///< done.invoke: it counts only for that activation
    std::uint32_t origin = 0;      ///< Session::id of its sender; 0: no session
    Value sendid = {}, invokeid = {}, raw = {};  ///< members of _event (SCXML 5.10.1)

    friend bool operator==(const Event&, const Event&) = default;
};

/// A message that waits for its time.
struct Delayed {
    std::uint64_t due = 0;  ///< State::tick + 1 of the cycle that delivers it
    double time = 0.0;      ///< s: of two that are due in one cycle, the earlier comes first
    Value target = {};      ///< as in <send>; undefined: the session itself
    Event event = {};

    friend bool operator==(const Delayed&, const Delayed&) = default;
};

/// What a running machine has besides the statuses of its rows.
struct Session {
    std::uint32_t id = 1;        ///< _sessionid is "s" and this; the outermost one is 1
    std::vector<RowId> active;   ///< the configuration: its states, in document order
    RowId atom;                  ///< the last of them, an atomic state; none before the start
    std::vector<RowId> pending;  ///< invoke rows of states entered in this macrostep
    std::vector<RowId> invokes;  ///< running invoke rows, in document order
    /// By Program::histories: the states stored; none if its state was never left.
    std::vector<std::vector<RowId>> histories;
    std::vector<Event> internal, external;
    /// The first event of each that is not yet taken; a queue without such events is emptied.
    std::uint32_t internal_next = 0, external_next = 0;
    std::vector<Delayed> delayed;  ///< in the order of delivery
    std::uint32_t made_ids = 0;    ///< ids made for <send idlocation>
    std::uint32_t sessions = 1;    ///< the outermost one: the last Session::id given
    std::uint32_t clock = 0;  ///< cycles in which activities ran, the current one once they begin
    RowId final;              ///< the top-level final state that ended it; else none

    friend bool operator==(const Session&, const Session&) = default;
};

struct Child;

/// Buffers of a step, empty between steps but for their capacity: not part of what a state is.
struct Workspace {
    /// A transition that is to be taken, the row below which it leaves, and where that is known
    /// what it leaves: [first, last) of Session::active.
    struct Choice {
        TransitionId id;
        RowId domain;
        std::uint32_t first = 0, last = 0;
    };
    std::vector<Choice> chosen;
    std::vector<RowId> entering;
    std::vector<std::uint8_t> marks;  ///< by row: what is to happen to it (exec/configuration.cpp)
    std::vector<std::pair<RowId, BlockId>> history_content;  ///< of default ways, and its state
    std::vector<Value> loops;                                ///< by Program::loops: the array
    /// A message whose time has come, and the session that sent it.
    struct Due {
        std::uint32_t session;
        Delayed message;
    };
    std::vector<Due> due;
};

struct State {
    std::uint64_t tick = 0;             ///< ticks completed
    bool started = false;               ///< machines: whether the initial states were entered
    bool woken = false;                 ///< a node asked to be ticked again at once (TREES §1.4)
    RowId last_leaf;                    ///< the leaf ticked last; none before the first
    std::vector<Status> status;         ///< by row
    std::vector<std::uint32_t> memory;  ///< by row: see exec/stepper.h
    std::vector<Value> slots;           ///< by slot; hosts that change one call wake()
    std::vector<EntryType> entries;     ///< by slot
    std::vector<std::uint64_t> words;   ///< NodeInfo::word, where `memory` is not enough
    std::vector<Value> queues;          ///< NodeInfo::queue: arrays, undefined before they are read
    /// By slot: how often it was written since it exists; empty unless Program::counts_writes.
    std::vector<std::uint32_t> writes;
    /// Derived, not part of what a state is: the row at which the next tick of a tree may begin.
    RowId resume;
    /// The same for machines: the next cycles, as long as no event and no sensor interferes.
    struct Quiet {
        QuietId id;                ///< of the state they are spent in
        std::uint32_t cycles = 0;  ///< how many pass before it is time for something else
        double dt = 0.0;           ///< s, if every one takes so long
    };
    Quiet quiet;
    /// Scratch, not part of what a state is: temporaries of expressions, and by live input the
    /// value it had in the last tick, and two texts that are compared.
    std::vector<Value> temporaries, inputs;
    std::string left, right;
    Workspace work;
    std::vector<std::byte> leaves;  ///< leaf structs, back to back: see LeafCall::offset
    Random random;                  ///< the generator of this run
    Session session;
    std::vector<Child> children;  ///< invoked machines that run, in document order
    Fault fault;
};

/// Machines that invoke machines nest at most this deep.
inline constexpr std::uint32_t max_session_depth = 64;

/// A machine that runs because a state invokes it.
struct Child {
    RowId invoke;  ///< of the program that invokes it
    MachineId machine;
    State state;
};

/// The program of an invoked machine; `outermost` is the one that is stepped.
inline const Program& program_of(const Program& outermost, const Child& child) {
    return outermost.machines[child.machine.index];
}

/// A State for `program` in which nothing is active. Seed `random` before the first step if the
/// behaviour draws numbers; unseeded it is seeded with 0 by the first draw.
State fresh_state(const Program& program);

/// Lets the next step look at everything anew. For hosts that have changed a variable.
inline void wake(State& state) {
    state.quiet = {};
}

/// Whether two states of `program` are the same: leaf structs by their registered members. States
/// that are the same have the same future.
bool same(const Program& program, const State& a, const State& b);

/// A hash that is equal for same states, on every platform with IEEE doubles.
std::uint64_t hash(const Program& program, const State& state);

/// The state as bytes, and back; empty if the bytes do not fit the program. A state that went
/// through bytes is the same as the original.
std::vector<std::byte> save(const Program& program, const State& state);
std::optional<State> restore(const Program& program, std::span<const std::byte> bytes);

}  // namespace trellis
