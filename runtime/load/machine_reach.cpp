// Entering as SCXML's Appendix D does it, for all transitions that can fire at once.
// SPDX-License-Identifier: MIT
#include "load/machine_reach.h"

#include "load/forms.h"

#include <cstdint>

namespace trellis {

namespace {

bool is_literal(const Program& program, const Transition& transition, bool truth) {
    const Value* const value = literal_of(program.code, transition.guard.code);
    return value != nullptr && value->is(Value::Kind::boolean) && value->as_boolean() == truth;
}

bool has_states(Op op) {
    return op == Op::machine || op == Op::state || op == Op::parallel_state || op == Op::final;
}

class Reach {
public:
    explicit Reach(const Program& program) : program_(program) {}

    MachineReach find() {
        const std::size_t rows = program_.rows.size();
        found_.entered.resize(rows);
        found_.instead.resize(program_.transitions.size());
        by_default_.resize(rows);
        through_.resize(rows);
        find_parents();
        find_instead();
        enter(RowId{0});
        while (!fresh_.empty()) {
            const RowId n = fresh_.back();
            fresh_.pop_back();
            take_all(n);
        }
        return std::move(found_);
    }

private:
    // transitions that never fire
    void find_parents();
    void find_instead();
    TransitionId eventless_of(const StateInfo& state) const;
    TransitionId covered(const Transition& t, const std::vector<TransitionId>& taken) const;
    // entering
    void take_all(RowId n);
    void activate(RowId n);
    void enter(RowId n);
    void enter_targets(const Transition& t, RowId domain);

    const Program& program_;
    MachineReach found_;
    std::vector<EventId> prefixes_;  // by event: the longest other name that is its prefix
    std::vector<bool> by_default_;   // by row: entered with what it begins with
    std::vector<RowId> through_;     // by parallel row: the only child not entered so; itself: none
    std::vector<RowId> fresh_;       // active, transitions not looked at yet
};

// Transitions that never fire ---------------------------------------------------------------------

void Reach::find_parents() {
    prefixes_.resize(program_.events.size());
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < program_.events.size(); ++i) {
        while (!open.empty() && program_.events[open.back()].end.index <= i) {
            open.pop_back();
        }
        if (!open.empty()) { prefixes_[i] = {open.back()}; }
        open.push_back(i);
    }
}

TransitionId Reach::eventless_of(const StateInfo& state) const {
    for (std::uint32_t i = 0; i < state.transition_count; ++i) {
        const TransitionId id{state.first_transition + i};
        const Transition& t = program_.transitions[id.index];
        if (t.event_count == 0 && is_unguarded(program_, t)) { return id; }
    }
    return {};
}

// The transition that answers the last of the events of `t`, if earlier ones answer all of them.
TransitionId Reach::covered(const Transition& t, const std::vector<TransitionId>& taken) const {
    TransitionId earlier;
    for (std::uint32_t i = 0; i < t.event_count; ++i) {
        earlier = {};
        for (EventId at = program_.descriptors[t.first_event + i]; at && !earlier;
             at = prefixes_[at.index]) {
            earlier = taken[at.index];
        }
        if (!earlier) { return {}; }
    }
    return earlier;
}

// While a transition without event and condition is enabled, no event is looked at.
void Reach::find_instead() {
    std::vector<TransitionId> always(program_.rows.size());   // by row: in it or around it
    std::vector<TransitionId> taken(program_.events.size());  // by descriptor, in this state
    for (std::uint32_t n = 0; n < program_.rows.size(); ++n) {
        const Row& row = program_.rows[n];
        if (!has_states(row.op)) { continue; }
        const StateInfo& state = program_.states[row.arg];
        const TransitionId own = eventless_of(state);
        if (row.parent) { always[n] = always[row.parent.index]; }
        if (own) { always[n] = own; }
        for (std::uint32_t i = 0; i < state.transition_count; ++i) {
            const TransitionId id{state.first_transition + i};
            const Transition& t = program_.transitions[id.index];
            TransitionId& instead = found_.instead[id.index];
            if (is_literal(program_, t, false)) {
                instead = id;
            } else if (t.event_count == 0) {
                if (own && own < id) { instead = own; }
            } else {
                instead = always[n] ? always[n] : covered(t, taken);
            }
            for (std::uint32_t k = 0; k < t.event_count && is_unguarded(program_, t); ++k) {
                TransitionId& first = taken[program_.descriptors[t.first_event + k].index];
                if (!first) { first = id; }
            }
        }
        // only this state's transitions are among each other
        for (std::uint32_t i = 0; i < state.transition_count; ++i) {
            const Transition& t = program_.transitions[state.first_transition + i];
            for (std::uint32_t k = 0; k < t.event_count; ++k) {
                taken[program_.descriptors[t.first_event + k].index] = {};
            }
        }
    }
}

// Entering ----------------------------------------------------------------------------------------

void Reach::take_all(RowId n) {
    const StateInfo& state = program_.state(n);
    for (std::uint32_t i = 0; i < state.transition_count; ++i) {
        const std::uint32_t id = state.first_transition + i;
        const Transition& t = program_.transitions[id];
        if (!found_.instead[id] && t.target_count != 0) { enter_targets(t, t.domain); }
    }
}

void Reach::activate(RowId n) {
    if (found_.entered[n.index]) { return; }
    found_.entered[n.index] = true;
    if (has_states(program_.at(n).op)) { fresh_.push_back(n); }
}

// With all that it begins with: initial states, every region, what a history leads to at first.
void Reach::enter(RowId n) {
    if (by_default_[n.index]) { return; }
    by_default_[n.index] = true;
    activate(n);
    const Row& row = program_.at(n);
    if (row.op == Op::history) {
        const TransitionId initial = program_.histories[row.arg].initial;
        if (initial) { enter_targets(program_.transitions[initial.index], row.parent); }
        return;
    }
    const TransitionId initial = program_.state(n).initial;
    if (initial) { enter_targets(program_.transitions[initial.index], n); }
    if (row.op != Op::parallel_state) { return; }
    for (const RowId child : children(program_, n)) {
        if (has_states(program_.at(child).op)) { enter(child); }
    }
}

// The targets, and what is around them up to `domain`: of a parallel state the other regions begin
// as they do by themselves. Of several targets in one it is not looked which of the regions have
// one.
void Reach::enter_targets(const Transition& t, RowId domain) {
    for (std::uint32_t i = 0; i < t.target_count; ++i) {
        RowId inner = program_.targets[t.first_target + i];
        enter(inner);
        for (RowId n = program_.at(inner).parent; n && n != domain; n = program_.at(n).parent) {
            activate(n);
            RowId& through = through_[n.index];
            const bool regions = program_.at(n).op == Op::parallel_state && through != n;
            if (regions && through != inner) {
                // the second way in is another: now every region was one of the others
                const RowId spared = through || t.target_count != 1 ? RowId() : inner;
                through = spared ? inner : n;
                for (const RowId child : children(program_, n)) {
                    const bool is_region = has_states(program_.at(child).op);
                    if (is_region && child != spared) { enter(child); }
                }
            }
            inner = n;
        }
    }
}

}  // namespace

bool is_unguarded(const Program& program, const Transition& transition) {
    return !transition.guard.code || is_literal(program, transition, true);
}

MachineReach find_reach(const Program& program) {
    return Reach(program).find();
}

}  // namespace trellis
