// The program: the process's own streams, environment and exit code; everything else is in
// command_line.h. Covered by tests/runner/program_test.cpp.
// SPDX-License-Identifier: MIT
#include "runner/command_line.h"
#include "runner/disk_files.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace {

/// Standard output with a memory for why it failed, which std::cout has not.
class StandardOutput : public std::streambuf {
public:
    StandardOutput() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

    /// errno of the first write that failed; 0 if none did.
    int error() const { return error_; }

protected:
    int sync() override {
        const char* at = pbase();
        while (at != pptr() && error_ == 0) {
            const ssize_t n = ::write(STDOUT_FILENO, at, static_cast<std::size_t>(pptr() - at));
            if (n >= 0) {
                at += n;
            } else if (errno != EINTR) {
                error_ = errno;
            }
        }
        setp(buffer_.data(), buffer_.data() + buffer_.size());
        return error_ == 0 ? 0 : -1;
    }
    int_type overflow(int_type c) override {
        if (sync() != 0) { return traits_type::eof(); }
        return traits_type::eq_int_type(c, traits_type::eof())
                   ? traits_type::not_eof(c)
                   : sputc(traits_type::to_char_type(c));
    }

private:
    std::array<char, 1 << 16> buffer_;
    int error_ = 0;
};

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

const char* environment(const char* name) {
    return std::getenv(name);
}

}  // namespace

int main(int argc, char** argv) {
    // a reader that goes away is a failed write, not a signal
    std::signal(SIGPIPE, SIG_IGN);
    std::ios::sync_with_stdio(false);
    StandardOutput output;
    std::ostream out(&output);
    trellis::DiskFiles files;
    const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    const trellis::Terminal watched = terminal();
    const trellis::Exit exit = trellis::run_program(words,
                                                    {.in = std::cin,
                                                     .out = out,
                                                     .err = std::cerr,
                                                     .files = files,
                                                     .prompt = ::isatty(STDIN_FILENO) != 0,
                                                     .progress = watched.is_terminal,
                                                     .environment = environment},
                                                    watched);
    out.flush();
    if (output.error() == 0) { return static_cast<int>(exit); }
    if (output.error() != EPIPE) {
        std::cerr << "trellis: cannot write standard output: " << std::strerror(output.error())
                  << '\n';
    }
    return static_cast<int>(trellis::Exit::file);
}
