// How much of its room the lab's robot covers in ten minutes: the figures that settings of
// machines/roomba.scxml are known to have, within the error of a sample of seeds.
// SPDX-License-Identifier: MIT
#include "load/load.h"
#include "sim/bridge/episode.h"
#include "sim/bridge/leaves.h"
#include "sim/coverage.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace trellis {
namespace {

/// machines/roomba.scxml with other times, in s.
Program machine(const std::string& forward_time, const std::string& spiral_time) {
    std::string text = test::read_file(TRELLIS_SOURCE_DIR "/machines/roomba.scxml");
    const auto set = [&](const std::string& name, const std::string& value) {
        const std::size_t begin = text.find("expr=\"", text.find("id=\"" + name + '"')) + 6;
        text.replace(begin, text.find('"', begin) - begin, value);
    };
    set("forward_time", forward_time);
    set("spiral_time", spiral_time);
    // programs point to their leaves: the registry outlives them
    static Registry registry;
    if (registry.leaves().empty()) { register_roomba(registry); }
    Diagnostics diagnostics;
    std::optional<Program> program = load({"roomba.scxml", text}, registry, diagnostics);
    REQUIRE_MESSAGE(program, diagnostics.render());
    return *program;
}

/// Covered after ten minutes, in % of the reachable floor.
double covered(const Program& program, const Floor& floor, std::int64_t seed) {
    Episode episode(program, {.random = Random(seed)});
    Coverage coverage(floor);
    while (episode.state().tick < 36'000 && episode.tick())
        coverage.add(episode.robot().x, episode.robot().y, episode.state().tick);
    return 100.0 * coverage.share();
}

struct Sample {
    double mean = 0.0;
    double deviation = 0.0;
};

Sample sample(const std::string& forward_time, const std::string& spiral_time, int seeds) {
    const Program program = machine(forward_time, spiral_time);
    const Floor floor = floor_of(LabWorld{});
    double sum = 0.0;
    double squares = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
        const double value = covered(program, floor, seed);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / seeds;
    return {.mean = mean, .deviation = std::sqrt(squares / seeds - mean * mean)};
}

/// Whether a sample's mean is within four standard errors of `mean`.
void check_mean(const Sample& found, double mean, double deviation, int seeds) {
    CAPTURE(found.mean);
    CHECK(std::fabs(found.mean - mean) < 4.0 * deviation / std::sqrt(seeds));
}

TEST_CASE("lab coverage: the lab's times cover 62 %, and differ by 11 points from seed to seed") {
    const Sample found = sample("3.0", "20.0", 40);
    check_mean(found, 61.6, 11.0, 40);
    CHECK(found.deviation > 7.0);
    CHECK(found.deviation < 15.0);
}

TEST_CASE("lab coverage: bouncing without spirals covers more, and so do rare spirals") {
    check_mean(sample("1e9", "20.0", 20), 78.7, 3.5, 20);
    check_mean(sample("10.0", "20.0", 20), 81.9, 3.5, 20);
}

TEST_CASE("lab coverage: some times lock the robot into an orbit that meets no wall") {
    const Sample found = sample("2.0", "8.0", 2);
    CHECK(found.mean == doctest::Approx(18.8).epsilon(0.01));
    CHECK(found.deviation < 0.001);
}

}  // namespace
}  // namespace trellis
