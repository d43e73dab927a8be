// Comparing a text with a recorded one in tests/golden, or recording it: TRELLIS_UPDATE_GOLDENS=1
// in the environment writes instead (script/update-goldens). Covered by every test in tests/golden.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace trellis::test {

/// The recorded text of tests/golden/`name`, to compare with `text`. None if goldens are being
/// updated: then `text` was recorded and there is nothing to compare. A golden that is missing
/// fails the test case.
std::optional<std::string> golden(const std::filesystem::path& name, const std::string& text);

}  // namespace trellis::test
