// A compiled behaviour: flat tables that never change. Made by load/compile.h, run by exec/step.h,
// printed by dump(). Covered by tests/core/program_test.cpp; its making by tests/load.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/code.h"
#include "core/ids.h"
#include "core/leaf.h"
#include "core/machine_tables.h"
#include "core/status.h"
#include "core/value.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

enum class Op : std::uint8_t {
#define OP(name, element, group, least, most, doc) name,
#include "core/ops.def"
};

/// What a row is for: the first word of a TreeNodesModel entry, and what may contain what.
enum class OpGroup : std::uint8_t {
    control,
    decorator,
    action,
    condition,
    scope,
    state,
    pseudo,  ///< of machines: never active itself
    activity
};

/// One line of ops.def.
struct OpInfo {
    static constexpr std::uint32_t many = 0xFFFFFFFF;

    Op op;
    std::string_view name;     ///< as in the enum
    std::string_view element;  ///< as in documents; empty: no spelling of its own
    OpGroup group;
    std::uint32_t least_children, most_children;
    std::string_view doc;
};

/// All lines of ops.def, in order: op_table()[op] describes op.
struct OpTable {
    const OpInfo* first;
    std::size_t count;
    const OpInfo* begin() const { return first; }
    const OpInfo* end() const { return first + count; }
    const OpInfo& operator[](Op op) const { return first[static_cast<std::size_t>(op)]; }
};
OpTable op_table();

/// One row of the flat program. Rows are stored in document order, so the subtree of row n is the
/// interval [n, end).
struct Row {
    Op op = Op::tree;
    bool conditional = false;  ///< Program::conditions has an entry for it
    RowId parent;              ///< none for row 0
    RowId scope;               ///< innermost tree, subtree or machine around it; none for row 0
    RowId end;                 ///< one past the last row of this subtree
    std::uint32_t arg = 0;     ///< meaning depends on op; see the accessors of Program

    friend bool operator==(const Row&, const Row&) = default;
};

/// The names of rows by row. Many rows have the same name, so each is kept once.
struct RowNames {
    std::vector<std::string> texts;     ///< in the order of the first row that has it
    std::vector<std::uint32_t> by_row;  ///< index into `texts`

    const std::string& operator[](std::size_t row) const { return texts[by_row[row]]; }
    friend bool operator==(const RowNames&, const RowNames&) = default;
};

/// A place in the text that a row came from, for messages about runs. Line 0: none.
struct Origin {
    std::uint32_t file = 0, line = 0, column = 0;
};

/// A variable: an entry of a tree's blackboard, or a <data> of a machine.
struct Slot {
    std::string name;
    RowId scope;  ///< the tree, subtree or machine row it belongs to
    /// What it holds before the first tick: undefined unless a document says otherwise.
    Value initial;
    EntryType type = EntryType::missing;  ///< trees: whether it exists, and its declared type

    friend bool operator==(const Slot&, const Slot&) = default;
};

/// A number that follows from elapsed() or a real sensor by arithmetic with literals, as speeds and
/// turn rates of robots do: computed without evaluating code. Each step takes the last result.
struct Formula {
    enum class Source : std::uint8_t { elapsed_since, elapsed_count, sensor };

    Source source = Source::elapsed_since;
    std::uint32_t at = 0;                          ///< the row, or the byte of the host
    std::uint32_t first_step = 0, step_count = 0;  ///< Program::formula_steps

    friend bool operator==(const Formula&, const Formula&) = default;
};

/// Arithmetic on the result so far, r: r * factor + summand, with both roundings; then perhaps a
/// division by a literal or of one. The defaults change nothing.
struct FormulaStep {
    enum class Division : std::uint8_t { none, by_literal, of_literal };

    double factor = 1.0;
    double summand = -0.0;  // which, unlike 0.0, leaves -0.0 as it is
    double literal = 1.0;
    Division division = Division::none;

    friend bool operator==(const FormulaStep&, const FormulaStep&) = default;
};

using FormulaId = Id<struct FormulaTag>;  ///< Program::formulas

/// One input of one leaf that is evaluated before each tick. Literals are in the prototype instead.
struct LiveInput {
    std::uint32_t port = 0;  ///< index into LeafType::ports
    CodeId code;
    FormulaId formula;     ///< says the same, for a plain real port; none if it has no such form
    std::uint32_t offset;  ///< bytes, of the port's member in the leaf struct
    /// The same as in the last tick unless a variable of the machine was written in between; then
    /// the leaf struct holds all of it.
    bool steady;

