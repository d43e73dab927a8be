// The findings of tree_statuses.h in words.
// SPDX-License-Identifier: MIT
#include "load/tree_checks.h"

#include "load/tree_statuses.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace trellis {

namespace {

Where place_of(const Program& program, RowId n) {
    const Origin& origin = program.origins[n.index];
    return {origin.file, origin.line, origin.column};
}

std::string named(const Program& program, RowId n) {
    return '"' + std::string(program.name(n)) + '"';
}

/// `"name" in line 7`: nodes of one tree are in one file.
std::string with_line(const Program& program, RowId n) {
    return named(program, n) + " in line " + std::to_string(program.origins[n.index].line);
}

std::string reason_of(const Program& program, const NeverTicked& rows) {
    using enum NeverTicked::Reason;
    switch (rows.reason) {
    case never_succeeds: return with_line(program, rows.cause) + " never succeeds";
    case never_fails: return with_line(program, rows.cause) + " never fails";
    case nothing_fails: return "nothing before it can fail";
    case switched_off: break;
    case no_cycles: return "num_cycles is 0";
    case no_attempts: return "num_attempts is 0";
    case no_elements: return "the queue is empty";
    case same_case: return "its case is that of " + with_line(program, rows.cause);
    case no_variable:
        return "nothing gives the variable of " + with_line(program, rows.cause) + " a value";
    }
    return {};
}

/// The rows of `all` that come from different places, in their order: a subtree has its rows at
/// every place where it is used.
template <class Found, class RowOf>
void keep_places(const Program& program, std::vector<Found>& all, RowOf row_of) {
    const auto place = [&](const Found& found) {
        const Origin& at = program.origins[row_of(found).index];
        return std::tuple(at.file, at.line, at.column);
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const Found& a, const Found& b) { return place(a) < place(b); });
    all.erase(std::unique(all.begin(), all.end(),
                          [&](const Found& a, const Found& b) { return place(a) == place(b); }),
              all.end());
}

}  // namespace

void check_trees(const Program& program, const std::vector<SlotId>& unset,
                 Diagnostics& diagnostics) {
    TreeStatuses found = find_statuses(program, unset);
    keep_places(program, found.never_ticked, [](const NeverTicked& rows) { return rows.first; });
    for (const NeverTicked& rows : found.never_ticked) {
        // `_skipIf="true"` is written to switch a node off: its author knows
        if (rows.reason == NeverTicked::Reason::switched_off) { continue; }
        diagnostics.warning("never-ticked", place_of(program, rows.first),
                            named(program, rows.first) +
                                " is never ticked: " + reason_of(program, rows));
    }
    keep_places(program, found.endless, [](RowId n) { return n; });
    for (const RowId n : found.endless) {
        const RowId child{n.index + 1};
        const bool repeats = program.at(n).op == Op::repeat;
        diagnostics.warning("endless-loop", place_of(program, n),
                            named(program, n) + " never ends: " + with_line(program, child) +
                                (repeats ? " always succeeds" : " always fails") + " at once");
    }
}

}  // namespace trellis
