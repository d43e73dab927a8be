// A run that was measured as one line of text, and back: what a sweep keeps of the runs it has done
// (journal.h) and what ranks of an MPI job send. Covered by tests/runner/sweep_journal_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/bridge/measured_run.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace trellis {

/// A run's number and what it came to.
using NumberedRun = std::pair<std::uint64_t, MeasuredRun>;

/// The line, with its line feed. Numbers are written so that the same ones are read again; the last
/// field is a checksum of the others.
std::string record_of(std::uint64_t number, const MeasuredRun& run);

/// The run of a line without its line feed; none if that is not whole, or was not written with this
/// `measuring`.
std::optional<NumberedRun> read_record(std::string_view line, const Measuring& measuring);

}  // namespace trellis
