// What states invoke: leaves and trees, ticked once per cycle, and machines, which are sessions
// inside this one (SCXML 6.4, MACHINES). Covered by tests/exec/invoke_test.cpp and
// invoked_machine_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace trellis {

Stepper::Stepper(Stepper& parent, Child& child)
    : p_(program_of(parent.outermost_.p_, child)), s_(child.state), rows_(p_.rows.data()),
      status_(s_.status.data()), memory_(s_.memory.data()), host_(parent.host_),
      trace_(parent.trace_), outermost_(parent.outermost_), parent_(&parent),
      invoked_by_(child.invoke), is_mute_(parent.is_mute_), while_woken_(parent.while_woken_),
      budget_(parent.budget_), tick_(parent.tick_) {}

// What went wrong in an invoked machine is this one's too.
void Stepper::adopt_fault(const Stepper& child) {
    const Fault& wrong = child.s_.fault;
    const std::string place = wrong.row ? std::string(child.p_.name(wrong.row)) + ": " : "";
    fault(wrong.kind, child.invoked_by_, "in its machine: " + place + wrong.message);
}

std::size_t Stepper::child_of(RowId invoke) const {
    const auto found =
        std::lower_bound(s_.children.begin(), s_.children.end(), invoke,
                         [](const Child& child, RowId row) { return child.invoke < row; });
    return static_cast<std::size_t>(found - s_.children.begin());
}

// Beginning ---------------------------------------------------------------------------------------

// Starts, in document order, what the states invoke that were entered and not left in this
// macrostep.
void Stepper::start_invokes() {
    std::vector<RowId>& pending = s_.session.pending;
    std::sort(pending.begin(), pending.end());
    for (std::size_t i = 0; i < pending.size() && running(); ++i) {
        start_invoke(pending[i]);
    }
    pending.clear();
}

void Stepper::start_invoke(RowId n) {
    ++memory_[n.index];
    const bool is_machine = rows_[n.index].end == first_child(n);
    const InvokeInfo& info = p_.invokes[rows_[n.index].arg];
    if (is_machine && !start_machine_of(n, info)) { return; }
    store(n, Status::running);
    std::vector<RowId>& invokes = s_.session.invokes;
    invokes.insert(std::upper_bound(invokes.begin(), invokes.end(), n), n);
}

// Starts a machine and lets it come to rest. False if it does not run then: it could not be
// started, which has raised an error, or has ended.
bool Stepper::start_machine_of(RowId n, const InvokeInfo& info) {
    std::string type;
    if (info.type && !text_of(info.type, type)) { return raise_error(n), false; }
    if (info.type && !is_machine_type(type)) {
        raise_error(p_.error_event, '"' + type + "\" cannot be invoked");
        return false;
    }
    if (info.id_place && !write(info.id_place, Value::text(info.id))) {
        return raise_error(n), false;
    }
    const std::optional<MachineId> machine = machine_of(info);
    Event given;
    if (!machine || !carry(info.payload, given)) { return false; }
    if (!may_nest(n)) { return false; }
    add_child(n, *machine, given.data);
    const std::size_t child = child_of(n);
    in_child(child, [](Stepper& session) {
        session.start_machine();
        session.end_session();
    });
    if (!s_.children[child].state.session.final) { return true; }
    s_.children.erase(s_.children.begin() + static_cast<std::ptrdiff_t>(child));
    return false;
}

bool Stepper::may_nest(RowId n) {
    std::uint32_t depth = 1;
    for (const Stepper* around = parent_; around != nullptr; around = around->parent_) {
        ++depth;
    }
    if (depth != max_session_depth) { return true; }
    fault(Fault::Kind::budget, n,
          "machines invoke each other " + std::to_string(max_session_depth) + " deep");
    return false;
}

// None, after an error, if the source cannot be evaluated or was not known when loading.
std::optional<MachineId> Stepper::machine_of(const InvokeInfo& info) {
    if (info.machine) { return info.machine; }
    std::string source;
    if (!text_of(info.source, source)) {
        raise_error({0});
        return {};
    }
    const std::vector<MachineSource>& sources = p_.sources;
    const auto found = std::lower_bound(
        sources.begin(), sources.end(), source,
        [](const MachineSource& known, const std::string& text) { return known.source < text; });
    if (found != sources.end() && found->source == source) { return found->machine; }
    raise_error(p_.communication_event,
                "the machine \"" + source + "\" was not known when this one was loaded");
    return {};
}

// A session of its own, with the values that it is given for its top-level <data> (SCXML 6.4.4).
void Stepper::add_child(RowId n, MachineId machine, const Value& data) {
    const auto place = s_.children.begin() + static_cast<std::ptrdiff_t>(child_of(n));
    const Program& program = outermost_.p_.machines[machine.index];
    State& state =
        s_.children.insert(place, {.invoke = n, .machine = machine, .state = fresh_state(program)})
            ->state;
    state.tick = now();
    const std::uint32_t id = ++outermost_.s_.session.sessions;
    state.session.id = id;
    if (program.session_slot) {
        state.slots[program.session_slot.index].set_text("s" + std::to_string(id));
    }
    if (program.processors_slot) {
        Value location = Value::object();
        location.set_member("location", Value::text(session_address(id)));
        Value& processors = state.slots[program.processors_slot.index];
        processors.set_member("scxml", location);
        processors.set_member(event_processor, location);
    }
    for (const SlotId slot : program.parameters) {
        const Value* value =
            data.is(Value::Kind::object) ? data.member(program.slots[slot.index].name) : nullptr;
        if (value == nullptr) { continue; }
        state.slots[slot.index] = *value;
        state.entries[slot.index] = EntryType::any;
    }
}

