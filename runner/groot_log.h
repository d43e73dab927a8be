// A recorded run of a tree as a .btlog, the format of BehaviorTree.CPP's FileLogger2, which Groot2
// replays (TREES 2.5). Covered by tests/runner/trace_convert_test.cpp, which reads one back byte by
// byte.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "load/document.h"
#include "runner/recording.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace trellis {

/// A .btlog numbers nodes with 16 bits, from 1. BehaviorTree.CPP wraps beyond that (TREES 3, D7).
inline constexpr std::size_t most_groot_nodes = 65'535;

/// The tree as BehaviorTree.CPP's WriteTreeToXML writes it with metadata: a <BehaviorTree> for each
/// use of a tree, `_fullpath` and `_uid` on what they name, and a palette of the leaves of
/// `registry`. The `_uid` of a row is its number. `files` are the documents of Program::files, by
/// index; of one that is empty only the kinds and names of nodes are known.
std::string groot_xml(const Program& program, std::span<const Document> files,
                      const Registry& registry);

/// The whole file: its header with `xml`, the time at which the run began (microseconds since the
/// Unix epoch), and a record of 9 bytes for each change of a stored status. The program must be a
/// tree of at most most_groot_nodes nodes.
std::string groot_log(const Recording& recording, std::string_view xml, std::int64_t start);

}  // namespace trellis
