// Reading a file of events back: what event_lines.h writes. Covered by
// tests/runner/recording_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/trace.h"
#include "load/diagnostics.h"
#include "runner/behaviour.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// A recorded run.
struct Recording {
    std::string file;                ///< of the behaviour, as the run's command line named it
    std::string tree;                ///< its --tree; empty: not given
    std::uint32_t rows = 0;          ///< of the program
    double dt = 0.0;                 ///< s
    std::uint64_t ticks = 0;         ///< the last tick that was run
    std::vector<std::string> names;  ///< by row; empty for those that never did anything
    /// In the order they happened. Their texts lie in `texts`. Statuses of states are restored from
    /// their being entered and left.
    std::vector<TraceEvent> events;
    std::deque<std::string> texts;
};

/// None, and errors "bad-trace", if a line is not a JSON object with the members of its event, or
/// the first one does not say which run it was.
std::optional<Recording> read_recording(const std::string& name, std::string_view text,
                                        Diagnostics& diagnostics);

/// Why it cannot have been recorded from this program, in words; empty if it can.
std::string mismatch(const Recording& recording, const Program& program);

/// Reads a file of events; none after messages, with what to return in `exit`.
std::optional<Recording> load_recording(const std::string& file, Streams& streams, Exit& exit);

/// Loads the behaviour that a recording was made of, with its --tree unless `arguments`
/// name another; none after messages, also if it does not fit the recording.
std::optional<Behaviour> load_recorded(const std::string& file, LoadArguments arguments,
                                       const Recording& recording, Registry& registry,
                                       Streams& streams, Exit& exit);

}  // namespace trellis
