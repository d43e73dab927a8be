// The words of states and arrows in a picture, cut to a readable size. For the layout of machines.
// Covered by tests/drawing/machine_layout_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/highlights.h"
#include "runner/drawing/machine_layout.h"

namespace trellis::drawing {

StateCard card_of(const DrawnState& state, const Highlight& highlight);

/// The words of an arrow: in one line if they are short, else event, guard and action below each
/// other.
std::vector<TextLine> label_of(const DrawnTransition& transition, const Highlight& highlight);

}  // namespace trellis::drawing
