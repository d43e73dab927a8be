// How a machine runs one control cycle: SCXML's Appendix D on rows, then the activities of the
// active states (MACHINES, "How a machine runs on a robot"). Entering and leaving states is in
// configuration.cpp. Covered by tests/exec/machine_test.cpp and machine_reference_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

#include <algorithm>
#include <utility>

namespace trellis {

void Stepper::start_machine() {
    const RowId root{0};
    const StateInfo& machine = p_.state(root);
    s_.started = true;
    store(root, Status::running);
    run_blocks(machine.first_entry, machine.entry_count);
    want_targets(p_.transitions[machine.initial.index], root);
    enter_wanted();
    settle();
}

// One control cycle: due events, the event `tick`, run to completion, then the activities.
Status Stepper::tick_machine(RowId m) {
    Session& session = s_.session;
    if (!s_.started) { start_machine(); }
    deliver_due();
    come_to_rest();
    if (s_.fault) { return Status::idle; }
    if (session.final) {
        leave_all();
        store(m, Status::idle);
        return p_.name(session.final) == "failure" ? Status::failure : Status::success;
    }
    tick_invokes();
    return s_.fault ? Status::idle : Status::running;
}

// Everything that this machine and those it invokes can do before time goes on. A machine that has
// not begun this cycle begins it with what was waiting and with its `tick`.
void Stepper::come_to_rest() {
    const bool begins = parent_ == nullptr || s_.tick != now();
    if (begins) { take_waiting(); }
    if (parent_ != nullptr) { s_.tick = now(); }
    take_external();
    while (running() && !s_.children.empty() && run_children()) {
        take_external();
    }
}

// What was waiting comes before this cycle's tick, what arises now comes after it.
void Stepper::take_waiting() {
    Session& session = s_.session;
    if (!at_rest()) { settle(); }
    for (std::size_t waiting = session.external.size() - session.external_next;
         waiting != 0 && running(); --waiting) {
        take_next_external();
    }
    if (p_.tick_event && running()) {
        bind({.name = p_.tick_event, .type = Event::Type::external});
        microstep(p_.tick_event);
        if (!at_rest()) { settle(); }
    }
}

void Stepper::take_external() {
    while (!s_.session.external.empty() && running()) {
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
    const bool is_current = event.invoke && event.activation == memory_[event.invoke.index];
    // the end of an activity whose state was left and entered again is nobody's business
    if (event.completes && !is_current) { return; }
    bind(event);
    if (is_current) {
        const InvokeInfo& invoke = p_.invokes[rows_[event.invoke.index].arg];
        const bool active = status_[rows_[event.invoke.index].parent.index] == Status::running;
        if (invoke.finalize && active) { run_block(invoke.finalize); }
    }
    if (!s_.children.empty()) { forward(event); }
    microstep(event.name);
    settle();
}

// The rest of a macrostep: eventless transitions and internal events, until neither is left; then
// what the states that were entered and not left invoke (SCXML 3.13, 6.4).
void Stepper::settle() {
    Session& session = s_.session;
    while (running() && spend(1)) {
        if (p_.has_eventless && microstep({})) { continue; }
        if (session.internal.empty()) {
            if (session.pending.empty()) { break; }
            start_invokes();
            continue;
        }
        const Event event = std::move(session.internal[session.internal_next++]);
        if (session.internal_next == session.internal.size()) {
            session.internal.clear();
            session.internal_next = 0;
        }
        bind(event);
        microstep(event.name);
    }
}

// Takes `steps` from the budget of this cycle; false, and a fault that names the loop, if it is
// used up. An eventless transition whose guard fails raises errors for ever, for example.
bool Stepper::spend(std::uint32_t steps) {
    if (budget_ > steps) {
        budget_ -= steps;
        return true;
    }
    std::string names;
    for (const RowId n : last_sources_) {
        const char* const joint = names.empty() ? ", again and again from " : ", ";
        names += joint + ('"' + std::string(p_.name(n)) + '"');
    }
    fault(Fault::Kind::livelock, s_.session.atom,
          "this machine does not come to rest: too many events and transitions in one cycle" +
              names);
    return false;
}

// Makes an event what `_event` means until the next one (SCXML 5.10.1). Written in place, so that
// events without data allocate nothing.
void Stepper::bind(const Event& event) {
    trace({.kind = TraceEvent::Kind::event, .row = {0}, .event = event.name});
    if (!p_.event_slot) { return; }
    static constexpr std::string_view types[] = {"internal", "external", "platform"};
    Value& bound = s_.slots[p_.event_slot.index];
    if (!bound.is(Value::Kind::object)) { bound.set_object(); }
    bound.flat_member("name").set_text(event.unknown.is(Value::Kind::text)
                                           ? event.unknown.as_text()
                                           : p_.events[event.name.index].text);
    bound.flat_member("type").set_text(types[static_cast<std::size_t>(event.type)]);
    bound.flat_member("sendid") = event.sendid;
    if (event.origin != 0) {
        bound.flat_member("origin").set_text(session_address(event.origin));
        bound.flat_member("origintype").set_text(event_processor);
    } else {
        bound.flat_member("origin").set_undefined();
        bound.flat_member("origintype").set_undefined();
    }
    bound.flat_member("invokeid") = event.invokeid;
    bound.set_member("data", event.data);
    if (event.invoke) { bind_invoke(event, bound); }
    bound.flat_member("raw") = event.raw;
}

// What an event of an activity says besides: which one, and how a leaf or tree has ended.
void Stepper::bind_invoke(const Event& event, Value& bound) {
    const InvokeInfo& invoke = p_.invokes[rows_[event.invoke.index].arg];
    bound.flat_member("invokeid").set_text(invoke.id);
    if (!event.completes || event.name == invoke.done) { return; }
    Value data = Value::object();
    data.set_member("status",
                    Value::text(event.name == invoke.done_success ? "success" : "failure"));
    bound.set_member("data", std::move(data));
}

// Selection ---------------------------------------------------------------------------------------

// Takes the transitions that the event (none: no event) enables; false if there are none.
bool Stepper::microstep(EventId event) {
    if (!p_.has_parallel) {
        const TransitionId chosen = enabled(s_.session.atom, event);
        if (!chosen) { return false; }
        take(chosen);
        return true;
    }
    if (!spend(static_cast<std::uint32_t>(s_.session.active.size() / 16))) { return false; }
    select(event);
    if (s_.work.chosen.empty()) { return false; }
    take_chosen();
    return true;
}

// For each active atomic state, in document order, the first transition enabled from there
// outwards; then without those that others preempt.
void Stepper::select(EventId event) {
    std::vector<Workspace::Choice>& chosen = s_.work.chosen;
    chosen.clear();
    for (const RowId n : s_.session.active) {
        if (!p_.state(n).atomic) { continue; }
        const TransitionId id = enabled(n, event);
        if (!id) { continue; }
        const Transition& transition = p_.transitions[id.index];
        // one of a state around it may have been chosen from another region
        const auto same = [id](const Workspace::Choice& c) { return c.id == id; };
        if (transition.source != n && std::any_of(chosen.rbegin(), chosen.rend(), same)) {
            continue;
        }
        chosen.push_back({id, domain_of(transition)});
    }
    if (chosen.size() > 1) { remove_conflicts(); }
}

// Two transitions conflict if they leave a common state: if one's domain lies in the other's
// (removeConflictingTransitions). Domains of those kept are disjoint and in document order, so a
// transition conflicts with the last of them or with none. Targetless ones leave nothing.
void Stepper::remove_conflicts() {
    std::vector<Workspace::Choice>& chosen = s_.work.chosen;
    const auto source = [this](const Workspace::Choice& c) {
        return p_.transitions[c.id.index].source;
    };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const Workspace::Choice choice = chosen[i];
        std::size_t first = kept;  // of those that may conflict
        bool preempted = false;
        for (; choice.domain && first != 0 && !preempted; --first) {
            const Workspace::Choice& other = chosen[first - 1];
            if (!other.domain) { continue; }
            if (!overlap(choice.domain, other.domain)) { break; }
            preempted =
                source(choice) == source(other) || !p_.within(source(choice), source(other));
        }
        if (preempted) { continue; }
        const auto conflicts = [&](const Workspace::Choice& other) {
            return choice.domain && other.domain && overlap(choice.domain, other.domain);
        };
        const auto end = chosen.begin() + static_cast<std::ptrdiff_t>(kept);
        const auto begin = chosen.begin() + static_cast<std::ptrdiff_t>(first);
        kept = static_cast<std::size_t>(std::remove_if(begin, end, conflicts) - chosen.begin());
        chosen[kept++] = choice;
    }
    chosen.resize(kept);
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

// Taking transitions ------------------------------------------------------------------------------

// Leaves, does, enters (SCXML 3.13).
void Stepper::take(TransitionId id) {
    const Transition& transition = p_.transitions[id.index];
    note(id);
    const RowId domain = domain_of(transition);
    if (domain) { leave_below(domain); }
    if (transition.block) { run_block(transition.block); }
    if (domain) {
        want_targets(transition, domain);
        enter_wanted();
    }
}

// The same over a whole set: leaves all, does all, enters all.
void Stepper::take_chosen() {
    const std::vector<Workspace::Choice>& chosen = s_.work.chosen;
    for (const Workspace::Choice& choice : chosen) {
        note(choice.id);
    }
    for (std::size_t i = chosen.size(); i != 0; --i) {
        if (chosen[i - 1].domain) { leave_below(chosen[i - 1].domain); }
    }
    for (const Workspace::Choice& choice : chosen) {
        const BlockId block = p_.transitions[choice.id.index].block;
        if (block) { run_block(block); }
    }
    for (const Workspace::Choice& choice : chosen) {
        if (choice.domain) { want_targets(p_.transitions[choice.id.index], choice.domain); }
    }
    enter_wanted();
}

// Tells who listens, and remembers where the last transitions came from in case they never end.
void Stepper::note(TransitionId id) {
    const RowId source = p_.transitions[id.index].source;
    trace({.kind = TraceEvent::Kind::transition, .row = source, .transition = id});
    constexpr std::uint32_t nearly_used_up = 64;
    constexpr std::size_t most_names = 6;
    if (budget_ > nearly_used_up || last_sources_.size() == most_names) { return; }
    if (std::find(last_sources_.begin(), last_sources_.end(), source) == last_sources_.end()) {
        last_sources_.push_back(source);
    }
}

}  // namespace trellis
