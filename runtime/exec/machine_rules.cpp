// How a machine runs one control cycle: SCXML's Appendix D on rows, then the activities of the
// active states (MACHINES, "How a machine runs on a robot"). Entering and leaving states is in
// configuration.cpp. Covered by tests/exec/machine_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/evaluate_rules.h"
#include "exec/stepper.h"

#include <utility>

namespace trellis {

void Stepper::start_machine() {
    const RowId root{0};
    s_.started = true;
    store(root, Status::running);
    run_blocks(p_.state(root).first_entry, p_.state(root).entry_count);
    take_initial(root);
    settle();
}

// One control cycle: due events, the event `tick`, run to completion, then the activities.
Status Stepper::tick_machine(RowId m) {
    Session& session = s_.session;
    if (!s_.started) { start_machine(); }
    take_events();
    if (s_.fault) { return Status::idle; }
    if (session.final) {
        leave_all();
        store(m, Status::idle);
        return p_.name(session.final) == "failure" ? Status::failure : Status::success;
    }
    ++session.clock;
    if (context_) { context_->cycle = session.clock; }
    tick_invokes();
    return s_.fault ? Status::idle : Status::running;
}

// The quiet cycle (quiet_cycle.cpp) has ticked the only activity, which is a leaf.
Status Stepper::finish_quiet_cycle(Status status) {
    in_step_ = true;
    const RowId body = s_.last_leaf;
    if (status == Status::idle) {
        returned_idle(body, p_.call(body));
    } else if (is_done(status)) {
        store(body, status);
        end_invokes();
    }
    return finish_step(s_.fault ? Status::idle : Status::running);
}

void Stepper::take_events() {
    Session& session = s_.session;
    if (!at_rest()) { settle(); }
    // what was waiting comes before this cycle's tick, what arises now comes after it
    for (std::size_t waiting = session.external.size() - session.external_next;
         waiting != 0 && running(); --waiting) {
        take_next_external();
    }
    if (p_.tick_event && running()) {
        bind({.name = p_.tick_event, .type = Event::Type::external});
        microstep(p_.tick_event);
        if (!at_rest()) { settle(); }
    }
    while (!session.external.empty() && running()) {
        take_next_external();
    }
}

void Stepper::take_next_external() {
    Session& session = s_.session;
    const Event event = std::move(session.external[session.external_next++]);
    if (session.external_next == session.external.size()) {
        session.external.clear();
        session.external_next = 0;
    }
    // the end of an activity whose state was left and entered again is nobody's business
    if (event.invoke && event.activation != memory_[event.invoke.index]) { return; }
    bind(event);
    microstep(event.name);
    settle();
}

// Eventless transitions and internal events, until neither is left: the rest of a macrostep. Each
// round costs budget, because an eventless transition whose guard fails raises errors for ever.
void Stepper::settle() {
    Session& session = s_.session;
    while (running()) {
        if (--budget_ == 0) {
            fault(Fault::Kind::livelock, session.atom,
                  "this machine does not come to rest: too many events and transitions in one "
                  "cycle");
            return;
        }
        if (p_.has_eventless && microstep({})) { continue; }
        if (session.internal.empty()) { break; }
        const Event event = std::move(session.internal[session.internal_next++]);
        if (session.internal_next == session.internal.size()) {
            session.internal.clear();
            session.internal_next = 0;
        }
        bind(event);
        microstep(event.name);
    }
}

// Makes an event what `_event` means until the next one (SCXML 5.10.1). Written in place, so that
// events without data allocate nothing.
void Stepper::bind(const Event& event) {
    trace({.kind = TraceEvent::Kind::event, .row = {0}, .event = event.name});
    if (!p_.event_slot) { return; }
    static constexpr std::string_view types[] = {"internal", "external", "platform"};
    Value& bound = s_.slots[p_.event_slot.index];
    if (!bound.is(Value::Kind::object)) {
        bound.set_object();
        for (const std::string_view unset : {"name", "type", "sendid", "origin", "origintype"}) {
            bound.set_member(unset, {});
        }
    }
    bound.flat_member("name").set_text(event.unknown.is(Value::Kind::text)
                                           ? event.unknown.as_text()
                                           : p_.events[event.name.index].text);
    bound.flat_member("type").set_text(types[static_cast<std::size_t>(event.type)]);
    if (event.invoke) {
        const InvokeInfo& invoke = p_.invokes[rows_[event.invoke.index].arg];
        bound.flat_member("invokeid").set_text(invoke.id);
        Value data = Value::object();
        data.set_member("status",
                        Value::text(event.name == invoke.done_success ? "success" : "failure"));
        bound.set_member("data", std::move(data));
    } else {
        bound.flat_member("invokeid").set_undefined();
        bound.set_member("data", event.data);
    }
}

// Selection ---------------------------------------------------------------------------------------

// Takes the transition that the event (none: no event) enables; false if there is none.
bool Stepper::microstep(EventId event) {
    const TransitionId chosen = enabled(s_.session.atom, event);
    if (!chosen) { return false; }
    take(p_.transitions[chosen.index], chosen);
    return true;
}

// The first enabled transition from the atomic state outwards, in document order (SCXML 3.13).
TransitionId Stepper::enabled(RowId atom, EventId event) {
    const Transition* const transitions = p_.transitions.data();
    for (RowId n = atom; n;) {
        const StateInfo& state = p_.states[rows_[n.index].arg];
        n = state.outer;
        const std::uint32_t end = state.first_transition + state.transition_count;
        for (std::uint32_t i = state.first_transition; i != end; ++i) {
            const Transition& transition = transitions[i];
            const bool named = event ? is_named(transition, event) : transition.event_count == 0;
            if (named && holds(transition.source, transition.guard)) { return {i}; }
        }
    }
    return {};
}

bool Stepper::holds(RowId n, const Condition& condition) {
    const Answer known = answer(forms(), condition);
    if (known != Answer::unknown) { return known == Answer::yes; }
    if (condition.derived) { derive(condition.derived.index); }
    return holds(n, condition.code);
}

// A condition that fails raises error.execution and is false (SCXML 5.9.1).
bool Stepper::holds(RowId n, CodeId code) {
    const Truth truth = evaluate_condition(p_.code, code, context());
    if (truth == Truth::failed) { raise_error(n); }
    return truth == Truth::yes;
}

// Most transitions have one descriptor, whose interval is at hand.
bool Stepper::is_named(const Transition& transition, EventId event) const {
    if (transition.event_count < 2) {
        return transition.event_begin <= event && event < transition.event_end;
    }
    for (std::uint32_t i = 0; i < transition.event_count; ++i) {
        if (p_.matches(p_.descriptors[transition.first_event + i], event)) { return true; }
    }
    return false;
}

// Leaves, does, enters: in this order over the whole set (SCXML 3.13).
void Stepper::take(const Transition& transition, TransitionId id) {
    trace({.kind = TraceEvent::Kind::transition, .row = transition.source, .transition = id});
    if (transition.domain) { leave_below(transition.domain); }
    if (transition.block) { run_block(transition.block); }
    enter_targets(transition);
}

// Executable content ------------------------------------------------------------------------------

void Stepper::run_blocks(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        run_block(p_.blocks[first + i]);
    }
}

