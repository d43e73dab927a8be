// The command line of the program: which commands there are, help, and what is said about a command
// line that makes no sense. Covered by tests/runner/command_line_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/streams.h"

#include <string>
#include <vector>

namespace trellis {

/// What decides whether messages are coloured, besides --color.
struct Terminal {
    bool is_terminal = false;     ///< standard error is one
    bool no_color = false;        ///< NO_COLOR is set and not empty
    bool clicolor_force = false;  ///< CLICOLOR_FORCE is set and not 0
};

/// Runs the program with the words after its name. Never throws: a defect is Exit::internal.
Exit run_program(const std::vector<std::string>& words, Streams streams, const Terminal& terminal);

}  // namespace trellis
