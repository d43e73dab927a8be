// What every file and folder of the repository has: a first comment with its licence, a README, a
// size one can read. What a file includes is the business of layers_test.cpp.
// SPDX-License-Identifier: MIT
#include "support/files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace {

using namespace trellis::test;

constexpr std::size_t longest_first_comment = 12;  // lines, with the licence
constexpr std::size_t longest_file = 450;          // lines; beyond it usually lie two subjects

/// True if the text begins with comment lines, at least one before the licence line.
bool opens_with_comment(std::string_view text) {
    std::size_t count = 0;
    for (const std::string_view line : lines_of(text)) {
        if (!line.starts_with("//") || count > longest_first_comment) return false;
        if (line == "// SPDX-License-Identifier: MIT") return count > 0;
        ++count;
    }
    return false;
}

}  // namespace

TEST_CASE("files: each source file opens with a comment and its licence") {
    CHECK(opens_with_comment("// What it is.\n// SPDX-License-Identifier: MIT\n"));
    CHECK_FALSE(opens_with_comment("// SPDX-License-Identifier: MIT\n"));
    CHECK_FALSE(opens_with_comment("#pragma once\n// What.\n// SPDX-License-Identifier: MIT\n"));
    for (const std::string_view folder : {"runtime", "sim", "runner", "tests", "bench"}) {
        for (const auto& file : files_below(folder, {".h", ".cpp", ".def"})) {
            const std::string text = read_file(TRELLIS_SOURCE_DIR / file);
            CHECK_MESSAGE(opens_with_comment(text), file.generic_string(),
                          ":1: does not open with 1 to 12 comment lines and the SPDX line");
            if (const std::size_t lines = lines_of(text).size(); lines > longest_file)
                MESSAGE(file.generic_string(), ": ", lines, " lines: two subjects?");
        }
    }
}

TEST_CASE("files: each folder of the map has a README of at most a page") {
    constexpr std::size_t page = 80;  // lines
    for (const std::string_view folder :
         {"runtime/core", "runtime/load", "runtime/exec", "sim", "sim/bridge", "runner", "trees",
          "machines", "schemas", "tests", "bench", "docs"}) {
        const auto readme = std::filesystem::path(TRELLIS_SOURCE_DIR) / folder / "README.md";
        CHECK_MESSAGE(std::filesystem::exists(readme), folder, "/README.md is missing");
        if (std::filesystem::exists(readme)) {
            const std::string text = read_file(readme);
            CHECK_MESSAGE(lines_of(text).size() <= page, folder, "/README.md is too long");
        }
    }
}
