// Runs that will cover nothing more, because they only repeat themselves: a robot that is stuck,
// one that comes back to an earlier state, and one whose behaviour repeats while the way it takes
// is turned about a point again and again, without ever meeting a wall. Covered by
// tests/sim/repetition_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/bridge/episode.h"
#include "sim/coverage.h"

#include <cstdint>
#include <optional>

namespace trellis {

/// What a run repeats.
struct Repetition {
    std::uint64_t period = 0;  ///< ticks
    bool moves = false;        ///< else the robot stays where it is
};

/// Looks at a run after each of its ticks. At most of them that is a comparison of two numbers: it
/// thinks only when the behaviour begins something else, or has not for a while.
class RepetitionWatch {
public:
    explicit RepetitionWatch(const Episode& start);

    /// Whether a run can be told to repeat itself at all: not if its robot or sensors are noisy.
    bool is_of_use() const { return is_of_use_; }

    /// The repetition, if from now on the run covers nothing that `coverage` does not have, however
    /// long it lasts; to the accuracy of Coverage, cells within 1 mm of the rim of what an orbit
    /// covers do not count.
    std::optional<Repetition> look(const Episode& run, const Coverage& coverage) {
        const State& state = run.state();
        const std::uint32_t doing =
            run.program().is_machine() ? state.session.atom.index : state.last_leaf.index;
        bumps_ += run.robot().bumper ? 1 : 0;
        if (doing == doing_ && ++same_ < patience) return {};
        doing_ = doing;
        same_ = 0;
        return think(run, coverage);
    }

private:
    /// It thinks at least every so many ticks.
    static constexpr std::uint32_t patience = 600;

    /// An earlier moment of the run.
    struct Anchor {
        Episode run;
        std::uint32_t doing;
        std::uint64_t bumps;
    };

    std::optional<Repetition> think(const Episode& run, const Coverage& coverage);
    std::optional<Repetition> compare(const Episode& run, const Coverage& coverage);
    void drop_anchor(const Episode& run);

    bool is_of_use_;
    bool is_blind_;  // the behaviour perceives nothing but the bumper
    Anchor anchor_;
    // Brent: the anchor stays for twice as many moments each time, until numbers are drawn
    std::uint64_t moments_ = 0, most_moments_ = 1;
    std::uint64_t next_comparison_ = 0;  // tick
    std::uint32_t doing_;
    std::uint32_t same_ = 0;
    std::uint64_t bumps_ = 0;
};

}  // namespace trellis
