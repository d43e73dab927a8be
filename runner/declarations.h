// Nodes that are known only by their declaration in a <TreeNodesModel>, as those of another robot:
// files that use them can be validated and drawn, and run where other nodes stand in their place
// (--mock). Where leaves answer by hand, only controls and decorators need that. Covered by
// tests/runner/declarations_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/behaviour.h"

#include <optional>
#include <string>
#include <vector>

namespace trellis {

/// Registers the nodes that the <TreeNodesModel>s of a document declare, with their ports, but for
/// subtrees and those that are built in or that the registry already has. One that the registry has
/// with other ports is taken for another robot's, and replaces it. All their inputs may be absent.
void declare_nodes(const Document& document, Registry& registry);

/// Whether a node of the registry is only declared: it has no function to tick.
inline bool is_declared(const LeafType& type) {
    return type.tick == nullptr;
}

/// A tree file that has a palette and no tree: what `trellis nodes --xml` writes.
bool is_palette(const Document& document);

/// Reads and compiles a file, with the nodes known that the files of --nodes, the file itself and
/// those it includes declare. None after messages, with what to return in `exit`; what is wrong in
/// the file itself is not told. `registry` must outlive the result.
std::optional<Behaviour> read_declaring(const std::string& file, const LoadArguments& arguments,
                                        Registry& registry, Streams& streams, Exit& exit);

/// The same, and tells what is wrong; none if it has no program.
std::optional<Behaviour> load_declaring(const std::string& file, const LoadArguments& arguments,
                                        Registry& registry, Streams& streams, Exit& exit);

/// What of a file may be only declared where it is loaded to run.
enum class Declared { nothing, leaves };

/// The same of a file that is to be run: any other node that is only declared is an error.
std::optional<Behaviour> load_behaviour(const std::string& file, const LoadArguments& arguments,
                                        Registry& registry, Streams& streams, Exit& exit,
                                        Declared allowed = Declared::nothing);

}  // namespace trellis
