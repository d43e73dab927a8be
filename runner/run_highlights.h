// What a run did, as highlights of the picture of its behaviour. Covered by
// tests/runner/show_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/drawing.h"
#include "runner/places.h"
#include "runner/row_statuses.h"

#include <cstdint>
#include <vector>

namespace trellis {

/// Every node or state with what it did in `tick`, and the transitions that were taken in it. An
/// element that stands for several rows, because its tree is used several times, shows the one that
/// does most: running, else failed, succeeded, skipped, idle.
std::vector<Highlight> highlights_at(const Program& program, const Places& places,
                                     const RowStatuses& statuses, std::uint64_t tick);

/// The nodes, states and transitions that the run never came to, as idle, with a note that says so.
std::vector<Highlight> highlights_unreached(const Program& program, const Places& places,
                                            const RowStatuses& statuses);

}  // namespace trellis
