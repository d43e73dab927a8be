// The three pictures of a machine model. What they show is decided in machine_model.h, where in
// machine_layout.h. Covered by tests/drawing/machine_drawing_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/drawing.h"
#include "runner/drawing/machine_model.h"

#include <string>

namespace trellis::drawing {

/// An SVG of the statechart: compound states around their children, regions side by side, arrows
/// with their labels on them, those that lead back up in another colour.
std::string machine_svg(const Document& document, const MachineModel& model,
                        const DrawingOptions& options);

/// A Graphviz digraph with a cluster for each compound state. The states are called s0, s1, …, in
/// the order of the model.
std::string machine_dot(const MachineModel& model, const DrawingOptions& options);

/// The states as an indented list, each with what it does and its transitions.
std::string machine_text(const MachineModel& model, const DrawingOptions& options);

}  // namespace trellis::drawing
