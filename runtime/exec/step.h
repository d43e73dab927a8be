// One control cycle: the only entrance to the interpreter. Tree rules are in tree_rules.cpp,
// machine rules in machine_rules.cpp. Covered by tests/exec; compared with obvious references in
// tests/exec/tree_reference_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "core/state.h"
#include "core/status.h"
#include "core/trace.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trellis {

struct StepOptions {
    double dt = 1.0 / 60.0;      ///< s, length of a tick
    TraceSink* trace = nullptr;  ///< null: do not trace
    /// Trees: tick again within the step while the root runs and a node asks for it, as
    /// tickOnce() of BehaviorTree.CPP does; else exactly once.
    bool while_woken = false;
    std::uint32_t budget = 0;  ///< rows ticked in one step; 0: 100,000 + 64 per row
};

/// Enters the initial states of a machine, so that its configuration can be seen before the first
/// step; nothing to do for a tree. step() does it if it was not done.
void start(const Program& program, State& state, HostRef host, const StepOptions& options = {});

/// Runs one tick. Trees: the status of the root; after success or failure the next step starts it
/// again. Machines: running until a top-level final state is reached, then success, or failure if
/// the final state's id is "failure". Idle if the tick ended in a fault, which is in `state`.
/// `host` must be of the type that the program's leaves were registered for. Allocates nothing once
/// the buffers of `state` have grown to what the behaviour needs.
Status step(const Program& program, State& state, HostRef host, const StepOptions& options = {});

/// Puts an event into the external queue of a machine, as if sent by the host. An unknown name
/// matches what its longest known prefix matches. Nothing to do for a tree.
void send(const Program& program, State& state, std::string_view event, Value data = {});

/// The number of an event, for hosts that send it often: none if no part of the machine names it.
EventId find_event(const Program& program, std::string_view name);
/// The same as sending it by its name, without data. `event` must be one that find_event() found.
void send(const Program& program, State& state, EventId event);

/// The number of cycles that can pass before one in which a machine does something: 0 if the next
/// one may; nothing if none will, without an event from the host. For hosts without a robot.
std::optional<std::uint64_t> idle_cycles(const Program& program, const State& state);

/// Lets so many cycles pass as if they had been stepped: at most idle_cycles().
void skip_cycles(State& state, std::uint64_t cycles);

/// Halts everything: leaves that run are told, states are left (their onexit content runs).
void halt(const Program& program, State& state, HostRef host, const StepOptions& options = {});

/// "file:line:column: error: …" for the fault of `state`; empty if it has none.
std::string describe_fault(const Program& program, const State& state);

}  // namespace trellis
