// One more start.
// SPDX-License-Identifier: MIT
#include "runner/start_events.h"

#include "exec/step.h"

namespace trellis {

void trace_start(const Episode& episode, TraceSink& sink) {
    State state = fresh_state(episode.program());
    state.random = episode.setup().random;
    Roomba robot = robot_of(episode.setup());
    start(episode.program(), state, robot, {.dt = episode.setup().dt, .trace = &sink});
}

}  // namespace trellis
