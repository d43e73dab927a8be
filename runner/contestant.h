// One of two behaviours that are compared: its run, and what it just did in terms of its labels.
// Covered by tests/runner/compare_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/trace.h"
#include "load/document.h"
#include "runner/labels.h"
#include "runner/tally.h"
#include "sim/bridge/episode.h"

#include <cstdint>
#include <string>
#include <vector>

namespace trellis {

/// What all runs of one behaviour share.
struct Entrant {
    std::string file;
    const Program& program;
    const Document& document;  ///< of the file, for the words of its transitions
    const Labels& labels;
};

/// Something that happened to a label's row in a tick, or a transition that was taken.
struct Happening {
    enum class Kind : std::uint8_t { began, ended, left, transition };
    Kind kind = Kind::began;
    RowId row = {};                ///< of the label; the transition's source
    Status status = Status::idle;  ///< ended: with what
    std::uint64_t ticks = 0;       ///< ended, left: for how many ticks it ran
    TransitionId transition = {};
};

/// A run that remembers its last tick. A value: a copy can be run ahead.
class Contestant : TraceSink {
public:
    /// `entrant` must outlive it.
    Contestant(const Entrant& entrant, EpisodeSetup setup);

    /// One tick; false, and nothing happens, if the run is over or has failed.
    bool tick();
    bool is_over() const { return episode_.is_over() || episode_.state().fault; }

    const Entrant& entrant() const { return *entrant_; }
    const Episode& episode() const { return episode_; }
    const Tally& tally() const { return tally_; }
    /// What happened in the last tick, in order; that the run itself began is not among it.
    const std::vector<Happening>& happenings() const { return happenings_; }
    /// Where the run is now, and was one tick earlier; none before the first tick of a tree.
    RowId row() const { return entrant_->labels.row(episode_.state()); }
    RowId row_before() const { return row_before_; }
    /// How many ticks the row has run since it began, the last one included.
    std::uint64_t ticks_of(RowId row) const;

private:
    void on(const TraceEvent& event) override;
    void on_status(const TraceEvent& event);

    const Entrant* entrant_;
    Episode episode_;
    Tally tally_;
    std::vector<std::uint64_t> first_tick_;  // by row: the first in which it ran
    std::vector<Happening> happenings_;
    RowId row_before_;
};

}  // namespace trellis
