// Rows of a trace.
// SPDX-License-Identifier: MIT
#include "sim/bridge/trace_csv.h"

#include <doctest/doctest.h>

using namespace trellis;

TEST_CASE("trace csv: numbers in their shortest form") {
    EpisodeRow row{.tick = 2, .time = 2.0 / 60.0, .robot = {}, .leaf = "Rotate"};
    row.robot.x = 3.2;
    row.robot.y = 0.1 + 0.2;
    row.robot.rotation = -0.0;
    row.robot.v = 1e-7;
    row.robot.bumper = true;
    std::string out;
    append_trace_csv(out, row);
    CHECK(out == "2,0.03333333333333333,3.2,0.30000000000000004,-0.0,1e-07,0.0,1,Rotate\n");
}

TEST_CASE("trace csv: a name that would end its field is quoted") {
    std::string out;
    append_trace_csv(out, {.leaf = "a,\"b\"\nc"});
    CHECK(out == "0,0.0,0.0,0.0,0.0,0.0,0.0,0,\"a,\"\"b\"\"\nc\"\n");
}
