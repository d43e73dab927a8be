// The findings of machine_reach.h in words, and what names of events tell by themselves.
// SPDX-License-Identifier: MIT
#include "load/machine_checks.h"

#include "load/event_names.h"
#include "load/machine_reach.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

namespace {

/// The event of the platform that `name` was probably meant for: one of its first two words is
/// right, the other nearly. Empty if there is none, or if it is one.
std::string meant_for(std::string_view name) {
    static constexpr std::pair<std::string_view, std::string_view> events[] = {
        {"done", "state"},
        {"done", "invoke"},
        {"error", "execution"},
        {"error", "communication"},
        {"error", "platform"}};
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos) { return {}; }
    const std::string_view first = name.substr(0, dot);
    const std::size_t end = std::min(name.find('.', dot + 1), name.size());
    const std::string_view second = name.substr(dot + 1, end - dot - 1);
    std::string meant;
    for (const auto& [one, two] : events) {
        if (first == one && second == two) { return {}; }
        const bool nearly = (first == one && !closest(second, {two}).empty()) ||
                            (second == two && !closest(first, {one}).empty());
        if (nearly && meant.empty()) {
            meant = std::string(one) + '.' + std::string(two) + std::string(name.substr(end));
        }
    }
    return meant;
}

class Checks {
public:
    Checks(const CheckedMachine& machine, Diagnostics& diagnostics)
        : machine_(machine), program_(machine.program), diagnostics_(diagnostics),
          reach_(find_reach(machine.program)) {}

    void all() {
        states();
        ends();
        transitions();
        done_events();
        platform_events();
        if (!machine_.forwards_events) { raised_events(); }
        if (program_.has_eventless && !program_.has_parallel) { cycles(); }
    }

private:
    void states();
    void ends();
    void transitions();
    void done_events();
    void platform_events();
    void raised_events();
    void cycles();

    bool has_way_out(RowId n) const;
    std::vector<bool> raised() const;
    std::string why_not_done(std::string_view event) const;
    TransitionId next_of(RowId atomic) const;
    RowId state_after(TransitionId id) const;
    void report_cycle(TransitionId id, RowId state);

    bool is_state(RowId n) const {
        const Op op = program_.at(n).op;
        return op == Op::state || op == Op::parallel_state || op == Op::final;
    }
    const Attribute* attribute(ElementId e, std::string_view name) const {
        return machine_.document.find(e, name);
    }
    /// Whether any event from `first` to before `last` is one of those that `sums` counts.
    static bool any(const std::vector<std::uint32_t>& sums, std::uint32_t first,
                    std::uint32_t last) {
        return sums[last] != sums[first];
    }

    const CheckedMachine& machine_;
    const Program& program_;
    Diagnostics& diagnostics_;
    const MachineReach reach_;
};

// States and transitions --------------------------------------------------------------------------

void Checks::states() {
    for (RowId n{1}; n.index < machine_.rows.size();) {
        if (!is_state(n) || reach_.entered[n.index]) {
            ++n.index;
            continue;
        }
        diagnostics_.warning(
            "never-entered", machine_.document.at(machine_.rows[n.index]).where,
            "the state \"" + std::string(program_.name(n)) +
                "\" is never entered: no transition that can be taken leads there");
        n = program_.at(n).end;
    }
}

// Where a machine is meant to end, in a top-level <final>, a state without a way out keeps it from
// that. A machine without one may mean to stay where it is; so may a region, which others leave.
void Checks::ends() {
    bool ends = false;
    for (const RowId n : children(program_, RowId{0})) {
        ends |= program_.at(n).op == Op::final;
    }
    std::vector<bool> left(machine_.rows.size());  // by row: a transition may lead out of it
    for (RowId n{1}; ends && n.index < machine_.rows.size(); ++n.index) {
        const RowId parent = program_.at(n).parent;
        if (!is_state(n)) { continue; }
        left[n.index] = left[parent.index] || has_way_out(n);
        const bool stays = program_.at(n).op == Op::state && program_.state(n).atomic &&
                           reach_.entered[n.index] && !left[n.index];
        if (!stays) { continue; }
        diagnostics_.warning("no-way-out", machine_.document.at(machine_.rows[n.index]).where,
                             "the state \"" + std::string(program_.name(n)) +
                                 "\" is not final, but no transition leads out of it");
    }
}

