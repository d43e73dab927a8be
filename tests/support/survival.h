// Damaged texts: what the loader must survive. Bytes are changed, removed, added; words that mean
// something are exchanged; blocks are copied. Covered by tests/exec/mutations_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/random.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace trellis::test {

/// `text` with one to three random changes.
std::string damaged(std::string text, Random& random);

struct Survival {
    std::size_t texts = 0;
    std::size_t loaded = 0;
    std::size_t faults = 0;  ///< loaded ones whose run ended in a fault
};

/// Loads `text`; if it has no errors, runs it for 50 ticks with a small budget, saving and
/// restoring its state on the way. Whatever `text` is, this comes back. Small limits keep it quick.
void survive(std::string_view text, const Registry& registry, HostRef host, Survival& survival);

}  // namespace trellis::test
