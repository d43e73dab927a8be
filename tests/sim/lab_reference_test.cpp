// The check values of the lab's machine and tree, and the ties that no recorded run holds: what
// LAB.md states in numbers. Recorded runs are in lab_streams_test.cpp.
// SPDX-License-Identifier: MIT
#include "support/lab_reference.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

using Run = std::vector<LabRow> (*)(const LabWorld&, std::span<const double>, std::int64_t);

/// A world in which the move of `tick` is the first to touch a wall, the right one: the start is
/// turned until the robot is farther right after this tick than ever before, then moved that far.
LabWorld first_touch_after(std::int64_t tick, Run run, std::span<const double> angles) {
    for (double rotation = 0.0; rotation < 6.28; rotation += 0.01) {
        LabWorld open{.width = 100.0, .height = 100.0, .start = {50.0, 50.0, rotation}};
        const std::vector<LabRow> rows = run(open, angles, tick);
        double before = 0.0;
        for (const LabRow& row : rows)
            if (row.tick < tick && row.x > before) before = row.x;
        const double touch = (before + rows.back().x) / 2.0;
        if (rows.back().x - before < 1e-6) continue;
        open.start.x += open.width - open.radius - touch;
        return open;
    }
    FAIL("no start found");
    return {};
}

/// What x86-64 with glibc computes; another sine may differ in the last places.
bool is_near(double a, double b) {
    return a == doctest::Approx(b).epsilon(1e-12);
}

struct CheckValue {
    std::int64_t tick;
    double x, y, rotation, v, w;
    bool bumper;
    const char* leaf;
};

void check_values(const std::vector<LabRow>& rows, std::span<const CheckValue> values) {
    for (const CheckValue& value : values) {
        const LabRow& row = rows[static_cast<std::size_t>(value.tick)];
        CAPTURE(text_of(row));
        CHECK(is_near(row.x, value.x));
        CHECK(is_near(row.y, value.y));
        CHECK(is_near(row.rotation, value.rotation));
        CHECK(row.v == value.v);
        CHECK(row.w == value.w);
        CHECK(row.bumper == value.bumper);
        CHECK(row.leaf == value.leaf);
    }
}

const std::vector<double> first_angle = {-1.6660250211448278};  // rad, of the recorded run r00

}  // namespace

TEST_CASE("lab reference: the machine has the lab's values up to its first turn") {
    const CheckValue values[] = {
        {0, 3.2, 2.4, 0.0, 0.0, 0.0, false, "MoveForward"},
        {1, 3.2083333333333335, 2.4, 0.0, 0.5, 0.0, false, "MoveForward"},
        {181, 4.708333333333366, 2.4, 0.0, 0.5, 0.0, false, "MoveForward"},
        {182, 4.716665123542555, 2.400138876029283, 0.03333333333333333, 0.5, 2.0, false,
         "MoveInSpiral"},
        {242, 4.932064577482122, 2.761555192989254, 2.033222591362129, 0.5, 1.9933554817275747,
         false, "MoveInSpiral"},
        {1382, 3.6720329232189384, 2.054401893893297, 17.679913217325662, 0.5, 0.41637751561415687,
         false, "MoveInSpiral"},
        {2222, 4.004245888149031, 0.17117595084176696, 30.632698641704355, -0.1, 0.0, true,
         "GoBack"},
        {2253, 3.9688139018093818, 0.20645447609477524, 30.624365308371022, 0.0, -0.5, false,
         "Rotate"},
    };
    check_values(run_lab_machine(LabWorld{}, first_angle, 2253), values);
}

TEST_CASE("lab reference: the tree has the lab's values up to its first turn") {
    const CheckValue values[] = {
        {0, 3.2, 2.4, 0.0, 0.0, 0.0, false, "-"},
        {180, 4.700000000000032, 2.4, 0.0, 0.5, 0.0, false, "MoveForward"},
        {181, 4.708331790209221, 2.400138876029283, 0.03333333333333333, 0.5, 2.0, false,
         "MoveInSpiral"},
        {1381, 3.6636995898856046, 2.054401893893297, 17.679913217325662, 0.5, 0.41637751561415687,
         false, "MoveInSpiral"},
        {2221, 3.9985834527440254, 0.17116274080711258, 30.64382211222716, -0.1, 0.0, true,
         "GoBack"},
    };
    check_values(run_lab_tree(LabWorld{}, first_angle, 2221), values);
}

TEST_CASE("lab reference: machine and tree are equal for 180 ticks and differ in the next") {
    const std::vector<LabRow> machine = run_lab_machine(LabWorld{}, first_angle, 181);
    const std::vector<LabRow> tree = run_lab_tree(LabWorld{}, first_angle, 181);
    const auto same = [&](std::size_t tick) {
        const LabRow& a = machine[tick];
        const LabRow& b = tree[tick];
        return a.x == b.x && a.y == b.y && a.rotation == b.rotation && a.v == b.v && a.w == b.w &&
               a.leaf == b.leaf;
    };
    for (std::size_t tick = 1; tick <= 180; ++tick)
        REQUIRE(same(tick));
    CHECK_FALSE(same(181));
}

TEST_CASE("lab reference: a spiral that times out at a wall, in the machine: the bumper wins") {
    const std::vector<double> angles = {1.0};
    const LabWorld world = first_touch_after(1382, run_lab_machine, angles);
    const std::vector<LabRow> rows = run_lab_machine(world, angles, 1383);
    CHECK(rows[1382].leaf == "MoveInSpiral");
    CHECK_FALSE(rows[1382].bumper);
    CHECK(rows[1383].bumper);
    CHECK(rows[1383].leaf == "GoBack");
}

TEST_CASE("lab reference: a spiral that times out at a wall, in the tree: the bumper is ignored") {
    const std::vector<double> angles = {1.0};
    const LabWorld world = first_touch_after(1380, run_lab_tree, angles);
    const std::vector<LabRow> rows = run_lab_tree(world, angles, 1382);
    CHECK_FALSE(rows[1380].bumper);
    CHECK(rows[1381].bumper);
    CHECK(rows[1381].path == "MoveInSpiral");
    CHECK(rows[1381].status == "SUCCESS");
    CHECK(rows[1381].w == 0.41637751561415687);
    CHECK(rows[1382].bumper);
    CHECK(rows[1382].path == "MoveForward>GoBack");
    CHECK(rows[1382].status == "RUNNING");
}
