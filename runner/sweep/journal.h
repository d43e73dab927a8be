// The runs that a sweep has done, in a file that grows by one line with each: what --resume goes on
// from and what `sweep merge` puts together. A killed process loses the runs in flight and no
// other; a line that was not written to its end is cut off. Covered by
// tests/runner/sweep_journal_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/streams.h"
#include "runner/sweep/plan.h"
#include "runner/sweep/run_record.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// The runs of a sweep, by their number: none where one is not done.
using Results = std::vector<std::optional<MeasuredRun>>;

/// The first line of a journal: which sweep it is of.
std::string journal_header(const SweepPlan& plan);

/// What a journal holds.
struct JournalContent {
    bool is_of_plan = false;        ///< else it is of another sweep, or no journal
    std::vector<NumberedRun> runs;  ///< in the order in which they were done
    std::size_t whole = 0;          ///< bytes up to the end of the last whole line
};
JournalContent read_journal(std::string_view text, const SweepPlan& plan);

class Journal {
public:
    /// The journal of that name, and in `results` what it holds. With `resume` one that is there is
    /// gone on with, else that is an error. Null after a message, with what to return in `exit`.
    static std::unique_ptr<Journal> open(const std::string& path, const SweepPlan& plan,
                                         bool resume, Results& results, Streams& streams,
                                         Exit& exit);

    /// Adds a run; false if that failed, and why() then says why.
    bool add(std::uint64_t number, const MeasuredRun& run);
    std::string why() const { return file_->why(); }
    const std::string& path() const { return path_; }

private:
    Journal(std::string path, std::unique_ptr<GrowingFile> file)
        : path_(std::move(path)), file_(std::move(file)) {}

    std::string path_;
    std::unique_ptr<GrowingFile> file_;
};

}  // namespace trellis
