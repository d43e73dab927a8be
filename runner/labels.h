// What a behaviour can be doing, as a short list of names: the leaves or subtrees of a tree, the
// atomic states of a machine. The same names as leaf_label() of sim/bridge/episode.h, found by
// looking into a table. Covered by tests/runner/labels_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/program.h"
#include "core/state.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

using LabelId = Id<struct LabelTag>;  ///< Labels::names

class Labels {
public:
    /// `program` must outlive it.
    explicit Labels(const Program& program);

    /// In document order, each once.
    const std::vector<std::string>& names() const { return names_; }
    /// The label of that name; none if there is none.
    LabelId find(std::string_view name) const;

    /// The row that a run is at: the active atomic state, or the innermost subtree around the leaf
    /// ticked last, or that leaf; none before the first.
    RowId row(const State& state) const;
    /// The label of the row that row() gives; none for rows that it never gives.
    LabelId of(RowId row) const { return row ? by_row_[row.index] : LabelId{}; }

private:
    const Program* program_;
    std::vector<std::string> names_;
    std::vector<LabelId> by_row_;
    std::vector<RowId> shown_;  // by leaf row of a tree: what row() gives for it
};

}  // namespace trellis
