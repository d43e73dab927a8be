// The option --world: which world a run is in. Reading the file is the program's, understanding it
// sim/bridge/world_file.h's. Covered by tests/runner/world_argument_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/streams.h"
#include "sim/walled_world.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace trellis {

/// What --world names.
struct WorldArgument {
    std::string name = "lab";  ///< "lab", "none", or a file

    bool is_lab() const { return name == "lab"; }
    bool is_none() const { return name == "none"; }
};

/// Adds --world to a command.
void add_option(CLI::App& app, WorldArgument& argument);

/// The world of a file; none after messages, with what to return in `exit`.
std::optional<WalledWorld> load_world(const std::string& file, Streams& streams, Exit& exit);

}  // namespace trellis
