// What a Program holds of a machine besides its rows: events, transitions, states, messages,
// activities, executable content. Tables only; what they mean when they are run is in exec. Covered
// by tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/value.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace trellis {

/// A name of events, or a prefix of names. The table is a tree in document order of dotted tokens:
/// descriptor d matches event e when d <= e < end(d) (SCXML 3.12.1). Row 0 is the empty name: as a
/// descriptor it is "*".
struct EventName {
    std::string text;  ///< whole: "done.invoke.drive"
    EventId end;

    friend bool operator==(const EventName&, const EventName&) = default;
};

/// The order of Program::events, token by token: a name stands right before those it is a prefix
/// of.
inline bool token_less(std::string_view a, std::string_view b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
        const auto rank = [](char c) { return c == '.' ? 0 : static_cast<unsigned char>(c) + 1; };
        return rank(x) < rank(y);
    });
}

/// What a condition asks, where it is one of those that robots ask in every cycle: then it is
/// answered without evaluating code. `code` always says the same.
struct Condition {
    enum class Form : std::uint8_t {
        always,            ///< there is none
        sensor,            ///< a boolean sensor, at byte `at` of the host
        elapsed,           ///< elapsed() > `limit`, of the state of row `at`
        elapsed_variable,  ///< the same, with what `variables` gives
        code,              ///< anything else
    };
    Form form = Form::always;
    std::uint32_t at = 0;
    double limit = 0.0;     ///< s
    CodeId variables = {};  ///< a limit that only variables decide
    CodeId code = {};

    friend bool operator==(const Condition&, const Condition&) = default;
};

/// One <transition>, or the content of an <initial>. Those of one source are neighbours, in
/// document order.
struct Transition {
    RowId source;
    std::uint32_t first_event = 0, event_count = 0;    ///< Program::descriptors; 0: eventless
    std::uint32_t first_target = 0, target_count = 0;  ///< Program::targets; 0: targetless
    Condition guard = {};
    BlockId block = {};  ///< none: no content
    /// The events that the only descriptor matches; none unless there is exactly one.
    EventId event_begin = {}, event_end = {};
    bool internal = false;  ///< type="internal", and source and targets allow it (SCXML 3.13)
    /// A target is a history: what it stands for decides the domain when the transition is taken.
    bool to_history = false;
    RowId domain = {};  ///< the row whose descendants are left; none if targetless
    /// Taking it does no more than leave, and enter those of Program::entered, in document order.
    bool only_moves = false;
    std::uint32_t first_entered = 0, entered_count = 0;

    friend bool operator==(const Transition&, const Transition&) = default;
};

/// A cycle in an atomic state in which no guard holds that the event `tick` asks there or around
/// it, and its only activity goes on. Made for states where nothing of this needs code: guards that
/// ask sensors or the time, an action without outputs whose inputs are formulas or do not change.
struct QuietState {
    // parts of Program::quiet_sensors (see Condition::at), quiet_times and quiet_inputs
    std::uint32_t first_sensor = 0, sensor_end = 0;
    std::uint32_t first_time = 0, time_end = 0;
    std::uint32_t first_input = 0, input_end = 0;
    std::uint32_t call = 0;  ///< Program::calls, of the activity
    RowId activity;

    friend bool operator==(const QuietState&, const QuietState&) = default;
};
using QuietId = Id<struct QuietTag>;  ///< Program::quiet_states

/// What a machine, state, parallel or final row has besides its children. Row::arg indexes
/// Program::states.
struct StateInfo {
    std::uint32_t first_transition = 0, transition_count = 0;
    std::uint32_t first_entry = 0, entry_count = 0;  ///< Program::blocks: <onentry>, in order
    std::uint32_t first_exit = 0, exit_count = 0;    ///< Program::blocks: <onexit>, in order
    TransitionId initial;  ///< compound states and machines: where they begin; else none
    RowId outer;           ///< the next state around it that has transitions; none if there is none
    QuietId quiet;         ///< atomic states: what a cycle is in which nothing happens; may be none
    bool atomic = false;   ///< it has no states inside
    bool silent = false;   ///< nothing runs or is remembered when it is entered or left
    /// Numbers of invoke and history rows: in this order they precede the states among children.
    std::uint32_t invokes = 0, histories = 0;
    EventId done;        ///< compound and parallel states: done.state.ID
    PayloadId donedata;  ///< final states: what the event of their parent carries

    friend bool operator==(const StateInfo&, const StateInfo&) = default;
};

/// One <history>. Row::arg indexes Program::histories.
struct History {
    bool deep = false;
    TransitionId initial = {};  ///< where it leads while nothing is stored

    friend bool operator==(const History&, const History&) = default;
};

/// A text that a document gives, or gives an expression for.
struct LiveText {
    std::string text;
    CodeId code;  ///< none: it is `text`

    explicit operator bool() const { return code || !text.empty(); }
    friend bool operator==(const LiveText&, const LiveText&) = default;
};