    friend bool operator==(const LiveInput&, const LiveInput&) = default;
};

/// The same for the activity of a QuietState, where it has a formula.
struct QuietInput {
    Formula formula;
    std::uint32_t offset = 0;  ///< bytes, of the port's member in the leaf struct

    friend bool operator==(const QuietInput&, const QuietInput&) = default;
};

/// One output of one leaf that is bound to a variable.
struct BoundOutput {
    std::uint32_t port = 0;
    SlotId slot;

    friend bool operator==(const BoundOutput&, const BoundOutput&) = default;
};

/// A leaf as used at one place. Its struct lives at `offset` of State::leaves, from its first tick
/// to its last: what never runs at the same time shares bytes. How it is on entry (literal inputs
/// filled in) stands at `prototype` of Program::prototypes.
struct LeafCall {
    const LeafType* type = nullptr;  ///< owned by the registry, which must outlive the program
    std::uint32_t offset = 0;        ///< bytes
    std::uint32_t prototype = 0;     ///< bytes
    std::uint32_t fresh_size = 0;    ///< bytes that are fresh on entry; 0: it has no members
    std::uint32_t first_input = 0;   ///< Program::live_inputs
    std::uint32_t first_output = 0;  ///< Program::bound_outputs
    std::uint16_t input_count = 0, output_count = 0;

    friend bool operator==(const LeafCall&, const LeafCall&) = default;
};

using WordId = Id<struct WordTag>;    ///< State::words
using QueueId = Id<struct QueueTag>;  ///< State::queues

/// What a built-in node of a tree has besides its children, if it has several ports or remembers
/// more than State::memory holds.
struct NodeInfo {
    std::uint32_t first_port = 0;  ///< Program::ports, in the order of builtin_ports.def
    SlotId entry = {};             ///< the variable it watches, writes or removes; may be none
    WordId word = {};              ///< what it remembers: see exec/stepper.h
    QueueId queue = {};            ///< the elements it took from a text

    friend bool operator==(const NodeInfo&, const NodeInfo&) = default;
};

/// What stands in the place of a node that a substitution rule replaces: TestNodeConfig of
/// BehaviorTree.CPP.
struct TestInfo {
    Status status = Status::success;  ///< what it returns
    CodeId status_script;             ///< … unless there is this; its value names the status
    CodeId on_success, on_failure, post;
    std::int64_t delay = 0;  ///< ms before it returns
    WordId word;             ///< the tick at which it does

    friend bool operator==(const TestInfo&, const TestInfo&) = default;
};

/// The pre- and post-conditions of one node (TREES §1.5); a none is a condition it does not have.
/// Scripts see the names of the scope around the node.
struct Conditions {
    CodeId failure_if, success_if, skip_if, while_true;
    CodeId on_success, on_failure, on_halted, post;

    friend bool operator==(const Conditions&, const Conditions&) = default;
};

/// A compiled behaviour: immutable, shareable between threads, free of pointers into the text it
/// came from. Everything that changes while it runs is in State.
struct Program {
    std::vector<Row> rows;
    RowNames names;               ///< by row: the instance name, or the id of a state
    std::vector<Origin> origins;  ///< by row
    std::vector<Slot> slots;
    CodeTable code;               ///< every expression and script
    std::vector<LeafCall> calls;  ///< Row::arg of action and condition
    std::vector<LiveInput> live_inputs;
    std::vector<Formula> formulas;
    std::vector<FormulaStep> formula_steps;
    std::vector<BoundOutput> bound_outputs;
    std::vector<std::byte> prototypes;  ///< leaf structs as they are on entry, each kept once
    std::uint32_t leaf_bytes = 0;       ///< how large State::leaves is
    /// Inputs of built-in nodes: Row::arg of those with one only (repeat, retry, scripts).
    std::vector<CodeId> ports;
    std::vector<NodeInfo> nodes;          ///< Row::arg of built-in nodes with more
    std::vector<TestInfo> tests;          ///< Row::arg of test
    std::uint32_t words = 0, queues = 0;  ///< how many State::words and State::queues it needs
    bool counts_writes = false;           ///< a node watches an entry: State::writes is used
    /// Sorted by row, only rows that have any.
    std::vector<std::pair<RowId, Conditions>> conditions;

