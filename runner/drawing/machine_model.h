// What a drawing of a statechart shows, apart from where: states in the order of the text with what
// is done in them, and the arrows between them. Covered by tests/drawing/machine_model_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <cstdint>
#include <string>
#include <vector>

namespace trellis::drawing {

enum class StateShape : std::uint8_t {
    machine,   ///< the whole: the first state of a model, and no other
    state,     ///< atomic or compound
    parallel,  ///< its children are its regions
    final_state,
    shallow_history,
    deep_history,
    initial,  ///< the dot where a compound state begins: first child of its state
};

/// A row number of MachineModel::states.
using StateIndex = Id<struct DrawnStateTag>;

struct DrawnState {
    ElementId element;      ///< of an initial dot the <initial>, or none
    StateIndex parent;      ///< none for the machine
    std::uint32_t end = 0;  ///< one past the last state inside this one
    StateShape shape = StateShape::state;
    std::string id;                  ///< empty if it has none, and of an initial dot
    std::vector<std::string> lines;  ///< "entry / x = 1", whole, in written order
    std::vector<bool> inside;        ///< of each line: continues the one above it
};

struct DrawnTransition {
    ElementId element;  ///< the <transition>; of an initial dot the same, or none
    StateIndex source;
    StateIndex target;
    std::string event;   ///< "tick", or empty
    std::string guard;   ///< "x > 3", or empty
    std::string action;  ///< "x = 1; raise e", or empty
};

struct MachineModel {
    std::vector<DrawnState> states;            ///< in document order; [0] is the machine
    std::vector<DrawnTransition> transitions;  ///< one for each target, in document order
};

/// The model of a machine file. Transitions without a target, and those whose target is not in the
/// file, are lines of their state: "tick [x > 3] / x = 0", "tick → missing".
MachineModel machine_model(const Document& document);

/// "tick [x > 3] / x = 0".
std::string words_of(const DrawnTransition& transition);

/// Turns all arrows but those of initial dots into lines of their states: for a machine with more
/// arrows than a picture can hold.
void write_out_transitions(MachineModel& model);

}  // namespace trellis::drawing
