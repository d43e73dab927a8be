// Rules and registration of the Roomba's leaves. Times are whole ticks times dt, never accumulated.
// SPDX-License-Identifier: MIT
#include "sim/bridge/leaves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

namespace trellis {

namespace {

double seconds(int ticks, const Tick& t) {
    return static_cast<double>(ticks) * t.dt;
}

Status until(bool done) {
    return done ? Status::success : Status::running;
}

/// An angle the shorter way round, from -pi to pi.
double wrapped(double angle) {
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// Looks away from the wall for so long after a bump, s.
constexpr double turning_away = 0.3;

/// A heading that is off by more than this is corrected on the spot, rad.
constexpr double off_course = 0.3;

/// How much faster it turns the more it is off, 1/s.
constexpr double steering = 4.0;

/// Drives towards a place that is seen at `bearing`.
void steer(Roomba& robot, double bearing, double speed) {
    robot.set_velocity(std::fabs(bearing) > off_course ? 0.0 : speed, steering * bearing);
}

}  // namespace

Status MoveForward::tick(Roomba& robot, const Tick& t) {
    robot.set_velocity(speed, 0.0);
    if (seconds(++ticks, t) > duration) { return Status::success; }
    return robot.bumper ? Status::failure : Status::running;
}

Status MoveInSpiral::tick(Roomba& robot, const Tick& t) {
    const double time = seconds(++ticks, t);
    robot.set_velocity(speed, speed / (radius + growth * time));
    if (time > duration) { return Status::success; }
    return robot.bumper ? Status::failure : Status::running;
}

Status GoBack::tick(Roomba& robot, const Tick& t) {
    robot.set_velocity(-speed, 0.0);
    return until(seconds(++ticks, t) > duration);
}

Status Rotate::tick(Roomba& robot, const Tick& t) {
    if (ticks == 0) { angle = t.random->uniform(least, most); }
    robot.set_velocity(0.0, angle > 0.0 ? rate : -rate);
    return until(seconds(++ticks, t) > std::fabs(angle) / rate);
}

Status SetVelocity::tick(Roomba& robot, const Tick&) const {
    robot.set_velocity(linear, angular);
    return hold ? Status::running : Status::success;
}

Status Wait::tick(const Tick& t) {
    return until(seconds(++ticks, t) > duration);
}

bool Bumped::tick(Roomba& robot, const Tick&) const {
    return robot.bumper;
}

Status FollowWall::tick(Roomba& robot, const Tick& t) {
    if (robot.bumper) { away = static_cast<int>(turning_away / t.dt); }
    if (away > 0) {
        --away;
        robot.set_velocity(0.0, -1.0);
    } else {
        robot.set_velocity(speed, std::clamp(gain * (robot.wall_distance - distance), -1.5, 1.5));
    }
    return until(seconds(++ticks, t) > duration);
}

Status TurnTo::tick(Roomba& robot, const Tick& t) const {
    const double left = wrapped(heading - robot.rotation);
    // the last tick turns by what is left
    const double needed = left / t.dt;
    robot.set_velocity(0.0, std::clamp(needed, -rate, rate));
    if (std::fabs(left) > 1e-9) { return Status::running; }
    robot.set_velocity(0.0, 0.0);
    return Status::success;
}

Status DriveTo::tick(Roomba& robot, const Tick&) const {
    if (std::hypot(x - robot.x, y - robot.y) <= tolerance) {
        robot.set_velocity(0.0, 0.0);
        return Status::success;
    }
    if (robot.bumper) { return Status::failure; }
    steer(robot, wrapped(std::atan2(y - robot.y, x - robot.x) - robot.rotation), speed);
    return Status::running;
}

Status DriveToDock::tick(Roomba& robot, const Tick&) const {
    if (robot.docked) {
        robot.set_velocity(0.0, 0.0);
        return Status::success;
    }
    if (!robot.dock_visible) { return Status::failure; }
    steer(robot, robot.dock_bearing, speed);
    return Status::running;
}

Status Spot::tick(Roomba& robot, const Tick& t) {
    const double time = seconds(++ticks, t);
    robot.set_velocity(speed, speed / (radius + growth * time));
    clean_ticks = robot.dirt > 0.0 ? 0 : clean_ticks + 1;
    if (seconds(clean_ticks, t) > clear) { return Status::success; }
    return robot.bumper ? Status::failure : Status::running;
}

bool BatteryLow::tick(Roomba& robot, const Tick&) const {
    return robot.battery < level;
}

bool DirtFound::tick(Roomba& robot, const Tick&) const {
    return robot.dirt > 0.0;
}

bool Docked::tick(Roomba& robot, const Tick&) const {
    return robot.docked;
}

bool feels_only_bumper(const LeafType& leaf) {
    constexpr std::string_view names[] = {"MoveForward", "MoveInSpiral", "GoBack", "Rotate",
                                          "SetVelocity", "Wait",         "Bumped"};
    return std::find(std::begin(names), std::end(names), leaf.name) != std::end(names);
}

std::array<std::uint32_t, 3> bumper_sensors() {
    return {offsetof(Roomba, bumper), offsetof(Roomba, bumper_left),
            offsetof(Roomba, bumper_right)};
}

namespace {

void register_household(Registry& registry) {
    registry
        .add<FollowWall, Roomba>("FollowWall",
                                 "follow the wall on the right until a time has passed")
        .input("speed", &FollowWall::speed, "m/s", "forwards")
        .input("distance", &FollowWall::distance, "m", "from the robot's side to the wall")
        .input("gain", &FollowWall::gain, "", "rad/s of turning per m of error")
        .input("duration", &FollowWall::duration, "s", "succeeds once more than this has passed")
        .state(&FollowWall::ticks)
        .state(&FollowWall::away);
    registry.add<TurnTo, Roomba>("TurnTo", "turn on the spot to a heading")
        .input("heading", &TurnTo::heading, "rad", "clockwise as drawn, 0 looks to the right")
        .input("rate", &TurnTo::rate, "rad/s", "how fast to turn; above 0");
    registry.add<DriveTo, Roomba>("DriveTo", "drive straight to a place; fail on a bump")
        .input("x", &DriveTo::x, "m", "to the right")
        .input("y", &DriveTo::y, "m", "downwards")
        .input("speed", &DriveTo::speed, "m/s", "forwards")
        .input("tolerance", &DriveTo::tolerance, "m", "succeeds within this distance");
    registry
        .add<DriveToDock, Roomba>("Dock", "drive to the dock while it is seen; fail if it is not")
        .input("speed", &DriveToDock::speed, "m/s", "forwards");
    registry.add<Spot, Roomba>("Spot", "clean a spot in a small spiral until no dirt is found")
        .input("speed", &Spot::speed, "m/s", "forwards")
        .input("radius", &Spot::radius, "m", "of the spiral at the start")
        .input("growth", &Spot::growth, "m/s", "of the radius")
        .input("clear", &Spot::clear, "s", "succeeds when no dirt was found for this time")
        .state(&Spot::ticks)
        .state(&Spot::clean_ticks);
    registry.add<BatteryLow, Roomba>("BatteryLow", "whether the battery holds less than a level")
        .input("level", &BatteryLow::level, "", "of a full battery, 0 to 1");
    registry.add<DirtFound, Roomba>("DirtFound", "whether there is dirt under the robot");
    registry.add<Docked, Roomba>("Docked", "whether the robot is at the dock");

    registry.sensor("bumper_left", &Roomba::bumper_left, "",
                    "the left half of the front met a wall");
    registry.sensor("bumper_right", &Roomba::bumper_right, "",
                    "the right half of the front met a wall");
    registry.sensor("wall_distance", &Roomba::wall_distance, "m",
                    "from the right side to a wall; at most 0.25");
    registry.sensor("dirt", &Roomba::dirt, "", "under the robot: 0 none, 1 untouched");
    registry.sensor("battery", &Roomba::battery, "", "of a full one, 0 to 1");
    registry.sensor("docked", &Roomba::docked, "", "the robot is at the dock");
    registry.sensor("dock_visible", &Roomba::dock_visible, "",
                    "the dock is near and no wall between");
    registry.sensor("dock_bearing", &Roomba::dock_bearing, "rad", "of the dock, from the heading");
}

}  // namespace

void register_roomba(Registry& registry) {
    registry
        .add<MoveForward, Roomba>("MoveForward",
                                  "drive straight until a time has passed; fail on a bump")
        .input("speed", &MoveForward::speed, "m/s", "forwards")
        .input("duration", &MoveForward::duration, "s", "succeeds once more than this has passed")
        .state(&MoveForward::ticks);
    registry
        .add<MoveInSpiral, Roomba>("MoveInSpiral",
                                   "drive a growing spiral until a time has passed; fail on a bump")
        .input("speed", &MoveInSpiral::speed, "m/s", "forwards")
        .input("radius", &MoveInSpiral::radius, "m", "of the spiral at the start")
        .input("growth", &MoveInSpiral::growth, "m/s", "of the radius")
        .input("duration", &MoveInSpiral::duration, "s", "succeeds once more than this has passed")
        .state(&MoveInSpiral::ticks);
    registry.add<GoBack, Roomba>("GoBack", "drive backwards until a time has passed")
        .input("speed", &GoBack::speed, "m/s", "backwards")
        .input("duration", &GoBack::duration, "s", "succeeds once more than this has passed")
        .state(&GoBack::ticks);
    registry.add<Rotate, Roomba>("Rotate", "turn on the spot by a random angle")
        .input("rate", &Rotate::rate, "rad/s", "how fast to turn; above 0")
        .input("least", &Rotate::least, "rad", "lower end of the angle")
        .input("most", &Rotate::most, "rad", "upper end of the angle")
        .state(&Rotate::angle)
        .state(&Rotate::ticks);
    registry.add<SetVelocity, Roomba>("SetVelocity", "command a velocity in every tick")
        .input("linear", &SetVelocity::linear, "m/s", "forwards")
        .input("angular", &SetVelocity::angular, "rad/s", "to positive rotation")
        .input("hold", &SetVelocity::hold, "", "run until halted; else succeed at once");
    registry.add<Wait, Roomba>("Wait", "let a time pass")
        .input("duration", &Wait::duration, "s", "succeeds once more than this has passed")
        .state(&Wait::ticks);
    registry.add<Bumped, Roomba>("Bumped", "whether the robot has met a wall in the last tick");

    registry.sensor("bumper", &Roomba::bumper, "", "the robot has met a wall in the last tick");
    registry.sensor("x", &Roomba::x, "m", "position, to the right");
    registry.sensor("y", &Roomba::y, "m", "position, downwards as drawn");
    registry.sensor("rotation", &Roomba::rotation, "rad", "heading, clockwise as drawn");
    registry.sensor("v", &Roomba::v, "m/s", "linear velocity of the last move");
    registry.sensor("w", &Roomba::w, "rad/s", "angular velocity of the last move");
    register_household(registry);
}

}  // namespace trellis
