// Counting.
// SPDX-License-Identifier: MIT
#include "runner/tally.h"

namespace trellis {

void Tally::on(const TraceEvent& event) {
    if (event.machine != nullptr) { return; }  // of an invoked machine: other rows
    if (event.kind != TraceEvent::Kind::status || event.from != Status::idle) { return; }
    if (const LabelId label = labels_->of(event.row)) { ++entered[label.index]; }
}

void Tally::tick(const Episode& episode) {
    if (const LabelId label = labels_->of(labels_->row(episode.state()))) { ++ticks[label.index]; }
    driven.add(episode.robot(), episode.setup().dt);
    successes += episode.status() == Status::success ? 1 : 0;
    failures += episode.status() == Status::failure ? 1 : 0;
}

}  // namespace trellis
