// What each row of a program is doing at one tick of its run: the statuses that a picture shows.
// A stored status alone does not tell, because nodes that end are idle again by the end of the
// tick. Covered by tests/runner/row_statuses_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/trace.h"

#include <cstdint>
#include <vector>

namespace trellis {

/// Whether the machine comes to its end in this state: it is then left, but remains where the run
/// is.
bool is_end(const Program& program, RowId n);

/// Give it every event of a run up to the tick of interest.
class RowStatuses : public TraceSink {
public:
    /// `program` must outlive it.
    explicit RowStatuses(const Program& program)
        : program_(&program), rows_(program.rows.size()),
          taken_(program.transitions.size(), never) {}

    void on(const TraceEvent& event) override;

    /// What the row did in `tick`: the status in which it last ended or ran on in it, skipped
    /// included; else what it was left in before; idle if neither or if it was halted. Of a state:
    /// running if it is active at the end of the tick, else idle.
    Status at(RowId n, std::uint64_t tick) const {
        const Row& row = rows_[n.index];
        return row.tick == tick ? row.shown : row.stored;
    }
    /// Whether the row ever did anything, and whether the transition was ever taken.
    bool reached(RowId n) const { return rows_[n.index].reached; }
    bool taken(TransitionId transition) const { return taken_[transition.index] != never; }
    bool taken(TransitionId transition, std::uint64_t tick) const {
        return taken_[transition.index] == tick;
    }

private:
    static constexpr std::uint64_t never = ~std::uint64_t{0};
    struct Row {
        Status stored = Status::idle;
        Status shown = Status::idle;  ///< in `tick`
        bool reached = false;
        std::uint64_t tick = never;  ///< the last one in which it did something
    };
    const Program* program_;
    std::vector<Row> rows_;
    std::vector<std::uint64_t> taken_;  // by transition: the last tick in which it was
};

}  // namespace trellis
