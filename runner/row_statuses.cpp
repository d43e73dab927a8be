// Which of several statuses in a tick counts.
// SPDX-License-Identifier: MIT
#include "runner/row_statuses.h"

namespace trellis {

bool is_end(const Program& program, RowId n) {
    const Row& row = program.at(n);
    return row.op == Op::final && program.at(row.parent).op == Op::machine;
}

void RowStatuses::on(const TraceEvent& event) {
    if (event.machine != nullptr) { return; }  // of an invoked machine: other rows
    const auto show = [&](Status status) {
        Row& row = rows_[event.row.index];
        row.shown = status;
        row.tick = event.tick;
        row.reached = true;
    };
    const auto skipped = [&] {
        const Row& row = rows_[event.row.index];
        return row.tick == event.tick && row.shown == Status::skipped;
    };
    switch (event.kind) {
    case TraceEvent::Kind::status:
        if (event.to == Status::idle && is_end(*program_, event.row)) { break; }
        rows_[event.row.index].stored = event.to;
        // one that is made idle keeps showing how it ended in this tick; a node that was skipped
        // may still be stored as running
        if (event.to != Status::idle || (event.from == Status::running && !skipped())) {
            show(event.to);
        }
        break;
    case TraceEvent::Kind::tick: show(event.to); break;
    case TraceEvent::Kind::skip: show(Status::skipped); break;
    case TraceEvent::Kind::transition: taken_[event.transition.index] = event.tick; break;
    case TraceEvent::Kind::halt:  // followed by its status
    case TraceEvent::Kind::enter:
    case TraceEvent::Kind::leave:
    case TraceEvent::Kind::event:
    case TraceEvent::Kind::log:
    case TraceEvent::Kind::error: break;
    }
}

}  // namespace trellis
