// Validators that are not ours: xmllint for XML Schema, Python's jsonschema for JSON Schema. Each
// is one process for many files, because starting it takes longer than its work. Covered by
// tests/load/faults_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace trellis::test {

using Paths = std::vector<std::filesystem::path>;

/// Those of `files` that are well-formed and valid by the schema; none if the validator is not
/// installed. Fails the test case if the schema itself is not accepted.
std::optional<std::set<std::filesystem::path>> valid_by_xmllint(const std::filesystem::path& schema,
                                                                const Paths& files);
std::optional<std::set<std::filesystem::path>>
valid_by_jsonschema(const std::filesystem::path& schema, const Paths& files);

/// An empty folder that is removed with this.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Writes a file into it; returns its path.
    std::filesystem::path write(const std::string& name, const std::string& text) const;

private:
    std::filesystem::path path_;
};

}  // namespace trellis::test
