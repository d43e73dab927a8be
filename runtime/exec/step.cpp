// The public functions of the interpreter: each makes a Stepper for one call.
// SPDX-License-Identifier: MIT
#include "exec/step.h"

#include "exec/plain_events.h"
#include "exec/quiet_step.h"
#include "exec/stepper.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace trellis {

namespace {

[[maybe_unused]] bool fits(const Program& program, const State& state, const HostRef& host) {
    return state.status.size() == program.rows.size() && !state.fault &&
           (program.host == nullptr || program.host->tag == host.tag);
}

}  // namespace

void start(const Program& program, State& state, HostRef host, const StepOptions& options) {
    assert(fits(program, state, host));
    if (!program.is_machine() || state.started) { return; }
    Stepper(program, state, host, options).start_machine();
}

namespace {

// Apart from step(), because setting up the interpreter takes a frame of its own.
[[gnu::noinline]] Status whole_step(const Program& program, State& state, HostRef host,
                                    const StepOptions& options, QuietStep quiet) {
    Stepper stepper(program, state, host, options);
    return quiet.taken ? stepper.finish_quiet_step(quiet.status) : stepper.step_root();
}

}  // namespace

Status step(const Program& program, State& state, HostRef host, const StepOptions& options) {
    assert(fits(program, state, host));
    const QuietStep quiet = state.quiet.cycles != 0 ? quiet_cycle(program, state, host, options)
                            : program.takes_plain_events
                                ? take_plain_events(program, state, host, options)
                                : quiet_tick(program, state, host, options);
    if (!quiet.taken || quiet.status != Status::running || state.random.exhausted()) [[unlikely]] {
        return whole_step(program, state, host, options, quiet);
    }
    ++state.tick;
    return Status::running;
}

void halt(const Program& program, State& state, HostRef host, const StepOptions& options) {
    assert(fits(program, state, host));
    Stepper(program, state, host, options).halt_root();
}

EventId find_event(const Program& program, std::string_view name) {
    const Event event = event_named(program, name);
    return event.unknown.is(Value::Kind::text) ? EventId() : event.name;
}

void send(const Program& program, State& state, EventId event) {
    assert(program.is_machine() && event.index < program.events.size());
    static_cast<void>(program);
    Event& sent = state.session.external.emplace_back();
    sent.name = event;
    sent.type = Event::Type::external;
}

void send(const Program& program, State& state, std::string_view event, Value data) {
    if (!program.is_machine()) { return; }
    Event named = event_named(program, event);
    named.data = std::move(data);
    state.session.external.push_back(std::move(named));
}

namespace {

/// Whether a session does something in every cycle, or in the next one.
bool is_busy(const Program& program, const State& state) {
    const Session& session = state.session;
    const bool has_activity =
        std::any_of(session.invokes.begin(), session.invokes.end(),
                    [&](RowId n) { return program.at(n).end.index != n.index + 1; });
    return !state.started || program.needs_every_cycle || has_activity ||
           !session.external.empty() || !session.internal.empty() || !session.pending.empty();
}

/// The cycles before the first in which this session or one inside it does something; `never` if
/// there is none.
constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

std::uint64_t idle_cycles(const Program& outermost, const Program& program, const State& state,
                          std::uint64_t next) {
    if (is_busy(program, state)) { return 0; }
    std::uint64_t idle = never;
    if (!state.session.delayed.empty()) {
        const std::uint64_t due = state.session.delayed.front().due;
        idle = due > next ? due - next : 0;
    }
    for (const Child& child : state.children) {
        idle =
            std::min(idle, idle_cycles(outermost, program_of(outermost, child), child.state, next));
    }
    return idle;
}

}  // namespace

std::optional<std::uint64_t> idle_cycles(const Program& program, const State& state) {
    if (!program.is_machine()) { return 0; }
    if (state.session.final) { return {}; }
    const std::uint64_t idle = idle_cycles(program, program, state, state.tick + 1);
    return idle == never ? std::nullopt : std::optional(idle);
}

void skip_cycles(State& state, std::uint64_t cycles) {
    wake(state);
    state.tick += cycles;
    state.session.clock += static_cast<std::uint32_t>(cycles);
    for (Child& child : state.children) {
        skip_cycles(child.state, cycles);
    }
}

std::string describe_fault(const Program& program, const State& state) {
    if (!state.fault) { return {}; }
    std::string out;
    const RowId n = state.fault.row;
    if (n && program.origins[n.index].line != 0) {
        const Origin& origin = program.origins[n.index];
        out = program.files[origin.file] + ':' + std::to_string(origin.line) + ':' +
              std::to_string(origin.column) + ": ";
    }
    out += "error: ";
    if (n) { out += std::string(program.name(n)) + ": "; }
    return out + state.fault.message + " (tick " + std::to_string(state.tick + 1) + ')';
}

}  // namespace trellis
