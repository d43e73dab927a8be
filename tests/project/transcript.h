// A shell session as documents show it: commands after "$ ", what each printed below it. Splitting
// and comparing only; documents_test.cpp runs them. Covered by transcript_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

struct Command {
    std::string text;      ///< without "$ "; of several lines where a line ends with a backslash
    std::string expected;  ///< the lines below it, up to the next command
};

/// The commands of a block; none if no line begins with "$ ". Lines before the first are dropped.
std::vector<Command> commands_of(std::string_view block);

/// True if `actual` is `expected`, line by line. In `expected`, a line "…" stands for any number of
/// lines, and "…" at the end of a line for any rest of that line. Empty lines at the end of either
/// do not count.
bool output_matches(std::string_view expected, std::string_view actual);

}  // namespace trellis::test
