// Reading and recording goldens.
// SPDX-License-Identifier: MIT
#include "support/goldens.h"

#include "support/files.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

namespace trellis::test {

std::optional<std::string> golden(const std::filesystem::path& name, const std::string& text) {
    const auto path = std::filesystem::path(TRELLIS_SOURCE_DIR) / "tests" / "golden" / name;
    if (std::getenv("TRELLIS_UPDATE_GOLDENS") != nullptr) {
        std::filesystem::create_directories(path.parent_path());
        std::ofstream out(path, std::ios::binary);
        out << text;
        REQUIRE_MESSAGE(out.good(), "cannot write ", path.string());
        return {};
    }
    REQUIRE_MESSAGE(std::filesystem::exists(path), path.string(),
                    " is missing: record it with script/update-goldens");
    return read_file(path);
}

}  // namespace trellis::test