bool Checks::has_way_out(RowId n) const {
    const StateInfo& state = program_.state(n);
    bool out = program_.at(n).op == Op::parallel_state;
    for (std::uint32_t i = 0; i < state.transition_count && !out; ++i) {
        const TransitionId id{state.first_transition + i};
        out = program_.transitions[id.index].target_count != 0 && !reach_.instead[id.index];
    }
    return out;
}

void Checks::transitions() {
    for (std::uint32_t i = 0; i < reach_.instead.size(); ++i) {
        const TransitionId instead = reach_.instead[i];
        // cond="false" is written to switch a transition off: its author knows
        if (!instead || instead.index == i || !machine_.transitions[i]) { continue; }
        const Where first = machine_.document.at(machine_.transitions[instead.index]).where;
        diagnostics_.warning("never-taken", machine_.document.at(machine_.transitions[i]).where,
                             "this transition is never taken: the one in line " +
                                 std::to_string(first.line) + " always comes first");
    }
}

// Events ------------------------------------------------------------------------------------------

// By event: whether something in the machine, or the platform because of it, raises it.
std::vector<bool> Checks::raised() const {
    std::vector<bool> raised(program_.events.size());
    const auto raise = [&](EventId event) {
        if (event) { raised[event.index] = true; }
    };
    for (std::uint32_t n = 0; n < machine_.rows.size(); ++n) {
        const Row& row = program_.rows[n];
        if (row.op == Op::parallel_state) { raise(program_.states[row.arg].done); }
        if (row.op == Op::final && row.parent && is_state(row.parent)) {
            raise(program_.state(row.parent).done);
        }
        if (row.op != Op::invoke) { continue; }
        raise(program_.invokes[row.arg].done);
        raise(program_.invokes[row.arg].done_success);
        raise(program_.invokes[row.arg].done_failure);
    }
    for (const ElementId e : machine_.raises) {
        raise(EventNames::find(program_.events, machine_.document.value(e, "event")));
    }
    return raised;
}

// done.state.ID and done.invoke.ID: nobody else may use these names (SCXML 3.12.1).
void Checks::done_events() {
    if (machine_.computes_events) { return; }
    const std::vector<bool> raised = this->raised();
    std::vector<std::uint32_t> sums(raised.size() + 1);
    std::vector<std::string_view> known;
    std::size_t told = 0;
    for (std::uint32_t i = 0; i < raised.size(); ++i) {
        sums[i + 1] = sums[i] + (raised[i] ? 1U : 0U);
        if (raised[i]) { known.push_back(program_.events[i].text); }
    }
    for (std::uint32_t i = 0; i < machine_.transitions.size(); ++i) {
        if (!machine_.transitions[i]) { continue; }
        const Transition& t = program_.transitions[i];
        for (std::uint32_t k = 0; k < t.event_count; ++k) {
            const EventId event = program_.descriptors[t.first_event + k];
            const EventName& name = program_.events[event.index];
            const bool done =
                name.text.starts_with("done.state.") || name.text.starts_with("done.invoke.");
            if (!done || any(sums, event.index, name.end.index)) { continue; }
            if (++told > Diagnostics::most + 1) { return; }  // nobody sees more
            const std::string why = why_not_done(name.text);
            const Attribute* const written = attribute(machine_.transitions[i], "event");
            diagnostics_.warning("never-raised", written->value_where,
                                 "nothing raises \"" + name.text + '"' +
                                     (why.empty() ? suggestion(name.text, known) : why));
        }
    }
}

std::string Checks::why_not_done(std::string_view event) const {
    constexpr std::string_view prefix = "done.state.";
    if (!event.starts_with(prefix)) { return {}; }
    event.remove_prefix(prefix.size());
    for (std::uint32_t n = 1; n < machine_.rows.size(); ++n) {
        if (is_state(RowId{n}) && program_.name(RowId{n}) == event) {
            return ": the state \"" + std::string(event) + "\" has no final state inside";
        }
    }
    return {};
}

