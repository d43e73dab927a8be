// The real program in a shell, for tests of what a process does. Covered by every test that uses
// it.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace trellis::test {

struct Shell {
    int exit = -1;  ///< 128 if a signal ended it
    std::string out;
};

/// Runs a shell command in the repository's root, with $trellis as the program.
Shell shell(const std::string& command);

}  // namespace trellis::test
