// A pipe from a shell.
// SPDX-License-Identifier: MIT
#include "runner/shell.h"

#include "runner/command.h"

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>

namespace trellis::test {

Shell shell(const std::string& command) {
    const std::string line =
        "cd '" + from_root("") + "' && trellis='" TRELLIS_PROGRAM "' && " + command;
    Shell result;
    FILE* pipe = popen(line.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) {
        result.out.append(buffer.data(), n);
    }
    const int status = pclose(pipe);
    result.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return result;
}

}  // namespace trellis::test
