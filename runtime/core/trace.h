// What happened during a run, in the order it happened: one kind of record for trees and machines.
// Writing it to files is the runner's work. Covered by tests/exec/trace_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/status.h"

#include <cstdint>
#include <string_view>

namespace trellis {

struct Program;

struct TraceEvent {
    enum class Kind : std::uint8_t {
        status,      ///< the stored status of `row` went from `from` to `to`
        tick,        ///< a leaf was ticked and returned `to` (which may be skipped)
        halt,        ///< a leaf was halted while running
        skip,        ///< a node returned skipped, which is never stored: its status stays
        enter,       ///< a state became active
        leave,       ///< a state stopped being active
        transition,  ///< `transition` of state `row` was taken
        event,       ///< `event` was taken from a queue of machine `row`
        log,         ///< a <log>: `text` is "label: value"
        error,       ///< an expression failed and raised error.execution; `text` says why
    };
    std::uint64_t tick = 0;  ///< the tick during which it happened; the first is 1, 0 is the start
    Kind kind = Kind::status;
    RowId row = {};
    Status from = Status::idle;
    Status to = Status::idle;
    TransitionId transition = {};
    EventId event = {};
    /// Of which machine: whose rows, transitions and events these are. Null: of the program that is
    /// stepped; else of one of its Program::machines, running as session `session`.
    const Program* machine = nullptr;
    std::uint32_t session = 1;
    std::string_view text = {};  ///< valid during the call of TraceSink::on
};

/// "status", "tick", "halt", …
std::string_view name_of(TraceEvent::Kind kind);

/// Receives every TraceEvent of a run.
class TraceSink {
public:
    virtual ~TraceSink() = default;
    virtual void on(const TraceEvent& event) = 0;
};

}  // namespace trellis
