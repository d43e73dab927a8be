// How far a sweep has come, as a line on a terminal that is written over again and again. Covered
// by tests/runner/sweep_progress_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace trellis {

/// "[#####-----]  412/1600  133 runs/s  9 s left": `done` of `all`, of which `here` were done in
/// the last `seconds`.
std::string progress_line(std::uint64_t done, std::uint64_t all, std::uint64_t here,
                          double seconds);

/// The line on a terminal.
class Progress {
public:
    /// Of `all` runs `done` were done before. Nothing is written to `out` unless `watched`.
    Progress(std::ostream& out, bool watched, std::uint64_t done, std::uint64_t all);
    /// Clears the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more is done; shown a few times in a second.
    void add();

private:
    using Clock = std::chrono::steady_clock;

    std::ostream& out_;
    bool watched_;
    std::uint64_t before_, done_, all_;
    Clock::time_point start_, shown_;
};

}  // namespace trellis