// Runs a block; an error in it raises error.execution and ends it, and only it (SCXML 4.1).
void Stepper::run_block(BlockId block) {
    for (std::uint32_t i = block.index;; ++i) {
        const Action& action = p_.actions[i];
        switch (action.kind) {
        case Action::Kind::end: return;
        case Action::Kind::run:
            if (!execute(p_.code, action.code, context())) { return raise_error({0}); }
            break;
        case Action::Kind::assign:
            if (!assign(action)) { return raise_error({0}); }
            break;
        case Action::Kind::initialise:
            if (!initialise(action)) { return raise_error({0}); }
            break;
        case Action::Kind::raise: s_.session.internal.push_back({.name = action.event}); break;
        case Action::Kind::log:
            if (!log(action)) { return raise_error({0}); }
            break;
        case Action::Kind::unless:
            if (!holds({0}, action.code)) { i = action.go_to.index - 1; }
            break;
        case Action::Kind::jump: i = action.go_to.index - 1; break;
        }
    }
}

// To a variable directly; to a place below one through the temporary that its code stores.
bool Stepper::assign(const Action& action) {
    if (action.slot) {
        return evaluate(p_.code, action.code, context(), s_.slots[action.slot.index]);
    }
    return evaluate(p_.code, action.code, context(), s_.temporaries[stored_temporary]) &&
           execute(p_.code, action.store, context());
}

// Gives a variable its first value, once, unless the host has given it one (SCXML 5.3).
bool Stepper::initialise(const Action& action) {
    EntryType& entry = s_.entries[action.slot.index];
    if (entry != EntryType::missing) { return true; }
    entry = EntryType::any;
    Value& variable = s_.slots[action.slot.index];
    if (evaluate(p_.code, action.code, context(), variable)) { return true; }
    variable.set_undefined();
    return false;
}

bool Stepper::log(const Action& action) {
    Value value;
    if (action.code && !evaluate(p_.code, action.code, context(), value)) { return false; }
    if (trace_ == nullptr) { return true; }
    std::string text = p_.labels[action.label];
    if (action.code) {
        if (!text.empty()) { text += ": "; }
        append_text(text, value);
    }
    trace({.kind = TraceEvent::Kind::log, .row = s_.session.atom, .text = text});
    return true;
}

void Stepper::raise_error(RowId n) {
    s_.session.internal.push_back({.name = p_.error_event, .type = Event::Type::platform});
    if (trace_ == nullptr) { return; }
    const std::string text = evaluation_error();
    trace({.kind = TraceEvent::Kind::error, .row = n, .text = text});
}

// Activities --------------------------------------------------------------------------------------

// Ticks what runs in the active states, in document order.
void Stepper::tick_invokes() {
    bool ended = false;
    for (const RowId n : s_.session.invokes) {
        const RowId body = first_child(n);
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
        if (is_done(status_[first_child(n).index])) { end_invoke(n); }
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
                                   .activation = memory_[n.index]});
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
