// The interpreter behind step(): one call's view of a program and the state it may change. Private
// to runtime/exec. The rules are spread over tree_rules.cpp, tree_controls.cpp,
// tree_decorators.cpp, tree_leaves.cpp and tree_machines.cpp (trees); machine_rules.cpp,
// configuration.cpp, content.cpp, messages.cpp and activities.cpp (machines); leaves.cpp (leaves)
// and stepper.cpp (what all share). A machine that another one invokes has a Stepper of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "core/state.h"
#include "exec/evaluate.h"
#include "exec/forms.h"
#include "exec/step.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trellis {

/// More events than this may not wait in one queue: an endless machine ends before the memory does.
inline constexpr std::size_t max_waiting_events = 100'000;
inline std::string too_many_events() {
    return "this machine does not come to rest: more than " + std::to_string(max_waiting_events) +
           " events wait";
}

/// The event processor that every machine has, under its long name (SCXML C.1).
inline constexpr std::string_view event_processor =
    "http://www.w3.org/TR/scxml/#SCXMLEventProcessor";
/// Targets of messages that begin so name a session by its number.
inline constexpr std::string_view session_prefix = "#_scxml_s";
std::string session_address(std::uint32_t id);

/// An external event of that name, as the program numbers names.
Event event_named(const Program& program, std::string_view name);

/// Whether an <invoke> of that type is a machine (SCXML 6.4.1).
inline bool is_machine_type(std::string_view type) {
    return type.empty() || type == "scxml" || type == "http://www.w3.org/TR/scxml/" ||
           type == "http://www.w3.org/TR/scxml";
}

