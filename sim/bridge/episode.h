// One run of a behaviour in the lab's room or in a world of walls: robot, program state, what the
// run changes in its world, and the order of a tick (LAB 1.2). It writes nothing and knows no
// files. Covered by tests/sim/episode_test.cpp and, against recorded runs,
// tests/sim/lab_behaviours_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/random.h"
#include "core/state.h"
#include "core/trace.h"
#include "exec/step.h"
#include "sim/lab_world.h"
#include "sim/roomba.h"
#include "sim/surroundings.h"
#include "sim/walled_world.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace trellis {

/// Where and how a run begins.
struct EpisodeSetup {
    LabWorld world = {};                  ///< where the run is, unless there is a `walled` one
    const WalledWorld* walled = nullptr;  ///< shared by all its runs, which it outlives
    std::optional<Pose> start = {};       ///< none: the world's own, of `walled` the first
    double dt = lab_dt;                   ///< s
    Random random = {};                   ///< of the behaviour
    Random noise = {};  ///< of the robot's drive and sensors, where a world has noise
};

/// The noise of the run with that seed: Python's random.Random(2**32 + seed), so that it does not
/// repeat what the behaviour draws.
Random noise_of(std::int64_t seed);

/// Where the run begins.
Pose start_of(const EpisodeSetup& setup);
/// The robot before the first tick.
Roomba robot_of(const EpisodeSetup& setup);

/// What one tick looked like: a row of the trace.
struct EpisodeRow {
    std::uint64_t tick = 0;  ///< 0 is the start
    double time = 0.0;       ///< s
    Roomba robot = {};
    std::string_view leaf;  ///< see leaf_label(); owned by the program
};

/// A run. `program` must outlive it. Copying it saves the run, assigning restores it.
class Episode {
public:
    Episode(const Program& program, EpisodeSetup setup);

    /// Senses, steps the behaviour, moves. False if the behaviour failed (state().fault), after
    /// which the run cannot go on.
    bool tick(TraceSink* trace = nullptr);

    EpisodeRow row() const;
    /// Of the last tick; running before the first.
    Status status() const { return status_; }
    /// Whether the behaviour has come to its end: a machine in a top-level final state.
    bool is_over() const { return static_cast<bool>(state_.session.final); }

    const Program& program() const { return *program_; }
    const State& state() const { return state_; }
    const Roomba& robot() const { return robot_; }
    /// Of a run in a world of walls.
    const Surroundings& surroundings() const { return around_; }
    const EpisodeSetup& setup() const { return setup_; }

private:
    friend class FastForward;  // which lets ticks pass without ticking

    void sense_around();
    void move_around();

    const Program* program_;
    EpisodeSetup setup_;
    StepOptions options_;  // kept, because a tick takes little longer than filling them in
    Roomba robot_;
    Surroundings around_;
    State state_;
    Status status_ = Status::running;
};

/// What a behaviour is doing, in the author's words. Trees: the leaf ticked last, or the innermost
/// subtree around it; "-" before the first tick. Machines: the active atomic state.
std::string_view leaf_label(const Program& program, const State& state);

}  // namespace trellis
