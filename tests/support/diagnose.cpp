// Loads a text and keeps what was found. Covered by tests/load/faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "support/diagnose.h"

#include "load/load.h"
#include "support/files.h"

#include <filesystem>
#include <optional>

namespace trellis::test {

namespace {

/// Files are included from the corpus.
class Corpus final : public SourceReader {
public:
    std::optional<Source> read(std::string_view path, std::string_view, std::string_view) override {
        const auto file = std::filesystem::path(TRELLIS_SOURCE_DIR) / "tests/faults" / path;
        if (!std::filesystem::is_regular_file(file)) { return {}; }
        return Source{std::string(path), read_file(file)};
    }
};

}  // namespace

Findings diagnose(const std::string& name, std::string_view text, const Registry& registry) {
    const Source source{name, std::string(text)};
    Corpus corpus;
    const LoadOptions options{.reader = &corpus};
    Findings out;
    Diagnostics reading;
    if (const std::optional<Document> document = read(source, reading, options)) {
        out.readable = true;
        out.kind = kind_of(*document);
    }
    static_cast<void>(load(source, registry, out.diagnostics, options));
    return out;
}

}  // namespace trellis::test
