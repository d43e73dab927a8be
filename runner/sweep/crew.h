// Work shared by threads: the only ones of the program. Covered by tests/runner/sweep_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace trellis {

/// Calls `work` with each number below `count` once, in `threads` threads, each taking the next
/// number that is left; after a call that returns false no more are begun. Returns when all calls
/// have. An exception of a call is thrown here, after the others have returned.
void share_out(std::size_t count, unsigned threads, const std::function<bool(std::size_t)>& work);

/// How many threads the machine runs at once; at least 1.
unsigned machine_threads();

}  // namespace trellis