// Running and ending ------------------------------------------------------------------------------

// Lets every invoked machine come to rest. True if some of them, or this one, has events again.
bool Stepper::run_children() {
    for (std::size_t i = 0; i < s_.children.size() && !s_.fault;) {
        // a <Machine> runs when its tree is ticked
        if (invoke_of(s_.children[i]) == nullptr) {
            ++i;
            continue;
        }
        in_child(i, [](Stepper& child) {
            child.come_to_rest();
            child.end_session();
        });
        if (s_.children[i].state.session.final) {
            const RowId invoke = s_.children[i].invoke;
            store(invoke, Status::idle);
            std::erase(s_.session.invokes, invoke);
            s_.children.erase(s_.children.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
            ++i;
        }
    }
    return has_waiting(p_, s_);
}

// Whether a session here has events that it has not taken.
bool Stepper::has_waiting(const Program& program, const State& state) const {
    return !state.session.external.empty() ||
           std::any_of(state.children.begin(), state.children.end(), [&](const Child& child) {
               return program.at(child.invoke).op == Op::invoke &&
                      has_waiting(program_of(outermost_.p_, child), child.state);
           });
}

// The end of an invoked machine that has reached it: done.invoke.ID is the last that its invoker
// hears of it (SCXML 6.4.3).
void Stepper::end_session() {
    const RowId final = s_.session.final;
    if (!final || s_.fault) { return; }
    leave_all();
    const InvokeInfo& info = parent_->p_.invokes[parent_->rows_[invoked_by_.index].arg];
    Event event{.name = info.done,
                .type = Event::Type::external,
                .invoke = invoked_by_,
                .activation = parent_->memory_[invoked_by_.index],
                .completes = true,
                .origin = s_.session.id};
    if (!carry(p_.state(final).donedata, event)) { event.data.set_undefined(); }
    parent_->s_.session.external.push_back(std::move(event));
}

// A machine that is stopped leaves its states, and sends nothing any more.
void Stepper::stop_child(std::size_t child) {
    in_child(child, [](Stepper& session) {
        session.is_mute_ = true;
        session.leave_all();
    });
    s_.children.erase(s_.children.begin() + static_cast<std::ptrdiff_t>(child));
}

// Ends what a state invokes that is left.
void Stepper::stop_invokes(RowId n) {
    const auto inside = [&](RowId invoke) { return p_.within(invoke, n); };
    for (const RowId invoke : invokes_of(n)) {
        const std::size_t child = child_of(invoke);
        if (child != s_.children.size() && s_.children[child].invoke == invoke) {
            stop_child(child);
        }
        reset(invoke);
    }
    std::erase_if(s_.session.invokes, inside);
    std::erase_if(s_.session.pending, inside);
}

// Ticking -----------------------------------------------------------------------------------------

// Ticks what runs in the active states, in document order.
void Stepper::tick_invokes() {
    ++s_.session.clock;
    if (context_) { context_->cycle = s_.session.clock; }
    bool ended = false;
    for (const RowId n : s_.session.invokes) {
        const RowId body = first_child(n);
        if (rows_[n.index].end == body) {
            in_child(child_of(n), [](Stepper& child) { child.tick_invokes(); });
            if (s_.fault) { return; }
            continue;
        }
        if (rows_[body.index].op == Op::tree) { pass_params(p_.invokes[rows_[n.index].arg]); }
        const Status status =
            status_[body.index] == Status::running ? tick_again(body) : tick(body);
        if (status == Status::idle) { return; }
        ended = ended || is_done(status);
    }
    if (ended) { end_invokes(); }
}

void Stepper::end_invokes() {
    for (const RowId n : s_.session.invokes) {
        const RowId body = first_child(n);
        if (rows_[n.index].end != body && is_done(status_[body.index])) { end_invoke(n); }
    }
    std::erase_if(s_.session.invokes, [&](RowId n) { return status_[n.index] != Status::running; });
}

// What ends is told to the next cycle.
void Stepper::end_invoke(RowId n) {
    const Status status = status_[first_child(n).index];
    reset(first_child(n));
    store(n, status);
    const InvokeInfo& invoke = p_.invokes[rows_[n.index].arg];
    const bool success = status == Status::success;
    s_.session.external.push_back({.name = success ? invoke.done_success : invoke.done_failure,
                                   .type = Event::Type::external,
                                   .invoke = n,
                                   .activation = memory_[n.index],
                                   .completes = true});
}

// Gives a tree the current values of its parameters; one that fails keeps its last value.
void Stepper::pass_params(const InvokeInfo& invoke) {
    for (std::uint32_t i = 0; i < invoke.param_count; ++i) {
        const InvokeParam& param = p_.params[invoke.first_param + i];
        if (evaluate(p_.code, param.code, context(), s_.slots[param.slot.index])) {
            s_.entries[param.slot.index] = EntryType::any;
        } else {
            raise_error({0});
        }
    }
}

}  // namespace trellis