// What State::memory holds, by kind of row:
//   sequences, fallbacks   the child to go on at, 0 for the first; top bit: a child was not skipped
//   try_catch              the same; next bit: the last child is being ticked
//   if_then_else, switch*  the child that was chosen, 0 for none
//   repeat, retry          completed cycles
//   delay                  0 not begun, 1 waiting, 2 over
//   timeout                0 not begun, 1 begun, 2 begun and no longer limited
//   run_once               the status it ended with, 0 before
//   precondition           1: the child was let in
//   loop_*                 elements taken; top bit: the child runs
//   skip_unless_updated, wait_value_update    1: the child runs
//   tree, subtree          ticks since it was entered, the current one included: elapsed()
//   state, machine         Session::clock when it was entered: elapsed()
//   invoke                 number of its activations
// and State::words, where a row has one:
//   sequences, try_catch   skipped children since the count was last cleared
//   delay, timeout, sleep, test               the tick at which the time is over
//   *_updated              how often the entry had been written when it was last looked at
class Stepper {
public:
    Stepper(const Program& program, State& state, HostRef host, const StepOptions& options)
        : p_(program), s_(state), rows_(program.rows.data()), status_(state.status.data()),
          memory_(state.memory.data()), host_(host.object), trace_(options.trace),
          outermost_(*this), while_woken_(options.while_woken),
          budget_(options.budget != 0
                      ? options.budget
                      : 100'000 + 64 * static_cast<std::uint32_t>(state.status.size())),
          tick_{state.tick, options.dt, &state.random} {}

    /// For a machine that the one of `parent` invokes: on its time, with its budget.
    Stepper(Stepper& parent, Child& child);

    /// One tick of the whole program: see step().
    Status step_root();
    /// The rest of a quiet step whose leaf has returned `status`.
    Status finish_quiet_step(Status status);
    void start_machine();
    void halt_root();

    // Every kind of row --------------------------------------------------------------------------

    /// Ticks a row: conditions, rule, stored status. Idle after a fault, which changes no status
    /// any more on the way out.
    Status tick(RowId n);
    /// Halts a row and what runs below it, children first; then its _onHalted script.
    void halt_node(RowId n);

private:
    /// Top bit of a sequence's memory: a child has completed without being skipped.
    static constexpr std::uint32_t not_all_skipped = 0x80000000;

    Status step_tree(RowId root);
    Status rest_of_tree(RowId root, Status status);
    Status tick_resumed(RowId root);
    Status end_resumed(RowId root, Status status);
    void count_scopes_around(RowId n, std::uint32_t ticks) {
        for (RowId up = rows_[n.index].scope; up; up = rows_[up.index].scope) {
            memory_[up.index] += ticks;
        }
    }
    RowId resumable(RowId root) const;
    bool is_constant(const Row& loop) const;
    Status tick_conditional(RowId n, const Row& row);
    Status dispatch(RowId n, const Row& row);
    Status pre_conditions(RowId n, const Conditions& conditions);
    bool post_conditions(RowId n, const Conditions& conditions, Status status);
    const Conditions& conditions_of(RowId n) const;

    /// Stores a status and traces the change.
    [[gnu::always_inline]] void store(RowId n, Status status) {
        if (trace_ != nullptr) { trace_status(n, status); }
        status_[n.index] = status;
    }
    /// Stores what a tick returned. A skipped node keeps what its rule has stored (TREES §1).
    [[gnu::always_inline]] void keep(RowId n, Status status) {
        if (status == Status::skipped) {
            trace({.kind = TraceEvent::Kind::skip, .row = n});
        } else if (status != Status::idle) {
            store(n, status);
        }
    }
    /// Halts a child if it runs, and makes it idle: resetChild of BehaviorTree.CPP.
    [[gnu::always_inline]] void reset(RowId n) {
        if (status_[n.index] == Status::running) { halt_node(n); }
        if (status_[n.index] != Status::idle) { store(n, Status::idle); }
    }
    void reset_children(RowId n) { reset_from(first_child(n), rows_[n.index].end); }
    /// Resets the children from `child` on.
    void reset_from(RowId child, RowId end) {
        for (; child != end; child = rows_[child.index].end) {
            reset(child);
        }
    }
    std::uint32_t child_count(RowId n) const;
    /// Begins to count skipped children anew. A count is kept only where a node may be ticked again
    /// without having been reset (Row::arg, 0 elsewhere): there BehaviorTree.CPP goes on counting
    /// after a failure.
    void clear_skips(const Row& row) {
        if (row.arg != 0) { s_.words[row.arg - 1] = 0; }
    }

    // Trees: tree_rules.cpp ----------------------------------------------------------------------

    template <Status stop, Status go_on, bool yields = false, bool keeps_place = false>
    Status tick_in_order(RowId n, const Row& row);
    template <Status stop, Status go_on>
    Status tick_reactive(RowId n);
    Status tick_mapped(RowId n, Status on_success, Status on_failure);
    template <Status stop, Status go_on>
    Status tick_loop(RowId n, const Row& row);
    Status tick_script(RowId n, const Row& row);
    Status tick_script_condition(RowId n, const Row& row);
    Status tick_scope(RowId n);
    Status tick_only_child(RowId n);

    // Trees: tree_controls.cpp -------------------------------------------------------------------

    Status tick_parallel(RowId n, const Row& row);
    Status tick_parallel_all(RowId n, const Row& row);
    bool threshold(RowId n, CodeId port, std::uint32_t children, std::uint32_t& result,
                   bool& is_relative);
    std::uint32_t children_that(RowId n, Status stored) const;
    Status tick_if_then_else(RowId n);
    Status tick_while_do_else(RowId n);
    Status tick_question(RowId n);
    Status tick_switch(RowId n, const Row& row);
    RowId chosen_case(RowId n, const Row& row);
    Status tick_try_catch(RowId n, const Row& row);
    Status tick_catch(RowId n, const Row& row);
    void halt_try_catch(RowId n, const Row& row);
    RowId last_child(RowId n, const Row& row) const;
    // Trees: tree_decorators.cpp -----------------------------------------------------------------

    Status tick_keep_running(RowId n);
    Status tick_delay(RowId n, const Row& row);
    Status tick_timeout(RowId n, const Row& row);
    Status tick_run_once(RowId n, const Row& row);
    Status tick_precondition(RowId n, const Row& row);
    Status tick_queue(RowId n, const Row& row, EntryType elements);
    bool next_element(RowId n, const Row& row, EntryType elements, Value& taken,
                      const Value*& element);
    bool write_element(RowId n, SlotId slot, EntryType elements, const Value& element);
    bool split_queue(RowId n, std::string_view text, EntryType elements, Value& queue);
    Status tick_updated(RowId n, const Row& row, Status otherwise);
    bool was_written(const NodeInfo& node);

    // Trees: tree_leaves.cpp ---------------------------------------------------------------------

    Status ticked(RowId n, Status status);
    Status tick_set_blackboard(RowId n, const Row& row);
    bool copy_entry(RowId n, SlotId to, const Value& value);
    Status tick_unset_blackboard(RowId n, const Row& row);
    SlotId named_entry(RowId n, const NodeInfo& node, CodeId port);
    Status tick_sleep(RowId n, const Row& row);
    Status tick_test(RowId n, const Row& row);
    Status finish_test(RowId n, const TestInfo& test);

    // Machines as nodes: tree_machines.cpp -------------------------------------------------------

    Status tick_run_machine(RowId n, const Row& row);
    void start_machine_node(RowId n, const MachineNode& node);
    void share_entries(const MachineNode& node, State& machine);
    bool take_entries(RowId n, const MachineNode& node, State& machine);
    Status status_from(const Value& data, Status otherwise);
    /// What the program says of the <invoke> that runs a machine; null if a <Machine> does.
    const InvokeInfo* invoke_of(const Child& child) const {
        const Row& row = rows_[child.invoke.index];
        return row.op == Op::invoke ? &p_.invokes[row.arg] : nullptr;
    }

    // Leaves: leaves.cpp -------------------------------------------------------------------------

    /// A leaf that may take many ticks. One that has completed and was not reset repeats its result
    /// without being called (TREES §1.3).
    [[gnu::always_inline]] Status tick_action(RowId n, const Row& row) {
        const Status stored = status_[n.index];
        if (is_done(stored)) { return stored; }
        const LeafCall& leaf = p_.calls[row.arg];
        std::byte* self = s_.leaves.data() + leaf.offset;
        if (stored == Status::idle) { refresh(leaf, self); }
        return call(n, leaf, self);
    }
    /// A leaf that answers at once is fresh in every tick.
    [[gnu::always_inline]] Status tick_at_once(RowId n, const Row& row) {
        const LeafCall& leaf = p_.calls[row.arg];
        std::byte* self = s_.leaves.data() + leaf.offset;
        refresh(leaf, self);
        const Status status = call(n, leaf, self);
        return status == Status::running ? did_not_answer(n, leaf) : status;
    }
    Status did_not_answer(RowId n, const LeafCall& leaf);
    /// Ticks a child: the same as tick(n), without the detour for leaves.
    [[gnu::always_inline]] Status tick_child(RowId n) {
        const Row& row = rows_[n.index];
        const bool leaf = row.op == Op::action || row.op == Op::condition;
        if (!leaf || row.conditional || n == ended_ || budget_ < 2) { return tick(n); }
        --budget_;
        const Status status = row.op == Op::action ? tick_action(n, row) : tick_at_once(n, row);
        keep(n, status);
        return status;
    }
    /// Ticks the leaves from `child` on that are entered now and need nothing but their call, as
    /// long as they return `go_on`. Gives the first child that is not one of them; `status` is what
    /// that has returned, still `go_on` if it was not ticked.
    template <Status go_on>
    RowId tick_leaves(RowId child, RowId last, Status& status);
    /// Makes leaves idle that have completed: the rows [begin, end) that tick_leaves() went over.
    void reset_leaves(RowId begin, RowId end) {
        std::fill(status_ + begin.index, status_ + end.index, Status::idle);
    }
    /// Ticks what runs at `n` and was running: the same as tick(n), without the detour for leaves.
    Status tick_again(RowId n) {
        const Row& row = rows_[n.index];
        if (row.op != Op::action || row.conditional) { return tick(n); }
        const LeafCall& leaf = p_.calls[row.arg];
        const Status status = call(n, leaf, s_.leaves.data() + leaf.offset);
        if (status != Status::running) { keep(n, status); }
        return status;
    }
    /// Makes the struct of a leaf what it is on entry.
    void refresh(const LeafCall& leaf, std::byte* self) const {
        if (leaf.fresh_size == 0) { return; }
        std::memcpy(self, p_.prototypes.data() + leaf.prototype, leaf.fresh_size);
    }
    [[gnu::always_inline]] Status call(RowId n, const LeafCall& leaf, std::byte* self) {
        if (leaf.input_count != 0 && !read_inputs(n, leaf, self)) { return Status::idle; }
        s_.last_leaf = n;
        const Status status = leaf.type->tick(self, host_, tick_);
        if (leaf.output_count != 0 && !write_outputs(n, leaf, self)) { return Status::idle; }
        if (status == Status::idle) { return returned_idle(n, leaf); }
        trace_leaf(n, status);
        return status;
    }
    Status returned_idle(RowId n, const LeafCall& leaf);
    void halt_leaf(RowId n);
    void point_inputs(const LeafCall& call, std::byte* self);
    bool read_inputs(RowId n, const LeafCall& call, std::byte* self);
    bool read_input(RowId n, std::uint32_t input, std::byte* self);
    bool write_outputs(RowId n, const LeafCall& call, std::byte* self);

    // Machines: machine_rules.cpp ----------------------------------------------------------------

    Status tick_machine(RowId m);
    Status finish_step(Status status);
    void find_quiet_cycles();
    void come_to_rest();
    void take_waiting();
    void take_external();
    void take_next_external();
    void settle();
    bool spend(std::uint32_t steps);
    void bind(const Event& event);
    void bind_invoke(const Event& event, Value& bound);
    bool microstep(EventId event);
    TransitionId enabled(RowId atom, EventId event);
    bool is_named(const Transition& transition, EventId event) const;
    void select(EventId event);
    void remove_conflicts();
    bool overlap(RowId a, RowId b) const { return p_.within(a, b) || p_.within(b, a); }
    void take(TransitionId id);
    void take_chosen();
    void note(TransitionId id);
    /// Whether the machine has neither reached its end nor failed.
    bool running() const { return !s_.session.final && !s_.fault; }
    /// Whether nothing is left to do before the next external event.
    bool at_rest() const {
        return !p_.has_eventless && s_.session.internal.empty() && s_.session.pending.empty();
    }

    // The active states: configuration.cpp -------------------------------------------------------

    /// A part of Session::active: [first, last).
    struct Slice {
        std::size_t first, last;
    };
    Slice active_below(RowId domain) const;
    RowId domain_of(const Transition& transition) const;
    template <class Visit>
    void visit_targets(const Transition& transition, Visit visit) const;
    void leave_below(RowId domain);
    void leave_all() { leave_below({0}); }
    void record_histories(Slice leaving);
    void leave(RowId n);
    void want_targets(const Transition& transition, RowId top);
    void want(RowId n, RowId top);
    void want_below(RowId n);
    void enter_wanted();
    void activate(const std::vector<RowId>& entering);
    void enter(RowId n, std::uint8_t mark);
    void finish(RowId n);
    bool is_finished(RowId n) const;
    bool is_compound(RowId n) const {
        return rows_[n.index].op == Op::machine ||
               (rows_[n.index].op == Op::state && !p_.state(n).atomic);
    }
    /// The <invoke> rows of a state: they come before its states.
    Children invokes_of(RowId n) const { return children(p_, n).first(p_.state(n).invokes); }

    // Executable content: content.cpp ------------------------------------------------------------

    void run_blocks(std::uint32_t first, std::uint32_t count);
    bool run_block(BlockId block);
    bool run_action(const Action& action);
    bool assign(const Action& action);
    bool initialise(const Action& action);
    bool for_each(const Action& action, BlockId body);
    bool log(const Action& action);
    bool write(const Place& place, const Value& value);
    bool carry(PayloadId payload, Event& event);
    void raise_error(RowId n);
    void raise_error(EventId error, std::string_view why, Value sendid = {});
    void raise(Event event);

    // Messages between sessions: messages.cpp ----------------------------------------------------

    bool send(const Send& send);
    bool fill(const Send& send, Event& event, std::string& target, double& seconds);
    bool cancel(const Action& action);
    bool text_of(CodeId code, std::string& text);
    bool text_of(const LiveText& live, std::string& text);
    void delay(double seconds, std::string_view target, Event event);
    bool deliver(std::string_view target, Event event);
    bool deliver_to_parent(Event event);
    void deliver_due();
    void collect_due(std::vector<Workspace::Due>& due);
    void forward(const Event& event);
    template <class Visit>
    void in_session(std::uint32_t id, Visit visit);

    // Activities: activities.cpp -----------------------------------------------------------------

    void start_invokes();
    void start_invoke(RowId n);
    bool start_machine_of(RowId n, const InvokeInfo& info);
    bool may_nest(RowId n);
    std::optional<MachineId> machine_of(const InvokeInfo& info);
    void add_child(RowId n, MachineId machine, const Value& data);
    /// Runs `run` on an invoked machine: it uses up this one's budget.
    template <class Run>
    void in_child(std::size_t child, Run run) {
        Stepper stepper(*this, s_.children[child]);
        run(stepper);
        budget_ = stepper.budget_;
        if (stepper.s_.fault) { adopt_fault(stepper); }
    }
    void adopt_fault(const Stepper& child);
    bool run_children();
    bool has_waiting(const Program& program, const State& state) const;
    void end_session();
    void stop_invokes(RowId n);
    void stop_child(std::size_t child);
    void tick_invokes();
    void end_invokes();
    void end_invoke(RowId n);
    void pass_params(const InvokeInfo& invoke);
    std::size_t child_of(RowId invoke) const;

    // Shared -------------------------------------------------------------------------------------

    /// The integer that port `port` of a built-in node holds now; false after a fault.
    bool integer_port(RowId n, CodeId code, std::int64_t& result);
    bool boolean_port(RowId n, CodeId code, bool& result);
    /// The status that such a port names; idle after a fault.
    Status status_port(RowId n, CodeId code) { return status_of(n, port_value(code)); }
    Status status_of(RowId n, const Value* name);
    /// What a port holds now, in the state or among the constants; null if it is not given or its
    /// variable has no value.
    const Value* port_value(CodeId code) const;
    bool is_literal(CodeId code) const {
        return p_.code.instructions[code.index].a.space() == Space::constant;
    }
    CodeId port(const NodeInfo& node, std::uint32_t index) const {
        return p_.ports[node.first_port + index];
    }
    /// Counts a write to a variable, for nodes that watch it.
    void count_write(SlotId slot) {
        if (!s_.writes.empty()) { ++s_.writes[slot.index]; }
    }
    /// The tick in which `ms` milliseconds from now are over.
    std::uint64_t tick_after(std::int64_t ms) const;
    /// Evaluates a condition of a machine: one that fails raises error.execution and is false.
    bool holds(RowId n, CodeId code);
    bool holds(RowId n, const Condition& condition);
    /// What forms that need no code read.
    FormView forms() const { return {p_, s_, host_, s_.session.clock, tick_.dt}; }
    /// What expressions see. Filled when a step evaluates its first expression.
    EvalContext& context() {
        if (!context_) { fill_context(); }
        return *context_;
    }
    void fill_context();
    Status fault(Fault::Kind kind, RowId n, std::string message);
    bool run_script(RowId n, CodeId code);
    bool condition(RowId n, CodeId code, bool& holds);
    /// What the last failed evaluation has to say.
    std::string evaluation_error() const;

    void trace_status(RowId n, Status status);
    void trace_leaf(RowId n, Status status) {
        if (trace_ != nullptr) { trace_tick(n, status); }
    }
    void trace_tick(RowId n, Status status);
    void trace(TraceEvent event) {
        if (trace_ == nullptr) { return; }
        event.tick = now();
        if (parent_ != nullptr) {
            event.machine = &p_;
            event.session = s_.session.id;
        }
        trace_->on(event);
    }

    /// The number of this cycle; 0 before the first. Invoked machines live on the outermost's time.
    std::uint64_t now() const { return tick_.count + (outermost_.in_step_ ? 1 : 0); }

    RowId first_child(RowId n) const { return {n.index + 1}; }

    const Program& p_;
    State& s_;
    // the tables that every tick reads, without the detour over their vectors
    const Row* rows_;
    Status* status_;
    std::uint32_t* memory_;
    void* host_;
    TraceSink* trace_;
    Stepper& outermost_;
    Stepper* parent_ = nullptr;        ///< of the machine that invokes this one; else null
    RowId invoked_by_;                 ///< its invoke row
    bool is_mute_ = false;             ///< it was cancelled: what it still sends is dropped
    std::vector<RowId> last_sources_;  ///< of the transitions taken when the budget runs out
    bool while_woken_;
    std::uint32_t budget_;  ///< rows that may still be ticked
    RowId ended_;           ///< row that was ticked already; the next tick of it returns
    Status ended_status_ = Status::idle;  ///< … this
    bool in_step_ = false;                ///< else in start() or halt()
    Tick tick_;
    std::optional<EvalContext> context_;
};

}  // namespace trellis
