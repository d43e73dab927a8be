// What a run amounts to: how often and how long it did what, how far it drove, how often it
// bumped. Covered by tests/runner/tally_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/trace.h"
#include "runner/labels.h"
#include "sim/bridge/episode.h"
#include "sim/odometer.h"

#include <cstdint>
#include <vector>

namespace trellis {

/// Sums over the ticks of one run. Give it every trace event, and tick() after each tick.
class Tally {
public:
    /// `labels` must outlive it.
    explicit Tally(const Labels& labels)
        : labels_(&labels), entered(labels.names().size()), ticks(labels.names().size()) {}

    void on(const TraceEvent& event);
    void tick(const Episode& episode);

private:
    const Labels* labels_;

public:
    std::vector<std::uint64_t> entered;  ///< by label: how often it began
    std::vector<std::uint64_t> ticks;    ///< by label: ticks at whose end the run was at it
    Odometer driven;                     ///< turns, bumps, distance
    std::uint64_t successes = 0;         ///< ticks in which the root succeeded
    std::uint64_t failures = 0;          ///< ticks in which the root failed
};

}  // namespace trellis
