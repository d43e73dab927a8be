// Every behaviour file of trees/ and machines/ exists in XML and in JSON, loads without a message,
// and both spellings are the same program. What the programs do is in traces_test.cpp.
// SPDX-License-Identifier: MIT
#include "sim/bridge/leaves.h"
#include "support/behaviours.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

namespace fs = std::filesystem;

/// The first lines of two texts that differ, below each other.
std::string first_difference(const std::string& a, const std::string& b) {
    const auto ours = lines_of(a), theirs = lines_of(b);
    for (std::size_t i = 0; i < ours.size() || i < theirs.size(); ++i) {
        const auto x = i < ours.size() ? ours[i] : "(end)";
        const auto y = i < theirs.size() ? theirs[i] : "(end)";
        if (x != y) return std::string(x) + '\n' + std::string(y);
    }
    return "(the dumps are equal)";
}

}  // namespace

TEST_CASE("twins: every behaviour file in XML has a twin in JSON, and the other way round") {
    std::vector<fs::path> expected, twins;
    for (const fs::path& file : xml_behaviours())
        expected.push_back(json_twin(file));
    for (const auto* folder : {"machines", "trees"})
        for (const fs::path& file : files_below(folder, {".json"}))
            twins.push_back(file);
    std::sort(expected.begin(), expected.end());
    std::sort(twins.begin(), twins.end());
    CHECK(expected.size() >= 4);
    CHECK(expected == twins);
}

TEST_CASE("twins: both spellings of a behaviour compile without messages to equal programs") {
    Registry registry;
    register_roomba(registry);
    for (const fs::path& file : xml_behaviours()) {
        CAPTURE(file.generic_string());
        const Program xml = program_of(file, registry);
        const Program json = program_of(json_twin(file), registry);
        CHECK_MESSAGE(xml == json, first_difference(dump(xml), dump(json)));
    }
}
