// The order of a tick.
// SPDX-License-Identifier: MIT
#include "sim/bridge/episode.h"

#include <utility>

namespace trellis {

Random noise_of(std::int64_t seed) {
    return Random((std::int64_t{1} << 32) + seed);
}

Pose start_of(const EpisodeSetup& setup) {
    if (setup.start) { return *setup.start; }
    return setup.walled == nullptr ? setup.world.start : setup.walled->plan.starts.front();
}

Roomba robot_of(const EpisodeSetup& setup) {
    const Pose start = start_of(setup);
    if (setup.walled != nullptr) { return at_start(*setup.walled, start); }
    LabWorld world = setup.world;
    world.start = start;
    return at_start(world);
}

Episode::Episode(const Program& program, EpisodeSetup setup)
    : program_(&program), setup_(std::move(setup)), options_{.dt = setup_.dt},
      robot_(robot_of(setup_)), state_(fresh_state(program)) {
    if (setup_.walled != nullptr) { around_ = surroundings_of(setup_.walled->plan); }
    state_.random = setup_.random;
    start(program, state_, robot_, options_);
}

bool Episode::tick(TraceSink* trace) {
    if (setup_.walled == nullptr) [[likely]] {
        sense(setup_.world, robot_);
    } else {
        sense_around();
    }
    options_.trace = trace;
    status_ = step(*program_, state_, robot_, options_);
    if (state_.fault) { return false; }
    if (setup_.walled == nullptr) [[likely]] {
        move(robot_, setup_.dt);
    } else {
        move_around();
    }
    return true;
}

void Episode::sense_around() {
    sense(*setup_.walled, around_, robot_);
    const Noise& noise = setup_.walled->plan.noise;
    if (noise.wall_distance > 0.0 && robot_.wall_distance < Roomba::farthest_wall) {
        robot_.wall_distance += setup_.noise.gauss(0.0, noise.wall_distance);
    }
    if (noise.dock_bearing > 0.0 && robot_.dock_visible) {
        robot_.dock_bearing += setup_.noise.gauss(0.0, noise.dock_bearing);
    }
}

void Episode::move_around() {
    // the wheels slip in this move only: the command stays what the behaviour said
    const double linear = robot_.linear;
    const double angular = robot_.angular;
    const Noise& noise = setup_.walled->plan.noise;
    if (noise.linear_slip > 0.0) { robot_.linear *= setup_.noise.gauss(1.0, noise.linear_slip); }
    if (noise.angular_slip > 0.0) { robot_.angular *= setup_.noise.gauss(1.0, noise.angular_slip); }
    move(*setup_.walled, around_, robot_, setup_.dt);
    robot_.linear = linear;
    robot_.angular = angular;
}

EpisodeRow Episode::row() const {
    return {.tick = state_.tick,
            .time = static_cast<double>(state_.tick) * setup_.dt,
            .robot = robot_,
            .leaf = leaf_label(*program_, state_)};
}

std::string_view leaf_label(const Program& program, const State& state) {
    if (program.is_machine()) {
        const RowId atom = state.session.final ? state.session.final : state.session.atom;
        return atom ? program.name(atom) : "-";
    }
    if (!state.last_leaf) { return "-"; }
    for (RowId n = state.last_leaf; n; n = program.at(n).parent) {
        if (program.at(n).op == Op::subtree) { return program.name(n); }
    }
    return program.name(state.last_leaf);
}

}  // namespace trellis
