// The program: the process's own streams, environment and exit code; everything else is in
// command_line.h. Covered by tests/runner/program_test.cpp.
// SPDX-License-Identifier: MIT
#include "runner/command_line.h"
#include "runner/disk_files.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace {

trellis::Terminal terminal() {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string_view(value == nullptr ? "" : value);
    };
    const std::string_view force = set("CLICOLOR_FORCE");
    return {.is_terminal = ::isatty(STDERR_FILENO) != 0 && set("TERM") != "dumb",
            .no_color = !set("NO_COLOR").empty(),
            .clicolor_force = !force.empty() && force != "0"};
}

}  // namespace

int main(int argc, char** argv) {
    // a reader that goes away is a failed write, not a signal
    std::signal(SIGPIPE, SIG_IGN);
    std::ios::sync_with_stdio(false);
    trellis::DiskFiles files;
    const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    const trellis::Exit exit =
        trellis::run_program(words, {std::cin, std::cout, std::cerr, files}, terminal());
    errno = 0;
    if (!std::cout.flush()) {
        if (errno != EPIPE && errno != 0) {
            std::cerr << "trellis: cannot write standard output: " << std::strerror(errno) << '\n';
        }
        return static_cast<int>(trellis::Exit::file);
    }
    return static_cast<int>(exit);
}
