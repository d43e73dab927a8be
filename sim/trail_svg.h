// The picture of a run, seen from above: room, trail, bumps, and the robot where it ended, as SVG.
// A function of its arguments, so equal runs give equal bytes. Runs nothing and writes no file.
// Covered by tests/sim/trail_svg_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/lab_world.h"
#include "sim/roomba.h"
#include "sim/trail.h"
#include "sim/walled_world.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace trellis {

enum class TrailLook : std::uint8_t {
    leaves,  ///< one colour per leaf, with a legend; thin lines; bumps and start marked
    lab,     ///< the lab's window: a red line of 4 pixels and the robot, no marks
};

/// What a picture says about its run. The texts may hold any characters and are shortened to fit.
struct TrailPicture {
    std::string_view title = {};               ///< the behaviour's name
    std::string_view run = {};                 ///< what made it this run: "seed 7"; may be empty
    double seconds = 0.0;                      ///< simulated time, s
    std::span<const std::string> leaves = {};  ///< names for TrailPoint::leaf; empty: one red trail
    TrailLook look = TrailLook::leaves;
    const WalledWorld* walled = nullptr;  ///< drawn in place of the lab's room
    const Floor* floor = nullptr;         ///< how often each cell was covered is drawn on it
    Pose start = LabWorld{}.start;        ///< where the run began
};

/// An SVG document of the trail and of the robot at its end, 100 pixels per metre, on a background
/// of its own. Positions are rounded to 0.1 pixel and lines thinned out to within 0.15 pixel. The
/// bumps counted and the leaves' shares of the time are those of the points given.
std::string trail_svg(const LabWorld& world, std::span<const TrailPoint> trail, const Roomba& end,
                      const TrailPicture& picture);

}  // namespace trellis
