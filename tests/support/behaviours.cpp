// Loading the behaviour files that are checked in.
// SPDX-License-Identifier: MIT
#include "support/behaviours.h"

#include "load/diagnostics.h"
#include "load/load.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <optional>
#include <string_view>
#include <utility>

namespace trellis::test {

namespace {

/// What a behaviour refers to, by paths as program_of() takes them.
class BehaviourFiles final : public SourceReader {
public:
    std::optional<Source> read(std::string_view path, std::string_view from,
                               std::string_view) override {
        const std::filesystem::path file =
            (std::filesystem::path(from).parent_path() / path).lexically_normal();
        return Source{.name = file.generic_string(), .text = read_file(TRELLIS_SOURCE_DIR / file)};
    }
};

}  // namespace

Program program_of(const std::filesystem::path& file, const Registry& registry) {
    const Source source{.name = file.generic_string(),
                        .text = read_file(TRELLIS_SOURCE_DIR / file)};
    Diagnostics diagnostics;
    BehaviourFiles files;
    std::optional<Program> program = load(source, registry, diagnostics, {.reader = &files});
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
