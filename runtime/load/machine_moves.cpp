// What a transition enters follows from its targets (computeEntrySet of SCXML's Appendix D), unless
// a history is among them: found once, here, for those that a robot takes all day.
// SPDX-License-Identifier: MIT
#include "load/machine_moves.h"

#include <algorithm>
#include <vector>

namespace trellis {

namespace {

bool is_state(const Program& program, RowId n) {
    return op_table()[program.at(n).op].group == OpGroup::state;
}

/// The rows that one transition enters.
class EntrySet {
public:
    explicit EntrySet(const Program& program) : program_(program) {}

    /// Their list, in document order; empty if what happens on the way is more than entering, or if
    /// they are too many to be kept for each transition.
    const std::vector<RowId>& of(const Transition& transition) {
        rows_.clear();
        add_targets(transition, transition.domain);
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            add_below(rows_[i]);
        }
        const auto is_silent = [&](RowId n) { return program_.state(n).silent; };
        plain_ = plain_ && std::all_of(rows_.begin(), rows_.end(), is_silent);
        if (!plain_) { rows_.clear(); }
        std::sort(rows_.begin(), rows_.end());
        plain_ = true;
        return rows_;
    }

private:
    static constexpr std::size_t most = 64;

    void add_targets(const Transition& transition, RowId top) {
        plain_ = plain_ && !transition.block && !transition.to_history;
        for (std::uint32_t i = 0; plain_ && i < transition.target_count; ++i) {
            add(program_.targets[transition.first_target + i], top);
        }
    }
    void add(RowId n, RowId top) {
        for (; n != top && !has(n); n = program_.at(n).parent) {
            rows_.push_back(n);
            plain_ = plain_ && rows_.size() <= most;
            if (!plain_) { return; }
        }
    }
    void add_below(RowId n) {
        if (!plain_) { return; }
        if (program_.at(n).op == Op::parallel_state) {
            for (const RowId region : children(program_, n)) {
                if (is_state(program_, region)) { add(region, n); }
            }
            return;
        }
        const TransitionId initial = program_.state(n).initial;
        const auto inside = [&](RowId other) { return program_.at(other).parent == n; };
        if (!initial || std::any_of(rows_.begin(), rows_.end(), inside)) { return; }
        add_targets(program_.transitions[initial.index], n);
    }
    bool has(RowId n) const { return std::find(rows_.begin(), rows_.end(), n) != rows_.end(); }

    const Program& program_;
    std::vector<RowId> rows_;
    bool plain_ = true;
};

}  // namespace

void find_moves(Program& program) {
    if (!program.is_machine()) { return; }
    for (RowId n{0}; n.index < program.rows.size(); ++n.index) {
        if (!is_state(program, n) || program.at(n).op == Op::history) { continue; }
        StateInfo& state = program.states[program.at(n).arg];
        state.silent = state.entry_count == 0 && state.exit_count == 0 && state.invokes == 0 &&
                       state.histories == 0 && program.at(n).op != Op::final;
    }
    EntrySet set(program);
    for (Transition& transition : program.transitions) {
        transition.first_entered = static_cast<std::uint32_t>(program.entered.size());
        if (!transition.domain) {
            transition.only_moves = transition.target_count == 0 && !transition.block;
            continue;
        }
        const std::vector<RowId>& rows = set.of(transition);
        transition.only_moves = !rows.empty();
        transition.entered_count = static_cast<std::uint32_t>(rows.size());
        program.entered.insert(program.entered.end(), rows.begin(), rows.end());
    }
    program.takes_plain_events = !program.has_eventless && !program.tick_event &&
                                 !program.event_slot && program.histories.empty() &&
                                 program.invokes.empty();
}

}  // namespace trellis
