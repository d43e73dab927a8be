// The pictures that README.md shows are what the program draws now: docs/images is made by the
// commands below, and made anew by script/update-goldens. How pictures look is tested in
// tests/drawing and tests/sim.
// SPDX-License-Identifier: MIT
#include "support/goldens.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace {

using namespace trellis::test;

/// What the program prints when it is run in the repository; a failure fails the test case.
std::string printed_by(const std::string& arguments) {
    const std::string command = "cd '" TRELLIS_SOURCE_DIR "' && '" TRELLIS_PROGRAM "' " + arguments;
    FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string output;
    char buffer[4096];
    while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe))
        output.append(buffer, n);
    REQUIRE_MESSAGE(pclose(pipe) == 0, command);
    return output;
}

}  // namespace

TEST_CASE("images: the pictures in docs/images are what the program draws") {
    struct Image {
        const char* name;
        const char* arguments;
    };
    constexpr Image images[] = {
        {"roomba-trail.svg", "run trees/roomba.xml --time 120 --svg -"},
        {"roomba-tree.svg", "show trees/roomba.xml --svg -"},
        {"roomba-machine.svg", "show machines/roomba.scxml --svg -"},
    };
    for (const Image& image : images) {
        const std::string drawn = printed_by(image.arguments);
        const auto path = std::filesystem::path("../../docs/images") / image.name;
        if (const auto shown = golden(path, drawn))
            CHECK_MESSAGE(*shown == drawn, "docs/images/", image.name,
                          " is out of date: script/update-goldens");
    }
}