    std::vector<StateInfo> states;
    std::vector<Transition> transitions;
    std::vector<QuietState> quiet_states;
    std::vector<std::uint32_t> quiet_sensors;
    std::vector<Condition> quiet_times;
    std::vector<QuietInput> quiet_inputs;
    std::vector<RowId> targets;
    std::vector<RowId> entered;  ///< see Transition::only_moves
    std::vector<EventName> events;
    std::vector<EventId> descriptors;
    std::vector<Action> actions;
    std::vector<BlockId> blocks;  ///< lists of blocks: see StateInfo
    std::vector<std::string> labels;
    std::vector<InvokeInfo> invokes;
    std::vector<InvokeParam> params;
    std::vector<MachineNode> machine_nodes;
    std::vector<MachineParam> machine_params;
    std::vector<History> histories;
    std::vector<Payload> payloads;
    std::vector<PayloadItem> payload_items;
    std::vector<Send> sends;
    std::vector<Loop> loops;
    std::vector<SlotId> parameters;        ///< the variables that an invoking machine may set
    EventId tick_event;                    ///< "tick", or none if no transition names it
    EventId error_event;                   ///< "error.execution"; none in trees
    EventId communication_event;           ///< "error.communication"; none in trees
    SlotId event_slot;                     ///< `_event`, or none if no expression uses it
    SlotId session_slot, processors_slot;  ///< `_sessionid`, `_ioprocessors`, likewise
    bool has_eventless = false;            ///< whether any transition is eventless
    bool has_messages = false;             ///< whether it sends with a delay, or invokes machines
    bool has_parallel = false;             ///< whether more than one atomic state can be active
    /// Whether a cycle consists of taking the events that wait: nothing is eventless, asks for
    /// `tick` or `_event`, is invoked or remembered.
    bool takes_plain_events = false;
    /// Whether a cycle without events can do something: `tick` is named, or an eventless guard
    /// reads a sensor or the time.
    bool needs_every_cycle = false;

    /// Every machine that is invoked, directly or by one of these: of the outermost program only.
    std::vector<Program> machines;
    /// What this machine may compute as the source of one that it invokes, sorted by text.
    std::vector<MachineSource> sources;

    const HostType* host = nullptr;  ///< what the leaves and sensors need; null: nothing
    std::vector<std::string> files;  ///< names for Origin::file; not compared

    bool empty() const { return rows.empty(); }
    bool is_machine() const { return !rows.empty() && rows[0].op == Op::machine; }

    const Row& at(RowId n) const { return rows[n.index]; }
    std::string_view name(RowId n) const { return names[n.index]; }
    const StateInfo& state(RowId n) const { return states[at(n).arg]; }
    const LeafCall& call(RowId n) const { return calls[at(n).arg]; }
    /// True when `n` lies in the subtree of `root` (a row is in its own subtree).
    bool within(RowId n, RowId root) const { return root <= n && n < at(root).end; }
    /// Whether descriptor `d` matches an event of that name (SCXML 3.12.1).
    bool matches(EventId d, EventId event) const {
        return d <= event && event < events[d.index].end;
    }

    /// Equal behaviour: all tables but origins and files. Twins in XML and JSON are equal.
    friend bool operator==(const Program& a, const Program& b);
};

/// The children of a row, in document order: for (RowId c : children(program, n)).
class Children {
public:
    class Iterator {
    public:
        Iterator(const Row* rows, RowId at) : rows_(rows), at_(at) {}
        RowId operator*() const { return at_; }
        Iterator& operator++() {
            at_ = rows_[at_.index].end;
            return *this;
        }
        friend bool operator!=(const Iterator& a, const Iterator& b) { return a.at_ != b.at_; }

    private:
        const Row* rows_;
        RowId at_;
    };
    Children(const Row* rows, RowId n)
        : rows_(rows), first_{n.index + 1}, last_(rows[n.index].end) {}
    Iterator begin() const { return {rows_, first_}; }
    Iterator end() const { return {rows_, last_}; }

    /// The first `count` of them; there must be that many.
    Children first(std::uint32_t count) const {
        Children part = *this;
        part.last_ = part.first_;
        while (count-- != 0) {
            part.last_ = rows_[part.last_.index].end;
        }
        return part;
    }

private:
    const Row* rows_;
    RowId first_, last_;
};
inline Children children(const Program& program, RowId n) {
    return {program.rows.data(), n};
}

/// All tables as text, a line per row, names instead of numbers: for people, goldens and diffs.
std::string dump(const Program& program);

}  // namespace trellis
