// Intervals of ticks, from changes of statuses.
// SPDX-License-Identifier: MIT
#include "runner/profile.h"

#include "runner/row_statuses.h"

#include <algorithm>

namespace trellis {

Profile::Profile(const Program& program)
    : program_(&program), rows_(program.rows.size()), running_(program.rows.size()),
      taken_(program.transitions.size()) {}

void Profile::on(const TraceEvent& event) {
    if (event.machine != nullptr) { return; }  // of an invoked machine: other rows
    switch (event.kind) {
    case TraceEvent::Kind::status: on_status(event); break;
    case TraceEvent::Kind::tick: on_leaf(event); break;
    case TraceEvent::Kind::skip: ++rows_[event.row.index].skips; break;
    case TraceEvent::Kind::transition: ++taken_[event.transition.index]; break;
    case TraceEvent::Kind::halt:  // follows from the status
    case TraceEvent::Kind::enter:
    case TraceEvent::Kind::leave:
    case TraceEvent::Kind::event:
    case TraceEvent::Kind::log:
    case TraceEvent::Kind::error: break;
    }
}

// A node runs in the tick in which it ends. One that is halted does not run in that tick, and a
// state that is left is not active at its end.
void Profile::on_status(const TraceEvent& event) {
    if (event.to == Status::idle && is_end(*program_, event.row)) { return; }
    Row& row = rows_[event.row.index];
    Running& running = running_[event.row.index];
    const std::uint64_t tick = std::max<std::uint64_t>(event.tick, 1);
    if (event.from == Status::idle) { ++row.entered; }
    const bool halted = event.from == Status::running && event.to == Status::idle;
    if (halted) { ++row.halts; }
    // a leaf says itself when it is ticked and what it returns
    if (is_leaf(event.row)) { return; }
    if (event.to == Status::success) { ++row.successes; }
    if (event.to == Status::failure) { ++row.failures; }
    if (event.from == Status::running && running.since != 0) {
        count(event.row, running.since, halted ? tick - 1 : tick);
        running.since = 0;
    } else if (is_done(event.to)) {
        count(event.row, tick, tick);
    }
    if (event.to == Status::running) { running.since = tick; }
}

void Profile::on_leaf(const TraceEvent& event) {
    Row& row = rows_[event.row.index];
    if (event.to == Status::success) { ++row.successes; }
    if (event.to == Status::failure) { ++row.failures; }
    count(event.row, event.tick, event.tick);
}

void Profile::count(RowId n, std::uint64_t first, std::uint64_t last) {
    std::uint64_t& counted = running_[n.index].counted;
    first = std::max(first, counted + 1);
    if (last < first) { return; }
    rows_[n.index].ticks += last - first + 1;
    counted = last;
}

void Profile::finish(std::uint64_t last_tick) {
    for (std::uint32_t i = 0; i < rows_.size(); ++i) {
        if (running_[i].since != 0) { count({i}, running_[i].since, last_tick); }
    }
}

bool Profile::is_leaf(RowId n) const {
    const OpGroup group = op_table()[program_->at(n).op].group;
    return group == OpGroup::action || group == OpGroup::condition;
}

}  // namespace trellis
