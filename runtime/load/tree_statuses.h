// Which statuses each node of a compiled tree can return, found from the leaves upwards, and what
// follows: nodes that are never ticked, loops that never end. Never too narrow: a status that a
// node might return is in its set, so what is found is certain. Evaluates no variables, runs
// nothing. Private to runtime/load; said in words by tree_checks.h. Covered by
// tests/load/tree_checks_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/status.h"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace trellis {

/// Some of success, failure, running and skipped.
class StatusSet {
public:
    constexpr StatusSet() = default;
    constexpr StatusSet(Status status) : bits_(bit(status)) {}
    constexpr StatusSet(std::initializer_list<Status> statuses) {
        for (const Status status : statuses) {
            bits_ = static_cast<std::uint8_t>(bits_ | bit(status));
        }
    }
    static constexpr StatusSet all() {
        return {Status::running, Status::success, Status::failure, Status::skipped};
    }

    constexpr bool has(Status status) const { return (bits_ & bit(status)) != 0; }
    /// Whether the two share a status.
    constexpr bool has_any(StatusSet other) const { return (bits_ & other.bits_) != 0; }
    constexpr StatusSet& operator|=(StatusSet other) {
        bits_ = static_cast<std::uint8_t>(bits_ | other.bits_);
        return *this;
    }
    friend constexpr StatusSet operator|(StatusSet a, StatusSet b) { return a |= b; }
    friend constexpr StatusSet operator&(StatusSet a, StatusSet b) {
        a.bits_ = static_cast<std::uint8_t>(a.bits_ & b.bits_);
        return a;
    }
    friend constexpr bool operator==(StatusSet, StatusSet) = default;

private:
    static constexpr std::uint8_t bit(Status status) {
        return static_cast<std::uint8_t>(1U << static_cast<unsigned>(status));
    }
    std::uint8_t bits_ = 0;
};

/// Rows [first, end) are never ticked.
struct NeverTicked {
    enum class Reason : std::uint8_t {
        never_succeeds,  ///< the node `cause` stands before it and has to succeed
        never_fails,     ///< … has to fail
        nothing_fails,   ///< of the children of TryCatch before it
        switched_off,    ///< a literal in its own condition, or in a Precondition, says so
        no_cycles,       ///< the loop around it has none
        no_attempts,     ///< …
        no_elements,     ///< …
        same_case,       ///< of a Switch: an earlier one is equal
        no_variable,     ///< of a Switch: nothing gives it a value, so the last child is ticked
    };
    RowId first, end;
    RowId cause;  ///< a row the reason speaks of; of a Switch the child of the earlier case
    Reason reason = Reason::never_succeeds;
};

struct TreeStatuses {
    std::vector<StatusSet> by_row;          ///< empty for rows of machines
    std::vector<NeverTicked> never_ticked;  ///< by row; none lies inside another
    /// Loops without a last cycle whose child neither takes time nor returns what ends them.
    std::vector<RowId> endless;
};

/// Looks at all trees of a program that was compiled without errors. Linear in its rows. `unset`
/// are variables that never have a value, sorted.
TreeStatuses find_statuses(const Program& program, const std::vector<SlotId>& unset = {});

}  // namespace trellis
