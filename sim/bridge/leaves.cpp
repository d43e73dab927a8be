// Rules and registration of the Roomba's leaves. Times are whole ticks times dt, never accumulated.
// SPDX-License-Identifier: MIT
#include "sim/bridge/leaves.h"

#include <cmath>

namespace trellis {

namespace {

double seconds(int ticks, const Tick& t) {
    return static_cast<double>(ticks) * t.dt;
}

Status until(bool done) {
    return done ? Status::success : Status::running;
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
}

}  // namespace trellis
