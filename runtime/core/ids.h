// Typed row numbers: an index into one table of a Program cannot be passed where a row of another
// table is wanted. Nothing else lives here. Covered by tests/core/program_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

namespace trellis {

/// A row number of one table. A default-made Id names no row.
template <class Tag>
struct Id {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::uint32_t index = none;

    constexpr explicit operator bool() const { return index != none; }
    friend constexpr bool operator==(Id, Id) = default;
    friend constexpr auto operator<=>(Id, Id) = default;
};

using RowId = Id<struct RowTag>;                ///< Program::rows: one node of a tree or machine
using SlotId = Id<struct SlotTag>;              ///< Program::slots: one variable
using CodeId = Id<struct CodeTag>;              ///< Program::code: first instruction of one script
using CallId = Id<struct CallTag>;              ///< Program::calls: one use of a leaf
using BlockId = Id<struct BlockTag>;            ///< Program::actions: first action of one block
using EventId = Id<struct EventTag>;            ///< Program::events: one event name
using TransitionId = Id<struct TransitionTag>;  ///< Program::transitions
using PayloadId = Id<struct PayloadTag>;        ///< Program::payloads: what a message carries
using MachineId = Id<struct MachineTag>;        ///< Program::machines: one that can be invoked

}  // namespace trellis
