// From trace events to happenings.
// SPDX-License-Identifier: MIT
#include "runner/contestant.h"

#include "runner/start_events.h"

#include <algorithm>
#include <utility>

namespace trellis {

Contestant::Contestant(const Entrant& entrant, EpisodeSetup setup)
    : entrant_(&entrant), episode_(entrant.program, std::move(setup)), tally_(entrant.labels),
      first_tick_(entrant.program.rows.size()) {
    trace_start(episode_, *this);
    happenings_.clear();
}

bool Contestant::tick() {
    if (is_over()) { return false; }
    row_before_ = row();
    happenings_.clear();
    if (!episode_.tick(this)) { return false; }
    tally_.tick(episode_);
    // the first leaf of a tree begins with the run, as the first state of a machine does
    if (!row_before_ && happenings_.size() == 1) { happenings_.clear(); }
    return true;
}

std::uint64_t Contestant::ticks_of(RowId row) const {
    return row ? episode_.state().tick + 1 - first_tick_[row.index] : 0;
}

void Contestant::on(const TraceEvent& event) {
    if (event.machine != nullptr) { return; }  // of an invoked machine: other rows
    tally_.on(event);
    if (event.kind == TraceEvent::Kind::transition) {
        happenings_.push_back({.kind = Happening::Kind::transition,
                               .row = event.row,
                               .transition = event.transition});
    }
    if (event.kind == TraceEvent::Kind::status && entrant_->labels.of(event.row)) {
        on_status(event);
    }
}

// A leaf runs in the tick in which it ends; a state that is left does not run in that tick.
void Contestant::on_status(const TraceEvent& event) {
    std::uint64_t& first = first_tick_[event.row.index];
    if (event.from == Status::idle) {
        first = std::max<std::uint64_t>(event.tick, 1);
        happenings_.push_back({.kind = Happening::Kind::began, .row = event.row});
    }
    if (is_done(event.to)) {
        happenings_.push_back({.kind = Happening::Kind::ended,
                               .row = event.row,
                               .status = event.to,
                               .ticks = event.tick + 1 - first});
    }
    // a final state is left because the machine has ended, not for another one
    const bool is_final = entrant_->program.at(event.row).op == Op::final;
    if (event.from == Status::running && event.to == Status::idle && !is_final) {
        happenings_.push_back(
            {.kind = Happening::Kind::left, .row = event.row, .ticks = event.tick - first});
    }
}

}  // namespace trellis
