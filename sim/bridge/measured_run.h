// One run of a behaviour with everything that is measured about it, and nothing that is shown: what
// sweeps are made of. A function of its arguments, without threads, files or clocks. What a run
// amounts to is taken at several times, because a run of an hour begins with one of ten minutes.
// Covered by tests/sim/measured_run_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "sim/bridge/episode.h"
#include "sim/coverage.h"
#include "sim/odometer.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// Parts of the floor, in %, whose times are told.
inline constexpr std::array<int, 5> milestones{50, 80, 90, 95, 99};

/// When a run is measured. Ticks, ascending, each list at least one.
struct Measuring {
    std::vector<std::uint64_t> stops;  ///< the last is the end of the run
    std::vector<std::uint64_t> curve;  ///< in which only the coverage is taken
    bool ends_early = true;            ///< when nothing more can be covered: stuck, orbit
    bool leaps = false;  ///< over ticks in which nothing is decided: see fast_forward.h
};

/// How a run ended.
enum class Ending : std::uint8_t {
    time,   ///< its time was up
    final,  ///< the machine reached a top-level final state
    fault,  ///< the behaviour failed
    stuck,  ///< the robot will not move any more
    orbit,  ///< it will go on for ever where it has been: see repetition.h
};
inline constexpr std::array endings{Ending::time, Ending::final, Ending::fault, Ending::stuck,
                                    Ending::orbit};
/// "time", "final", …
std::string_view name_of(Ending ending);

/// What a run amounts to in one of the stops, or when it ended if that was earlier.
struct Measures {
    std::uint64_t tick = 0;         ///< of the stop, whenever the run ended
    std::uint64_t covered = 0;      ///< cells
    std::uint64_t largest_gap = 0;  ///< cells
    Odometer driven = {};
    double dirt = 0.0;             ///< spots collected, of the world's
    Ending ending = Ending::time;  ///< what had ended it by then
    std::uint64_t ended = 0;       ///< tick in which it did; that of the stop, if time

    friend bool operator==(const Measures&, const Measures&) = default;
};

struct MeasuredRun {
    std::vector<Measures> stops;
    std::vector<std::uint64_t> curve;  ///< cells covered, by Measuring::curve
    /// The ticks in which the milestones were reached; none if one was not.
    std::array<std::optional<std::uint64_t>, milestones.size()> reached{};
    /// The final state's id, the fault, how often an orbit repeats; empty if its time was up.
    std::string message;

    friend bool operator==(const MeasuredRun&, const MeasuredRun&) = default;
};

/// Runs to the last stop, or to the end. `program` and `floor` must be those of the setup.
MeasuredRun measured_run(const Program& program, EpisodeSetup setup, const Floor& floor,
                         const Measuring& measuring);

}  // namespace trellis
