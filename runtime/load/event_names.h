// The event names of a machine as rows in which every prefix is an interval, so that matching a
// descriptor is two comparisons (SCXML 3.12.1). Private to runtime/load.
// Covered by tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/program.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// Collects names, then numbers them.
class EventNames {
public:
    /// Adds a name, or a descriptor: "a.b", "a.b.", "a.b.*" are the same, "*" and ".*" are all.
    void add(std::string_view name);
    /// The rows of Program::events; add() nothing afterwards.
    std::vector<EventName> table() const;
    /// The row of a name that was added, in `table`.
    static EventId find(const std::vector<EventName>& table, std::string_view name);

private:
    // by token: the dot sorts before every other character, so that a name stands right before the
    // names it is a prefix of
    struct ByToken {
        using is_transparent = void;
        bool operator()(std::string_view a, std::string_view b) const;
    };
    static std::string_view bare(std::string_view name);

    std::set<std::string, ByToken> names_;
};

}  // namespace trellis
