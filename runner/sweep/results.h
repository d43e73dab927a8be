// What a sweep ends with: its rows in a file, its summary, and what went wrong. The same for one
// process, for parts that are put together and for the ranks of an MPI job. Covered by
// tests/runner/sweep_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/commands.h"
#include "runner/sweep/journal.h"

#include <string>

namespace trellis {

/// Adds --out, --report and --format to a command.
void add_options(CLI::App& app, SweepOutput& output);

/// Writes rows and summary of a sweep whose runs are all done. Yes; no, after a message, if a
/// behaviour failed; file if the rows cannot be written.
Exit write_results(const SweepPlan& plan, const Results& results, const SweepOutput& output,
                   Streams& streams);

}  // namespace trellis
