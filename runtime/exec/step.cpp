// The public functions of the interpreter: each makes a Stepper for one call.
// SPDX-License-Identifier: MIT
#include "exec/step.h"

#include "exec/quiet_cycle.h"
#include "exec/stepper.h"

#include <cassert>

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

Status step(const Program& program, State& state, HostRef host, const StepOptions& options) {
    assert(fits(program, state, host));
    if (program.is_machine()) {
        const QuietCycle cycle = quiet_cycle(program, state, host, options);
        if (cycle.outcome == QuietCycle::Outcome::running && !state.random.exhausted()) {
            ++state.tick;
            return Status::running;
        }
        if (cycle.outcome != QuietCycle::Outcome::not_quiet) {
            return Stepper(program, state, host, options).finish_quiet_cycle(cycle.status);
        }
    }
    return Stepper(program, state, host, options).step_root();
}

void halt(const Program& program, State& state, HostRef host, const StepOptions& options) {
    assert(fits(program, state, host));
    Stepper(program, state, host, options).halt_root();
}

// The name is looked up token by token, so an unknown one ends at its longest known prefix.
void send(const Program& program, State& state, std::string_view event, Value data) {
    if (!program.is_machine()) { return; }
    EventId name{0};
    for (EventId at{1}; at < program.events[0].end;) {
        const EventName& known = program.events[at.index];
        const bool prefix = event.starts_with(known.text) &&
                            (event.size() == known.text.size() || event[known.text.size()] == '.');
        if (prefix) {
            name = at;
            at = {at.index + 1};
        } else {
            at = known.end;
        }
        if (at >= program.events[name.index].end) { break; }
    }
    const bool known = program.events[name.index].text == event;
    state.session.external.push_back({.name = name,
                                      .unknown = known ? Value() : Value::text(event),
                                      .type = Event::Type::external,
                                      .data = std::move(data)});
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
