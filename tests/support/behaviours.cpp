// Loading the behaviour files that are checked in.
// SPDX-License-Identifier: MIT
#include "support/behaviours.h"

#include "load/diagnostics.h"
#include "load/load.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <optional>
#include <utility>

namespace trellis::test {

Program program_of(const std::filesystem::path& file, const Registry& registry) {
    const Source source{.name = file.generic_string(),
                        .text = read_file(TRELLIS_SOURCE_DIR / file)};
    Diagnostics diagnostics;
    std::optional<Program> program = load(source, registry, diagnostics);
    REQUIRE_MESSAGE(diagnostics.all().empty(), diagnostics.render());
    return std::move(program).value();
}

std::vector<std::filesystem::path> xml_behaviours() {
    std::vector<std::filesystem::path> files = files_below("machines", {".scxml"});
    const std::vector<std::filesystem::path> trees = files_below("trees", {".xml"});
    files.insert(files.end(), trees.begin(), trees.end());
    return files;
}

std::filesystem::path json_twin(std::filesystem::path file) {
    return file.replace_extension(".json");
}

}  // namespace trellis::test
