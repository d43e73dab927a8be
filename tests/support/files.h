// Reading the repository's own files in tests. The product has its own reader (runner/); this one
// stops the test when a file is missing. Covered by every test in tests/project.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

/// The whole content of a file, bytes as they are. A file that cannot be read fails the test case.
std::string read_file(const std::filesystem::path& path);

/// The lines of a text without their newlines; a last line without one counts, an empty text has
/// none. The views belong to the owner of `text`.
std::vector<std::string_view> lines_of(std::string_view text);

/// Every file below TRELLIS_SOURCE_DIR/`folder` whose extension is one of `extensions` (with dot),
/// as paths relative to TRELLIS_SOURCE_DIR, sorted; none if there is no such folder.
std::vector<std::filesystem::path> files_below(std::string_view folder,
                                               const std::vector<std::string_view>& extensions);

}  // namespace trellis::test
