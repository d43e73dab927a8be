// The same as microstep() in machine_rules.cpp and what it calls, for transitions that only move.
// SPDX-License-Identifier: MIT
#include "exec/plain_events.h"

namespace trellis {

namespace {

bool is_named(const Program& program, const Transition& transition, EventId event) {
    if (transition.event_count < 2) {
        return transition.event_begin <= event && event < transition.event_end;
    }
    for (std::uint32_t i = 0; i < transition.event_count; ++i) {
        if (program.matches(program.descriptors[transition.first_event + i], event)) {
            return true;
        }
    }
    return false;
}

/// What a state and those around it say to an event.
struct Found {
    bool known = true;  ///< else a guard needs code, or a transition does more
    TransitionId id;    ///< none: nothing is enabled
};

Found enabled(const FormView& view, RowId atom, EventId event) {
    const Program& program = view.program;
    const Row* const rows = program.rows.data();
    const Transition* const transitions = program.transitions.data();
    for (RowId n = atom; n;) {
        const StateInfo& state = program.states[rows[n.index].arg];
        n = state.outer;
        const std::uint32_t end = state.first_transition + state.transition_count;
        for (std::uint32_t i = state.first_transition; i != end; ++i) {
            const Transition& transition = transitions[i];
            if (!is_named(program, transition, event)) { continue; }
            const Answer guard = answer(view, transition.guard);
            if (guard == Answer::no) { continue; }
            return {.known = guard == Answer::yes && transition.only_moves, .id = {i}};
        }
    }
    return {};
}

/// Adds to Workspace::chosen what is enabled at an atomic state. Domains must be disjoint and in
/// document order; false if there is more to decide.
bool choose(const FormView& view, State& state, RowId atom, EventId event) {
    const Program& program = view.program;
    std::vector<Workspace::Choice>& chosen = state.work.chosen;
    const Found found = enabled(view, atom, event);
    if (!found.id || !found.known) { return found.known; }
    const Transition& transition = program.transitions[found.id.index];
    // one of a state around it may be enabled from several regions
    if (program.has_parallel && transition.source != atom) { return false; }
    if (!transition.domain) { return true; }
    if (!chosen.empty() && transition.domain < program.at(chosen.back().domain).end) {
        return false;
    }
    chosen.push_back({found.id, transition.domain});
    return true;
}

bool choose_all(const FormView& view, State& state, EventId event) {
    const Program& program = view.program;
    state.work.chosen.clear();
    if (!program.has_parallel) { return choose(view, state, state.session.atom, event); }
    for (const RowId n : state.session.active) {
        if (program.state(n).atomic && !choose(view, state, n, event)) { return false; }
    }
    return true;
}

/// Finds what each of the chosen leaves. False if one of these states does more than end.
bool leaves_silently(const Program& program, State& state) {
    const std::vector<RowId>& active = state.session.active;
    auto at = static_cast<std::uint32_t>(active.size());
    std::vector<Workspace::Choice>& chosen = state.work.chosen;
    for (auto choice = chosen.rbegin(); choice != chosen.rend(); ++choice) {
        const RowId end = program.at(choice->domain).end;
        while (at != 0 && !(active[at - 1] < end)) {
            --at;
        }
        choice->last = at;
        for (; at != 0 && choice->domain < active[at - 1]; --at) {
            if (!program.state(active[at - 1]).silent) { return false; }
        }
        choice->first = at;
    }
    return true;
}

/// Puts the rows that a transition enters in the place of those it leaves.
void move(const Program& program, State& state, const Workspace::Choice& choice) {
    std::vector<RowId>& active = state.session.active;
    for (std::uint32_t i = choice.first; i != choice.last; ++i) {
        state.status[active[i].index] = Status::idle;
    }
    const Transition& transition = program.transitions[choice.id.index];
    const std::uint32_t left = choice.last - choice.first;
    const std::uint32_t count = transition.entered_count;
    const auto place = active.begin() + choice.first;
    if (count < left) { active.erase(place, place + (left - count)); }
    if (count > left) { active.insert(place, count - left, RowId()); }
    for (std::uint32_t i = 0; i != count; ++i) {
        const RowId n = program.entered[transition.first_entered + i];
        active[choice.first + i] = n;
        state.status[n.index] = Status::running;
        state.memory[n.index] = state.session.clock;
    }
}

}  // namespace

QuietStep take_plain_events(const Program& program, State& state, HostRef host,
                            const StepOptions& options) {
    Session& session = state.session;
    if (options.trace != nullptr || !state.started || session.final || !session.internal.empty() ||
        !session.pending.empty() || !session.delayed.empty()) {
        return {};
    }
    const FormView view{program, state, host.object, session.clock, options.dt};
    while (session.external_next != session.external.size()) {
        const Event& event = session.external[session.external_next];
        if (event.invoke || !choose_all(view, state, event.name) ||
            !leaves_silently(program, state)) {
            return {};
        }
        // from the last on, so that places before it stay what they are
        const std::vector<Workspace::Choice>& chosen = state.work.chosen;
        for (auto choice = chosen.rbegin(); choice != chosen.rend(); ++choice) {
            move(program, state, *choice);
        }
        session.atom = session.active.back();
        ++session.external_next;
    }
    session.external.clear();
    session.external_next = 0;
    ++session.clock;
    return {true, Status::running};
}

}  // namespace trellis
