// Whether a run has come back to an earlier state but for the time: everything that counts ticks or
// activations for ever is compared relative to the state's own time, or not at all where nothing
// depends on it. What a behaviour can perceive besides is told here too. Covered by
// tests/exec/recurrence_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/state.h"

#include <cstdint>
#include <span>

namespace trellis {

/// Whether `a` and `b`, of two ticks of one run, have the same future as far as the behaviour goes:
/// stepped with equal robots from then on, they command the same. False also where that is not
/// known: with events that wait, a fault, or nodes that watch how often an entry was written.
bool recurs(const Program& program, const State& a, const State& b);

/// Whether an expression of the program, or of a machine that it invokes, asks for a sensor other
/// than those at the bytes `known` of the host.
bool reads_sensor_but(const Program& program, std::span<const std::uint32_t> known);

}  // namespace trellis
