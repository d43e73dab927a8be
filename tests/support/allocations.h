// Counts what a test executable takes from the heap: allocations.cpp replaces operator new. For
// tests that say "this allocates nothing"; one thread at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace trellis {

/// Calls of operator new so far, from everything in this executable.
std::size_t allocation_count();

}  // namespace trellis
