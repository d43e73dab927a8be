// The line that tells how far a sweep has come.
// SPDX-License-Identifier: MIT
#include "runner/sweep/progress.h"

#include <doctest/doctest.h>

#include <sstream>

namespace trellis {

TEST_CASE("sweep progress: bar, rate and what is left") {
    CHECK(progress_line(0, 10, 0, 0.0) == "[------------------------------]  0/10");
    CHECK(progress_line(5, 10, 5, 2.5) ==
          "[###############---------------]  5/10  2.00 runs/s  3 s left");
    // what a run before this one has done does not count for the rate
    CHECK(progress_line(900, 1000, 100, 1.0) ==
          "[###########################---]  900/1000  100 runs/s  1 s left");
    CHECK(progress_line(10, 1000, 10, 10.0).ends_with("  1.00 runs/s  16 min 30 s left"));
    CHECK(progress_line(10, 100'010, 10, 10.0).ends_with("  27 h 46 min left"));
}

TEST_CASE("sweep progress: nothing is said where nobody watches") {
    std::ostringstream out;
    {
        Progress progress(out, false, 0, 1);
        progress.add();
    }
    CHECK(out.str() == "");
    { const Progress progress(out, true, 0, 1); }
    CHECK(out.str() == "\r\x1b[K");
}

}  // namespace trellis