// done.state.ID, done.invoke.ID and error.REASON are the platform's names: one that is nearly so,
// and that nothing here raises, is a slip.
void Checks::platform_events() {
    if (machine_.computes_events) { return; }
    const std::vector<bool> raised = this->raised();
    for (std::uint32_t i = 0; i < machine_.transitions.size(); ++i) {
        if (!machine_.transitions[i]) { continue; }
        const Transition& t = program_.transitions[i];
        for (std::uint32_t k = 0; k < t.event_count; ++k) {
            const EventId event = program_.descriptors[t.first_event + k];
            const std::string& name = program_.events[event.index].text;
            const std::string meant = raised[event.index] ? std::string() : meant_for(name);
            if (meant.empty()) { continue; }
            diagnostics_.warning(
                "never-raised", attribute(machine_.transitions[i], "event")->value_where,
                "nothing raises \"" + name + "\"; did you mean \"" + meant + "\"?");
        }
    }
}

// What <raise>, and <send> without a target, put into the machine's own queues.
void Checks::raised_events() {
    std::vector<std::uint32_t> answered(program_.events.size() + 1);  // differences, then numbers
    std::vector<std::string_view> known;
    for (std::uint32_t i = 0; i < machine_.transitions.size(); ++i) {
        if (!machine_.transitions[i]) { continue; }
        const Transition& t = program_.transitions[i];
        for (std::uint32_t k = 0; k < t.event_count; ++k) {
            const EventId event = program_.descriptors[t.first_event + k];
            ++answered[event.index];
            --answered[program_.events[event.index].end.index];
            known.push_back(program_.events[event.index].text);
        }
    }
    for (std::size_t i = 1; i < answered.size(); ++i) {
        answered[i] += answered[i - 1];
    }
    std::size_t told = 0;
    for (const ElementId e : machine_.raises) {
        const Attribute* const written = attribute(e, "event");
        if (written == nullptr) { continue; }
        const std::string_view name = machine_.document.string(written->value);
        const EventId event = EventNames::find(program_.events, name);
        if (!event || answered[event.index] != 0) { continue; }
        if (++told > Diagnostics::most + 1) { return; }  // nobody sees more
        diagnostics_.warning("unmatched-event", written->value_where,
                             "no transition is for the event \"" + std::string(name) + '"' +
                                 suggestion(name, known));
    }
}

// Cycles ------------------------------------------------------------------------------------------

// The eventless transition that is certainly taken in an atomic state; none if a condition decides.
TransitionId Checks::next_of(RowId atomic) const {
    for (RowId n = atomic; n; n = program_.at(n).parent) {
        const StateInfo& state = program_.state(n);
        for (std::uint32_t i = 0; i < state.transition_count; ++i) {
            const TransitionId id{state.first_transition + i};
            const Transition& t = program_.transitions[id.index];
            if (t.event_count != 0 || reach_.instead[id.index] == id) { continue; }
            return is_unguarded(program_, t) ? id : TransitionId();
        }
    }
    return {};
}

// The atomic state that a transition leads to; none if that depends on a history.
RowId Checks::state_after(TransitionId id) const {
    for (;;) {
        const Transition& t = program_.transitions[id.index];
        if (t.target_count != 1) { return {}; }
        const RowId target = program_.targets[t.first_target];
        if (!is_state(target)) { return {}; }
        const StateInfo& state = program_.state(target);
        if (state.atomic) { return target; }
        id = state.initial;
    }
}

// Without parallel states one atomic state is active, and has at most one that certainly follows:
// each is looked at once.
void Checks::cycles() {
    enum : std::uint32_t { unseen = 0 };
    std::vector<std::uint32_t> seen(machine_.rows.size(), unseen);  // in which walk
    for (std::uint32_t walk = 1; walk < machine_.rows.size(); ++walk) {
        RowId n{walk};
        const bool begins =
            is_state(n) && program_.state(n).atomic && reach_.entered[n.index] && !seen[n.index];
        while (begins && n && seen[n.index] == unseen) {
            seen[n.index] = walk;
            const TransitionId id = next_of(n);
            if (!id) { break; }
            const bool stays = program_.transitions[id.index].target_count == 0;
            const RowId next = stays ? n : state_after(id);
            if (next && seen[next.index] == walk) { report_cycle(id, next); }
            n = next;
        }
    }
}

void Checks::report_cycle(TransitionId id, RowId state) {
    diagnostics_.warning("never-rests", machine_.document.at(machine_.transitions[id.index]).where,
                         "transitions without event and condition lead from \"" +
                             std::string(program_.name(state)) + "\" back to it, without end");
}

}  // namespace

void check_machine(const CheckedMachine& machine, Diagnostics& diagnostics) {
    Checks(machine, diagnostics).all();
}

}  // namespace trellis
