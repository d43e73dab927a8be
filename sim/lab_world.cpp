// The lab's collision and motion. The order of every operation is part of the result: see the
// recorded runs in tests/sim/lab_streams_test.cpp before touching an expression.
// SPDX-License-Identifier: MIT
#include "sim/lab_world.h"

#include <cmath>
#include <numbers>

namespace trellis {

namespace {

/// Where the walls are, from the heading: -pi to pi. Between two walls it is the middle.
double angle_of(const Contacts& touched, double rotation) {
    const double x = (touched.right ? 1.0 : 0.0) - (touched.left ? 1.0 : 0.0);
    const double y = (touched.bottom ? 1.0 : 0.0) - (touched.top ? 1.0 : 0.0);
    return std::remainder(std::atan2(y, x) - rotation, 2.0 * std::numbers::pi);
}

}  // namespace

Roomba at_start(const LabWorld& world) {
    return {.x = world.start.x, .y = world.start.y, .rotation = world.start.rotation};
}

void sense(const LabWorld& world, Roomba& robot) {
    const Contacts touched = contacts(world, robot.x, robot.y);
    if (touched.left) robot.x = world.radius;
    if (touched.right) robot.x = world.width - world.radius;
    if (touched.top) robot.y = world.radius;
    if (touched.bottom) robot.y = world.height - world.radius;
    robot.release_bumper();
    if (touched.any()) robot.press_bumper(angle_of(touched, robot.rotation));
}

void move(Roomba& robot, double dt) {
    const double v = robot.linear;
    const double w = robot.angular;

    // turning on the spot would add ±0.0 to a position: a fifth of a run needs no cosine. Keeping
    // the cosine of an unchanged heading as well would save 10 % more, at the price of a second
    // value beside the robot.
    if (v != 0.0) {
        const double middle = robot.rotation + (w * dt) / 2.0;  // heading half-way through the move
        if (std::fabs(w) < 1e-3) {
            robot.x += (v * dt) * std::cos(middle);
            robot.y += (v * dt) * std::sin(middle);
        } else {
            const double half_turn = std::sin((w * dt) / 2.0);
            robot.x += (((2.0 * v) / w) * std::cos(middle)) * half_turn;
            robot.y += (((2.0 * v) / w) * std::sin(middle)) * half_turn;
        }
    }
    robot.rotation += w * dt;
    robot.v = v;
    robot.w = w;
}

}  // namespace trellis