/// Where an idlocation writes to: a variable, or a place below one through the temporary that its
/// code stores. Neither: there is no idlocation.
struct Place {
    SlotId slot;
    CodeId store;

    explicit operator bool() const { return slot || store; }
    friend bool operator==(const Place&, const Place&) = default;
};

/// What an event or an invocation carries (SCXML 5.5 to 5.7): members of an object, or a whole.
struct Payload {
    std::uint32_t first_item = 0, item_count = 0;  ///< Program::payload_items
    CodeId content;                                ///< the whole; then there are no items

    friend bool operator==(const Payload&, const Payload&) = default;
};

/// One name of a namelist, or one <param>.
struct PayloadItem {
    std::string name;
    CodeId code;
    bool listed = false;  ///< of a namelist: if it fails, so does the whole message

    friend bool operator==(const PayloadItem&, const PayloadItem&) = default;
};

/// One <send> (SCXML 6.2).
struct Send {
    EventId event;       ///< its name, or none
    CodeId event_code;   ///< eventexpr
    LiveText target;     ///< empty: the session itself
    LiveText type;       ///< empty: SCXML's own processor
    double delay = 0.0;  ///< s
    CodeId delay_code;   ///< delayexpr
    std::string id;      ///< empty: none, or made for `id_place`
    Place id_place;
    PayloadId payload;

    friend bool operator==(const Send&, const Send&) = default;
};

/// The variables of one <foreach>.
struct Loop {
    SlotId item, index;

    friend bool operator==(const Loop&, const Loop&) = default;
};

/// One <invoke>. Row::arg indexes Program::invokes; a leaf or tree is its only child row, a machine
/// is a program of its own.
struct InvokeInfo {
    std::string id;
    EventId done;                        ///< machines: done.invoke.ID
    EventId done_success, done_failure;  ///< leaves, trees: done.invoke.ID.success and .failure
    std::uint32_t first_param = 0, param_count = 0;  ///< Program::params; trees only
    // the rest is about machines
    MachineId machine = {};  ///< Program::machines of the outermost; none if `source` says it
    CodeId source = {};      ///< srcexpr, or expr of <content>: gives one of Program::sources
    CodeId type = {};        ///< typeexpr
    PayloadId payload = {};  ///< values of the machine's variables
    Place id_place = {};     ///< idlocation
    BlockId finalize = {};   ///< done before an event from the machine is answered
    bool autoforward = false;

    friend bool operator==(const InvokeInfo&, const InvokeInfo&) = default;
};

/// One <Machine>, a machine as a node of a tree. Row::arg of run_machine indexes
/// Program::machine_nodes.
struct MachineNode {
    MachineId machine = {};
    std::uint32_t first_param = 0, param_count = 0;  ///< Program::machine_params

    friend bool operator==(const MachineNode&, const MachineNode&) = default;
};

/// A variable of that machine that its node gives a value.
struct MachineParam {
    std::string name;
    SlotId variable;  ///< of the machine
    SlotId entry;     ///< of the tree, shared while the node runs; none: it begins with `value`
    Value value = {};

    friend bool operator==(const MachineParam&, const MachineParam&) = default;
};

/// A machine that the text `source` of a srcexpr or a <content expr> stands for.
struct MachineSource {
    std::string source;
    MachineId machine;

    friend bool operator==(const MachineSource&, const MachineSource&) = default;
};

/// A <param> of an invoked tree: written to an entry of its blackboard before each tick.
struct InvokeParam {
    SlotId slot;
    CodeId code;

    friend bool operator==(const InvokeParam&, const InvokeParam&) = default;
};

/// One step of executable content (SCXML 4). A block ends with `end`.
struct Action {
    enum class Kind : std::uint8_t {
        end,         ///< of the block
        run,         ///< <script>: evaluate `code`
        assign,      ///< <assign>: evaluate `code`, then run `store` on the result
        initialise,  ///< <data>: give `slot` the value of `code` unless the host has set it
        raise,       ///< put `event` into the internal queue
        log,         ///< report label `arg` and the value of `code` (none: the label alone)
        unless,      ///< go on at action `go_to` if `code` is false (<if>, <elseif>)
        jump,        ///< go on at action `go_to` (the end of a branch)
        each,        ///< <foreach>: run the actions up to their `end` with the variables of loop
                     ///< `arg` for each element of `code`, then go on at `go_to`
        send,        ///< <send> number `arg`
        cancel,      ///< <cancel> the messages with the id `code`
        refuse,      ///< raise error.execution: label `arg` says why
    };
    Kind kind = Kind::end;
    CodeId code = {}, store = {};
    SlotId slot = {};
    EventId event = {};
    BlockId go_to = {};
    std::uint32_t arg = 0;  ///< Program::labels, loops or sends

    friend bool operator==(const Action&, const Action&) = default;
};

}  // namespace trellis
