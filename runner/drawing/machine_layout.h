// Where the states of a machine stand and how its arrows run: a layered layout inside each compound
// state, from the inside out. An arrow that crosses the border of a state is cut there, and both
// parts meet at one place of the border. Covered by tests/drawing/machine_layout_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/geometry.h"
#include "runner/drawing/highlights.h"
#include "runner/drawing/lettering.h"
#include "runner/drawing/machine_model.h"

#include <optional>
#include <vector>

namespace trellis::drawing {

/// The words of a state and the room they take.
struct StateCard {
    std::string title;
    Lettering lettering = Lettering::title;  ///< of the title
    std::vector<TextLine> lines;
    bool cut = false;  ///< something is missing
    Size size;         ///< of both, without padding
};

/// An arrow as it is drawn.
struct Route {
    std::vector<Point> path;  ///< of vertical_curve(); of a loop, where it leaves and comes back
    bool loop = false;        ///< at the right side of its state
    bool back = false;        ///< against the direction of reading
    std::vector<TextLine> words;
    Box label;  ///< around the words; no size without words
};

struct MachineLayout {
    std::vector<StateCard> cards;       ///< of each state
    std::vector<Box> boxes;             ///< of each state; the machine's is around everything
    std::vector<double> separators;     ///< x of the lines between regions, with…
    std::vector<StateIndex> separated;  ///< …the parallel state of each
    std::vector<Route> routes;          ///< of each transition
};

/// Units from a box to what is drawn inside it.
inline constexpr double state_padding = 12;

/// Whether states stand inside this one.
bool is_compound(const MachineModel& model, StateIndex state);

/// The layout, or none if the arrows are so many and so long that drawing them would take too much
/// time and memory; write_out_transitions() then helps.
std::optional<MachineLayout> machine_layout(const MachineModel& model,
                                            const Highlights& highlights);

}  // namespace trellis::drawing
