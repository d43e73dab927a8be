// The spelling of DOT.
// SPDX-License-Identifier: MIT
#include "runner/drawing/dot.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::drawing;

TEST_CASE("dot: strings and labels show any text as it is") {
    CHECK(dot_string("a\"b\\n\nc") == "\"a\\\"b\\\\n\\nc\"");
    CHECK(dot_label({"a<b", "\"&"}, 1) == "<<b>a&lt;b</b><br/>&quot;&amp;>");
    CHECK(dot_label({"", "x"}, 1) == "<<br/>x>");
    CHECK(dot_status(DrawingStatus::none).empty());
    CHECK(dot_status(DrawingStatus::failure) ==
          ", fillcolor=\"#ffd4d0\", color=\"#c92a2a\", penwidth=3");
}
