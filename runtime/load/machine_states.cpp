// What states have: transitions, where they begin, histories, domains, quiet guards.
// SPDX-License-Identifier: MIT
#include "load/forms.h"
#include "load/machine_compiler.h"
#include "load/words.h"

#include <algorithm>
#include <utility>

namespace trellis {

void MachineCompiler::fill_state(RowId n) {
    Program& program = builder_.program;
    const ElementId e = elements_[n.index];
    StateInfo state;
    state.first_transition = static_cast<std::uint32_t>(program.transitions.size());
    for (const ElementId c : document().children(e)) {
        // one that stands in the root or a final state has been reported
        const bool may_have =
            program.at(n).op == Op::state || program.at(n).op == Op::parallel_state;
        if (may_have && document().name(c) == "transition") { transition(c, n); }
    }
    state.transition_count =
        static_cast<std::uint32_t>(program.transitions.size()) - state.first_transition;

    std::vector<BlockId> entry = data_blocks(e, n);
    const std::vector<BlockId> onentry = blocks(e, "onentry", n);
    entry.insert(entry.end(), onentry.begin(), onentry.end());
    const std::vector<BlockId> onexit = blocks(e, "onexit", n);
    state.first_entry = add_blocks(entry);
    state.entry_count = static_cast<std::uint32_t>(entry.size());
    state.first_exit = add_blocks(onexit);
    state.exit_count = static_cast<std::uint32_t>(onexit.size());

    state.atomic = is_atomic(n);
    if (program.at(n).op != Op::parallel_state) { state.initial = initial_of(n); }
    for (RowId up = program.at(n).parent; up && !state.outer; up = program.at(up).parent) {
        if (program.state(up).transition_count != 0) { state.outer = up; }
    }
    if (program.at(n).op != Op::machine && document().find(e, "id") != nullptr) {
        state.done = event("done.state." + program.names[n.index]);
    }
    for (const RowId c : children(program, n)) {
        state.invokes += program.at(c).op == Op::invoke ? 1U : 0U;
        state.histories += program.at(c).op == Op::history ? 1U : 0U;
    }
    for (const ElementId c : document().children(e)) {
        if (document().name(c) == "donedata") { state.donedata = payload(c, n); }
    }
    program.states[program.at(n).arg] = state;
}

// The only activity in a state and around it, if the interpreter is not needed to tick it.
RowId MachineCompiler::quiet_activity(RowId n) const {
    const Program& program = builder_.program;
    RowId invoke;
    for (RowId at = n; at; at = program.at(at).parent) {
        for (const RowId c : children(program, at).first(program.state(at).invokes)) {
            if (invoke) { return {}; }
            invoke = c;
        }
    }
    // a machine that is invoked has no row below its own
    if (!invoke || program.at(invoke).end.index == invoke.index + 1) { return {}; }
    const RowId body{invoke.index + 1};
    if (program.at(body).op != Op::action) { return {}; }
    const LeafCall& leaf = program.call(body);
    for (std::uint32_t i = 0; i < leaf.input_count; ++i) {
        const LiveInput& input = program.live_inputs[leaf.first_input + i];
        if (!input.formula && !input.steady) { return {}; }
    }
    return leaf.output_count == 0 ? body : RowId();
}

// What the event `tick` asks in a state and around it; nothing if that can need code.
std::optional<std::vector<Condition>> MachineCompiler::guards_of_tick(RowId n) const {
    const Program& program = builder_.program;
    std::vector<Condition> guards;
    for (RowId at = n; at; at = program.state(at).outer) {
        const StateInfo& around = program.state(at);
        for (std::uint32_t i = 0; i < around.transition_count; ++i) {
            const Transition& t = program.transitions[around.first_transition + i];
            bool named = false;
            for (std::uint32_t k = 0; k < t.event_count && program.tick_event; ++k) {
                named = named ||
                        program.matches(program.descriptors[t.first_event + k], program.tick_event);
            }
            const Condition::Form form = t.guard.form;
            const bool needs_code =
                form == Condition::Form::code || form == Condition::Form::always;
            if (t.event_count == 0 || (named && needs_code)) { return {}; }
            if (named) { guards.push_back(t.guard); }
        }
    }
    return guards;
}

void MachineCompiler::find_quiet(RowId n) {
    Program& program = builder_.program;
    if (!program.state(n).atomic) { return; }
    const RowId activity = quiet_activity(n);
    const auto guards = activity ? guards_of_tick(n) : std::nullopt;
    if (!guards) { return; }
    const auto size = [](const auto& table) { return static_cast<std::uint32_t>(table.size()); };
    QuietState quiet{.first_sensor = size(program.quiet_sensors),
                     .first_time = size(program.quiet_times),
                     .first_input = size(program.quiet_inputs),
                     .call = program.at(activity).arg,
                     .activity = activity};
    for (const Condition& guard : *guards) {
        if (guard.form == Condition::Form::sensor) {
            program.quiet_sensors.push_back(guard.at);
        } else {
            program.quiet_times.push_back(guard);
        }
    }
    const LeafCall& leaf = program.calls[quiet.call];
    for (std::uint32_t i = leaf.first_input; i < leaf.first_input + leaf.input_count; ++i) {
        const LiveInput& input = program.live_inputs[i];
        if (input.formula) {
            program.quiet_inputs.push_back({program.formulas[input.formula.index], input.offset});
        }
    }
    quiet.sensor_end = size(program.quiet_sensors);
    quiet.time_end = size(program.quiet_times);
    quiet.input_end = size(program.quiet_inputs);
    program.states[program.at(n).arg].quiet = {size(program.quiet_states)};
    program.quiet_states.push_back(quiet);
}

void MachineCompiler::transition(ElementId e, RowId source) {
    Program& program = builder_.program;
    Transition t{.source = source};
    t.first_event = static_cast<std::uint32_t>(program.descriptors.size());
    if (const Attribute* events = document().find(e, "event"); events != nullptr) {
        for (const std::string_view word : words(document().string(events->value))) {
            program.descriptors.push_back(event(word));
        }
    }
    t.event_count = static_cast<std::uint32_t>(program.descriptors.size()) - t.first_event;
    program.has_eventless |= t.event_count == 0;
    if (t.event_count == 1) {
        t.event_begin = program.descriptors.back();
        t.event_end = program.events[t.event_begin.index].end;
    }
    if (const Attribute* cond = document().find(e, "cond"); cond != nullptr) {
        t.guard = find_condition(program, expression(*cond, source));
    }
    if (const Attribute* target = document().find(e, "target"); target != nullptr) {
        if (add_targets(*target, {0}, t)) {
            t.internal = document().value(e, "type") == "internal" && is_compound(source);
            t.domain = domain_of(t);
            t.internal = t.internal && (t.to_history || t.domain == source);
        }
    }
    if (document().child_count(e) != 0) { t.block = block(e, source); }
    program.transitions.push_back(t);
    transitions_.resize(program.transitions.size());
    transitions_.back() = e;
}

// The states that an attribute names; they must lie inside `inside` and not exclude each other.
bool MachineCompiler::add_targets(const Attribute& attribute, RowId inside, Transition& t) {
    Program& program = builder_.program;
    Diagnostics& diagnostics = builder_.diagnostics();
    t.first_target = static_cast<std::uint32_t>(program.targets.size());
    std::vector<RowId> targets;
    for (const std::string_view word : words(document().string(attribute.value))) {
        const auto found = scope_.states.find(word);
        if (found == scope_.states.end()) {
            std::vector<std::string_view> known;
            for (const auto& [id, n] : scope_.states) {
                known.push_back(id);
            }
            std::sort(known.begin(), known.end());
            diagnostics.error("unknown-state", attribute.value_where,
                              "there is no state \"" + std::string(word) + "\"" +
                                  suggestion(word, known));
            continue;
        }
        if (found->second == inside || !program.within(found->second, inside)) {
            diagnostics.error("initial-outside", attribute.value_where,
                              "\"" + std::string(word) + "\" is not inside \"" +
                                  program.names[inside.index] + "\"");
            continue;
        }
        targets.push_back(found->second);
        t.to_history |= program.at(found->second).op == Op::history;
    }
    // a state around another target is entered on the way to it
    for (const RowId target : targets) {
        const bool around = std::any_of(targets.begin(), targets.end(), [&](RowId other) {
            return other != target && program.within(other, target);
        });
        if (!around) { program.targets.push_back(target); }
    }
    t.target_count = static_cast<std::uint32_t>(program.targets.size()) - t.first_target;
    check_targets(attribute, t);
    return t.target_count != 0;
}

void MachineCompiler::check_targets(const Attribute& attribute, const Transition& t) {
    const Program& program = builder_.program;
    const auto target = [&](std::uint32_t i) { return program.targets[t.first_target + i]; };
    for (std::uint32_t i = 1; i < t.target_count; ++i) {
        for (std::uint32_t k = 0; k < i; ++k) {
            if (can_be_active_together(target(k), target(i))) { continue; }
            builder_.diagnostics().error("illegal-targets", attribute.value_where,
                                         "the states \"" + program.names[target(k).index] +
                                             "\" and \"" + program.names[target(i).index] +
                                             "\" cannot be active together");
            return;
        }
    }
}

// Neither is inside the other: they can if what is around both is a parallel state.
bool MachineCompiler::can_be_active_together(RowId a, RowId b) const {
    const Program& program = builder_.program;
    RowId around = program.at(a).parent;
    while (!program.within(b, around)) {
        around = program.at(around).parent;
    }
    return program.at(around).op == Op::parallel_state;
}

// Where a machine or compound state begins: <initial>, the attribute, or its first state.
TransitionId MachineCompiler::initial_of(RowId n) {
    Program& program = builder_.program;
    const ElementId e = elements_[n.index];
    Transition t{.source = n, .domain = n};
    RowId first;
    const Attribute* target = document().find(e, "initial");
    for (const ElementId c : document().children(e)) {
        if (document().name(c) != "initial" || document().child_count(c) == 0) { continue; }
        const ElementId way = *document().children(c).begin();
        target = document().find(way, "target");
        if (document().child_count(way) != 0) { t.block = block(way, n); }
    }
    for (const RowId c : children(program, n)) {
        if (is_state(c) && !first) { first = c; }
    }
    if (!first) {
        // where something else is wrong, the states may be what could not be read
        if (target != nullptr && builder_.diagnostics().ok()) {
            builder_.diagnostics().error("initial-outside", target->value_where,
                                         "\"" + program.names[n.index] +
                                             "\" has no states to begin in");
        }
        return {};
    }
    if (target != nullptr) {
        if (!add_targets(*target, n, t)) { return {}; }
    } else {
        t.first_target = static_cast<std::uint32_t>(program.targets.size());
        t.target_count = 1;
        program.targets.push_back(first);
    }
    program.transitions.push_back(t);
    return {static_cast<std::uint32_t>(program.transitions.size() - 1)};
}

// Where a history leads while nothing is stored. Histories must not lead to each other in a circle.
void MachineCompiler::fill_history(RowId n) {
    Program& program = builder_.program;
    for (const ElementId c : document().children(elements_[n.index])) {
        const Attribute* const target = document().find(c, "target");
        if (document().name(c) != "transition" || target == nullptr) { continue; }
        Transition t{.source = n};
        if (!add_targets(*target, program.at(n).parent, t)) { return; }
        t.domain = program.at(n).parent;
        if (document().child_count(c) != 0) { t.block = block(c, program.at(n).parent); }
        for (std::uint32_t i = 0; i < t.target_count; ++i) {
            const RowId other = program.targets[t.first_target + i];
            if (program.at(other).op != Op::history) { continue; }
            builder_.diagnostics().error("history-to-history", target->value_where,
                                         "\"" + program.names[n.index] +
                                             "\" leads to the history \"" +
                                             program.names[other.index] + "\", not to a state");
        }
        program.histories[program.at(n).arg].initial = {
            static_cast<std::uint32_t>(program.transitions.size())};
        program.transitions.push_back(t);
    }
}

// The innermost compound state, or the machine, that is around the source and all targets; the
// source itself if the transition is internal and its targets lie inside (SCXML 3.13).
RowId MachineCompiler::domain_of(const Transition& t) const {
    const Program& program = builder_.program;
    const auto around_targets = [&](RowId n) {
        for (std::uint32_t i = 0; i < t.target_count; ++i) {
            const RowId target = program.targets[t.first_target + i];
            if (target == n || !program.within(target, n)) { return false; }
        }
        return true;
    };
    if (t.internal && around_targets(t.source)) { return t.source; }
    RowId n = program.at(t.source).parent;
    while (!is_compound(n) || !around_targets(n)) {
        n = program.at(n).parent;
    }
    return n;
}

// Whether a cycle without events can matter: each one has its `tick`, or an eventless guard reads
// what changes by itself.
void MachineCompiler::find_dependence_on_time() {
    Program& program = builder_.program;
    program.needs_every_cycle = static_cast<bool>(program.tick_event);
    for (const Transition& t : program.transitions) {
        const bool guarded = t.event_count == 0 && t.guard.code && is_state(t.source);
        if (!guarded) { continue; }
        // an expression reaches to its last instruction that no jump passes
        const std::vector<Instruction>& code = program.code.instructions;
        std::size_t furthest = 0;
        for (std::size_t i = t.guard.code.index; i < code.size(); ++i) {
            const Instruction& in = code[i];
            const bool jumps =
                in.op == CodeOp::jump || in.op == CodeOp::jump_if || in.op == CodeOp::jump_unless;
            if (jumps) { furthest = std::max<std::size_t>(furthest, in.extra); }
            const bool changes = in.op >= CodeOp::sensor_boolean && in.op <= CodeOp::elapsed_since;
            program.needs_every_cycle |= changes || in.op == CodeOp::call;
            const bool ends = in.op == CodeOp::fail || (in.last && !jumps);
            if (ends && i >= furthest) { break; }
        }
    }
}

}  // namespace trellis
