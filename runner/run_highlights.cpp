// From rows to elements.
// SPDX-License-Identifier: MIT
#include "runner/run_highlights.h"

#include <map>

namespace trellis {

namespace {

bool is_state(const Program& program, RowId n) {
    return op_table()[program.at(n).op].group == OpGroup::state;
}

DrawingStatus drawing_status(Status status, bool state) {
    switch (status) {
    case Status::idle: return DrawingStatus::idle;
    case Status::running: return state ? DrawingStatus::active : DrawingStatus::running;
    case Status::success: return DrawingStatus::success;
    case Status::failure: return DrawingStatus::failure;
    case Status::skipped: return DrawingStatus::skipped;
    }
    return DrawingStatus::none;
}

/// Of two rows of one element the one with the higher rank is shown.
int rank(DrawingStatus status) {
    switch (status) {
    case DrawingStatus::none: return 0;
    case DrawingStatus::idle: return 1;
    case DrawingStatus::skipped: return 2;
    case DrawingStatus::success: return 3;
    case DrawingStatus::failure: return 4;
    case DrawingStatus::running:
    case DrawingStatus::active: return 5;
    }
    return 0;
}

std::vector<Highlight> in_order(const std::map<ElementId, DrawingStatus>& statuses) {
    std::vector<Highlight> highlights;
    for (const auto& [element, status] : statuses) {
        highlights.push_back({.element = element, .status = status, .note = {}});
    }
    return highlights;
}

}  // namespace

std::vector<Highlight> highlights_at(const Program& program, const Places& places,
                                     const RowStatuses& statuses, std::uint64_t tick) {
    std::map<ElementId, DrawingStatus> found;
    for (RowId n{program.is_machine() ? 1U : 0U}; n.index < program.rows.size(); ++n.index) {
        const ElementId e = places.of(n);
        if (!e) { continue; }
        const DrawingStatus status = drawing_status(statuses.at(n, tick), is_state(program, n));
        DrawingStatus& shown = found[e];
        if (rank(status) > rank(shown)) { shown = status; }
    }
    for (TransitionId t{0}; t.index < program.transitions.size(); ++t.index) {
        const ElementId e = places.of(t);
        if (e && statuses.taken(t, tick)) { found[e] = DrawingStatus::active; }
    }
    return in_order(found);
}

std::vector<Highlight> highlights_unreached(const Program& program, const Places& places,
                                            const RowStatuses& statuses) {
    std::map<ElementId, bool> reached;  // of nodes and states: by any of its rows
    for (RowId n{program.is_machine() ? 1U : 0U}; n.index < program.rows.size(); ++n.index) {
        if (const ElementId e = places.of(n)) {
            bool& any = reached[e];
            any = any || statuses.reached(n);
        }
    }
    std::vector<Highlight> highlights;
    for (const auto& [element, any] : reached) {
        if (!any) { highlights.push_back({element, DrawingStatus::idle, "never reached"}); }
    }
    for (TransitionId t{0}; t.index < program.transitions.size(); ++t.index) {
        const ElementId e = places.of(t);
        if (e && !statuses.taken(t)) {
            highlights.push_back({e, DrawingStatus::idle, "never taken"});
        }
    }
    return highlights;
}

}  // namespace trellis
