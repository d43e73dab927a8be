// Reading a trace back: the CSV that sim/bridge/trace_csv.h writes, or any other with a header.
// Covered by tests/runner/trace_diff_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// A table of texts. The first row of the file are the names of its columns.
struct TraceTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`
    std::vector<std::string_view> lines;         ///< of the text, by row; owned by the caller
};

/// The table that `text` spells (RFC 4180; line ends may be LF). None, and errors "bad-trace", if a
/// row is too long or too short, a quote is not closed, or there is no column "tick".
std::optional<TraceTable> read_trace(const std::string& name, std::string_view text,
                                     Diagnostics& diagnostics);

}  // namespace trellis
