// The line, and when it is written.
// SPDX-License-Identifier: MIT
#include "runner/sweep/progress.h"

#include "runner/table.h"

#include <cmath>
#include <ostream>

namespace trellis {
namespace {

constexpr std::uint64_t bar_width = 30;
constexpr std::chrono::milliseconds between{100};

/// "9 s", "3 min 20 s", "2 h 5 min".
std::string roughly(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::ceil(seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    const std::uint64_t minutes = whole / 60;
    if (minutes < 60) return std::to_string(minutes) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

}  // namespace

std::string progress_line(std::uint64_t done, std::uint64_t all, std::uint64_t here,
                          double seconds) {
    const std::uint64_t filled = all == 0 ? bar_width : bar_width * done / all;
    std::string line = '[' + std::string(filled, '#') + std::string(bar_width - filled, '-') +
                       "]  " + std::to_string(done) + '/' + std::to_string(all);
    if (here == 0 || seconds <= 0.0) return line;
    const double rate = static_cast<double>(here) / seconds;
    line += "  " + fixed(rate, rate < 10.0 ? 2 : 0) + " runs/s";
    return line + "  " + roughly(static_cast<double>(all - done) / rate) + " left";
}

Progress::Progress(std::ostream& out, bool watched, std::uint64_t done, std::uint64_t all)
    : out_(out), watched_(watched), before_(done), done_(done), all_(all), start_(Clock::now()),
      shown_(start_) {}

Progress::~Progress() {
    if (watched_) out_ << "\r\x1b[K" << std::flush;
}

void Progress::add() {
    ++done_;
    if (!watched_) return;
    const Clock::time_point now = Clock::now();
    if (now - shown_ < between) return;
    shown_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    out_ << '\r' << progress_line(done_, all_, done_ - before_, seconds) << "\x1b[K" << std::flush;
}

}  // namespace trellis
