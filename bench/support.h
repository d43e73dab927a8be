// What the benchmarks share: loading a text that must load, and leaves that do nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "load/load.h"

#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

namespace trellis::bench {

/// What these leaves act on: nothing.
struct Host {};

struct Busy {
    Status tick(Host&, const Tick&) const { return Status::running; }
};
struct Done {
    Status tick(Host&, const Tick&) const { return Status::success; }
};
struct Yes {
    bool tick(Host&, const Tick&) const { return true; }
};

/// Busy (always running), Done (succeeds at once), Yes (a condition that holds).
inline const Registry& idle_registry() {
    static Registry registry;
    if (registry.leaves().empty()) {
        registry.add<Busy, Host>("Busy", "runs for ever");
        registry.add<Done, Host>("Done", "succeeds at once");
        registry.add<Yes, Host>("Yes", "holds");
    }
    return registry;
}

/// The program of a text; ends the benchmark with its diagnostics if it has faults.
inline Program loaded(const std::string& name, std::string text,
                      const Registry& registry = idle_registry()) {
    Diagnostics diagnostics;
    std::optional<Program> program = load({name, std::move(text)}, registry, diagnostics);
    if (!program) {
        std::cerr << diagnostics.render();
        std::abort();
    }
    return std::move(*program);
}

}  // namespace trellis::bench
