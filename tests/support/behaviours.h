// Loading the behaviour files that are checked in, for tests that run them. The product's reader of
// files is in runner/. Covered by every test in tests/golden.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace trellis::test {

/// The program of a file below TRELLIS_SOURCE_DIR, against leaves that outlive it. A file that does
/// not load without errors and warnings fails the test case and shows them.
Program program_of(const std::filesystem::path& file, const Registry& registry);

/// The behaviour files of trees/ and machines/ in XML, as paths relative to TRELLIS_SOURCE_DIR,
/// sorted.
std::vector<std::filesystem::path> xml_behaviours();

/// The file that says the same in JSON.
std::filesystem::path json_twin(std::filesystem::path file);

}  // namespace trellis::test
