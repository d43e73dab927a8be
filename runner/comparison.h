// Two behaviours in the same world with the same random numbers: where their runs part, and by how
// much. Prints nothing. Covered by tests/runner/compare_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/contestant.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// The first tick in which the runs differ, and both runs at its end.
struct Parting {
    std::vector<std::string_view> columns;  ///< what differs: "leaf", "x", …, "ended"
    Contestant a, b;
};

/// One pair of runs.
struct Match {
    std::string random;                   ///< "seed 7", "draws angles.txt"
    Contestant a, b;                      ///< at the end of the last common tick
    std::optional<Parting> parting = {};  ///< none if the runs are the same
    double distance = 0.0;                ///< m, largest between the robots at the same tick
    std::uint64_t distance_tick = 0;      ///< when it was that large

    /// A fault that ended one of the runs, as describe_fault() says it; empty if there is none.
    std::string fault() const;
};

/// Runs both for so many ticks, or until one of them ends. A label counts as different only if it
/// is a name that the other behaviour has too: names alone are no difference.
Match compare(const Entrant& a, const Entrant& b, const EpisodeSetup& setup, std::uint64_t ticks,
              std::string random);

}  // namespace trellis
