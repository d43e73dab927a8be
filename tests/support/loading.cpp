// Loading texts in tests.
// SPDX-License-Identifier: MIT
#include "support/loading.h"

#include <doctest/doctest.h>

namespace trellis::test {

Program loaded(std::string_view text, const LoadOptions& options, const Registry& registry) {
    Diagnostics diagnostics;
    std::optional<Program> program =
        load({.name = "test", .text = std::string(text)}, registry, diagnostics, options);
    INFO(diagnostics.render());
    REQUIRE(program.has_value());
    return std::move(*program);
}

std::string complaints(std::string_view text, const LoadOptions& options,
                       const Registry& registry) {
    Diagnostics diagnostics;
    const bool good =
        load({.name = "test", .text = std::string(text)}, registry, diagnostics, options)
            .has_value();
    std::string out;
    for (const Diagnostic& d : diagnostics.all()) {
        out += std::to_string(d.where.line) + ':' + std::to_string(d.where.column) + ": " + d.id +
               ": " + d.message + '\n';
    }
    CHECK(good == diagnostics.ok());
    return out;
}

std::optional<Source> Texts::read(std::string_view path, std::string_view, std::string_view) {
    const auto found = texts_.find(path);
    if (found == texts_.end()) { return {}; }
    return Source{found->first, found->second};
}

}  // namespace trellis::test
