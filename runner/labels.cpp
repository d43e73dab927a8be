// One pass over the rows.
// SPDX-License-Identifier: MIT
#include "runner/labels.h"

#include <algorithm>

namespace trellis {

namespace {

bool is_atomic_state(const Program& program, RowId n) {
    const auto is_state = [&](RowId row) {
        return op_table()[program.at(row).op].group == OpGroup::state;
    };
    if (!is_state(n)) { return false; }
    for (const RowId child : children(program, n)) {
        if (is_state(child)) { return false; }
    }
    return true;
}

bool is_leaf(const Program& program, RowId n) {
    const OpGroup group = op_table()[program.at(n).op].group;
    return group == OpGroup::action || group == OpGroup::condition;
}

RowId innermost_subtree(const Program& program, RowId leaf) {
    for (RowId n = leaf; n; n = program.at(n).parent) {
        if (program.at(n).op == Op::subtree) { return n; }
    }
    return leaf;
}

}  // namespace

Labels::Labels(const Program& program)
    : program_(&program), by_row_(program.rows.size()), shown_(program.rows.size()) {
    for (RowId n{0}; n.index < program.rows.size(); ++n.index) {
        if (program.is_machine() ? !is_atomic_state(program, n) : !is_leaf(program, n)) {
            continue;
        }
        shown_[n.index] = program.is_machine() ? n : innermost_subtree(program, n);
        LabelId& label = by_row_[shown_[n.index].index];
        if (label) { continue; }
        const std::string_view name = program.name(shown_[n.index]);
        label = find(name);
        if (label) { continue; }
        label = {static_cast<std::uint32_t>(names_.size())};
        names_.emplace_back(name);
    }
}

LabelId Labels::find(std::string_view name) const {
    const auto at = std::find(names_.begin(), names_.end(), name);
    if (at == names_.end()) { return {}; }
    return {static_cast<std::uint32_t>(at - names_.begin())};
}

RowId Labels::row(const State& state) const {
    if (program_->is_machine()) {
        return state.session.final ? state.session.final : state.session.atom;
    }
    return state.last_leaf ? shown_[state.last_leaf.index] : RowId{};
}

}  // namespace trellis
