// The behaviours that come with Trellis, damaged at random: whatever becomes of them is either
// refused with diagnostics or runs. TRELLIS_MUTATIONS in the environment sets another number of
// texts than the short run that belongs to every test run.
// SPDX-License-Identifier: MIT
#include "sim/bridge/leaves.h"
#include "sim/roomba.h"
#include "support/files.h"
#include "support/script_leaves.h"
#include "support/survival.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {
namespace {

std::size_t wanted_texts() {
    const char* number = std::getenv("TRELLIS_MUTATIONS");
    return number == nullptr ? 10'000 : std::stoul(number);
}

}  // namespace

TEST_CASE("mutations: damaged behaviour files are refused or run, and never crash") {
    std::vector<std::string> texts;
    for (const char* folder : {"trees", "machines", "tests/faults"}) {
        for (const auto& path : files_below(folder, {".xml", ".scxml", ".json"})) {
            // of the small files those without faults: the others are refused anyway
            const bool good = std::string_view(folder) != "tests/faults" ||
                              path.filename().string().starts_with("good_");
            if (good) { texts.push_back(read_file(TRELLIS_SOURCE_DIR / path)); }
        }
    }
    REQUIRE_FALSE(texts.empty());
    Registry registry;
    register_roomba(registry);
    Roomba robot;
    Random random(std::int64_t{60});
    Survival survival;
    while (survival.texts < wanted_texts()) {
        const auto last = static_cast<std::int64_t>(texts.size()) - 1;
        const std::string& text = texts[static_cast<std::size_t>(random.whole(0, last))];
        survive(damaged(text, random), registry, robot, survival);
    }
    MESSAGE(survival.texts, " damaged texts, ", survival.loaded, " loaded, ", survival.faults,
            " runs ended in a fault");
}

}  // namespace trellis::test
