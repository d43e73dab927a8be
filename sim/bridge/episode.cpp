// The order of a tick.
// SPDX-License-Identifier: MIT
#include "sim/bridge/episode.h"

#include <utility>

namespace trellis {

Episode::Episode(const Program& program, EpisodeSetup setup)
    : program_(&program), setup_(std::move(setup)), options_{.dt = setup_.dt},
      robot_(at_start(setup_.world)), state_(fresh_state(program)) {
    state_.random = setup_.random;
    start(program, state_, robot_, options_);
}

bool Episode::tick(TraceSink* trace) {
    sense(setup_.world, robot_);
    options_.trace = trace;
    status_ = step(*program_, state_, robot_, options_);
    if (state_.fault) { return false; }
    move(robot_, setup_.dt);
    return true;
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
