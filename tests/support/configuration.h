// The configuration of a machine as tests write it. Covered by the tests that use it.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "core/state.h"

#include <algorithm>
#include <string>
#include <vector>

namespace trellis::test {

/// The ids of the active states, sorted, with blanks between.
inline std::string configuration(const Program& program, const State& state) {
    std::vector<std::string> names;
    for (const RowId n : state.session.active) {
        names.push_back(program.names[n.index]);
    }
    std::sort(names.begin(), names.end());
    std::string out;
    for (const std::string& name : names) {
        out += (out.empty() ? "" : " ") + name;
    }
    return out;
}

}  // namespace trellis::test
