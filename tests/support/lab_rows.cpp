// Comparing rows of lab runs.
// SPDX-License-Identifier: MIT
#include "support/lab_rows.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace trellis::test {
namespace {

#if defined(__x86_64__) && defined(__GLIBC__)
constexpr double tolerance = 0.0;  // m, rad, m/s, rad/s
#else
constexpr double tolerance = 1e-9;
#endif

bool agrees(const LabRow& ours, const LabRow& recorded) {
    const auto near = [](double a, double b) { return std::fabs(a - b) <= tolerance; };
    return ours.tick == recorded.tick && ours.bumper == recorded.bumper &&
           ours.leaf == recorded.leaf &&
           (recorded.status.empty() || ours.status == recorded.status) &&
           (recorded.path.empty() || ours.path == recorded.path) && near(ours.x, recorded.x) &&
           near(ours.y, recorded.y) && near(ours.rotation, recorded.rotation) &&
           near(ours.v, recorded.v) && near(ours.w, recorded.w);
}

}  // namespace

void check_rows(const std::vector<LabRow>& run, const std::vector<LabRow>& recorded) {
    for (const LabRow& row : recorded) {
        REQUIRE(static_cast<std::size_t>(row.tick) < run.size());
        const LabRow& ours = run[static_cast<std::size_t>(row.tick)];
        if (agrees(ours, row)) continue;
        FAIL_CHECK("ours     " << text_of(ours) << "\nrecorded " << text_of(row));
        return;
    }
}

void check_events(const std::vector<LabRow>& run, const std::vector<LabRow>& recorded) {
    std::vector<std::int64_t> ours, theirs;
    for (std::size_t i = 0; i < run.size(); ++i)
        if (run[i].tick % 600 == 0 || run[i].leaf != run[i - 1].leaf || run[i].bumper)
            ours.push_back(run[i].tick);
    for (const LabRow& row : recorded)
        theirs.push_back(row.tick);
    CHECK(ours == theirs);
}

}  // namespace trellis::test
