// Where the ticks of a run went, row by row: how often each node was ticked, what came of it, how
// long each state was active, how often each transition was taken. The totals by name that every
// report has are in tally.h. Covered by tests/runner/profile_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/trace.h"

#include <cstdint>
#include <vector>

namespace trellis {

/// Sums over one run. Tables are as long as the program's; recording an event allocates nothing.
class Profile : public TraceSink {
public:
    struct Row {
        std::uint64_t entered = 0;  ///< how often it began
        /// Ticks of the run in which it was ticked; of a state, at whose end it was active.
        std::uint64_t ticks = 0;
        std::uint64_t successes = 0;
        std::uint64_t failures = 0;
        std::uint64_t skips = 0;
        std::uint64_t halts = 0;  ///< how often it was stopped while running; of a state, left
    };

    /// `program` must outlive it.
    explicit Profile(const Program& program);

    void on(const TraceEvent& event) override;
    /// What is still running ran up to `last_tick`. Call it once, after the last event.
    void finish(std::uint64_t last_tick);

    const Row& row(RowId n) const { return rows_[n.index]; }
    /// Whether the row ever did anything: a node that was ticked or skipped, a state that was
    /// active.
    bool reached(RowId n) const { return rows_[n.index].entered != 0 || rows_[n.index].skips != 0; }
    /// How often the transition was taken.
    std::uint64_t taken(TransitionId transition) const { return taken_[transition.index]; }

private:
    /// What is known of a row between two events.
    struct Running {
        std::uint64_t since = 0;    ///< first tick it has been running in; 0: it is not
        std::uint64_t counted = 0;  ///< last tick that Row::ticks holds
    };

    void on_status(const TraceEvent& event);
    void on_leaf(const TraceEvent& event);
    void count(RowId n, std::uint64_t first, std::uint64_t last);
    bool is_leaf(RowId n) const;

    const Program* program_;
    std::vector<Row> rows_;
    std::vector<Running> running_;
    std::vector<std::uint64_t> taken_;
};

}  // namespace trellis
