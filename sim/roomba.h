// The Roomba as a behaviour sees it: the sensors it reads and the velocity it commands, in one
// small value. It does not know its room (sim/lab_world.h) or who drives it. Covered by
// tests/sim/roomba_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

namespace trellis {

/// One robot between two ticks. Copying it saves it, assigning it restores it.
struct Roomba {
    // sensors: the world writes them, leaves read them
    double x = 0.0;             ///< m, centre, to the right
    double y = 0.0;             ///< m, centre, downwards
    double rotation = 0.0;      ///< rad, clockwise as drawn, 0 looks to the right; never wrapped
    double v = 0.0;             ///< m/s, linear velocity of the last move, negative backwards
    double w = 0.0;             ///< rad/s, angular velocity of the last move, positive clockwise
    bool bumper = false;        ///< the last move ended against a wall; holds for this tick only
    bool bumper_left = false;   ///< … and the left half of the front touched it
    bool bumper_right = false;  ///< … and the right half did; both when it is straight ahead

    // sensed only in worlds of walls (sim/surroundings.h); in the lab's room they stay as they are
    static constexpr double farthest_wall = 0.25;  ///< m, that the sensor on the right side sees
    double wall_distance = farthest_wall;  ///< m, from the right side to a wall; at most that
    double dirt = 0.0;                     ///< under the robot: 0 none, 1 untouched
    double battery = 1.0;                  ///< of a full one, 0 to 1
    bool docked = false;                   ///< at the dock, charging
    bool dock_visible = false;             ///< near enough and no wall between
    double dock_bearing = 0.0;             ///< rad, from the heading, -pi to pi; 0 if not visible

    // commands: leaves write them through set_velocity, the next move obeys and keeps them
    double linear = 0.0;   ///< m/s
    double angular = 0.0;  ///< rad/s

    // what the drive can do
    double max_linear = 1.0;   ///< m/s, at least 0
    double max_angular = 2.0;  ///< rad/s, at least 0

    /// Something touched the robot at `angle` from its heading, from -pi to pi.
    constexpr void press_bumper(double angle) {
        constexpr double quarter = 1.5707963267948966;  // rad: the front half
        constexpr double both = 0.17453292519943295;    // rad: so near to straight ahead
        const bool front = angle >= -quarter && angle <= quarter;
        bumper = true;
        bumper_left = front && angle <= both;
        bumper_right = front && angle >= -both;
    }
    constexpr void release_bumper() { bumper = bumper_left = bumper_right = false; }

    /// Commands `forward` m/s and `turn` rad/s, each cut to ± its limit; holds until the next
    /// command. A NaN is not cut.
    constexpr void set_velocity(double forward, double turn) {
        linear = cut(forward, max_linear);
        angular = cut(turn, max_angular);
    }

    friend bool operator==(const Roomba&, const Roomba&) = default;

private:
    static constexpr double cut(double value, double limit) {
        return value > limit ? limit : value < -limit ? -limit : value;
    }
};

}  // namespace trellis
