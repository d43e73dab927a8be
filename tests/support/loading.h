// From a text to a program, or to what is wrong with it, in one line of a test.
// Covered by the tests that use it.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "load/load.h"
#include "support/script_leaves.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace trellis::test {

/// The program of `text`, which must have no faults; else the test fails with what it is told.
Program loaded(std::string_view text, const LoadOptions& options = {},
               const Registry& registry = script_registry());

/// What load() has to say about a text that has faults: one "line:column: id: message" per line.
std::string complaints(std::string_view text, const LoadOptions& options = {},
                       const Registry& registry = script_registry());

/// Texts by name, as the files that includes and `src` attributes find; paths are names.
class Texts final : public SourceReader {
public:
    void add(std::string name, std::string text) {
        texts_.emplace(std::move(name), std::move(text));
    }
    std::optional<Source> read(std::string_view path, std::string_view from,
                               std::string_view package) override;

private:
    std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace trellis::test
