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

    // commands: leaves write them through set_velocity, the next move obeys and keeps them
    double linear = 0.0;   ///< m/s
    double angular = 0.0;  ///< rad/s

    // what the drive can do
    double max_linear = 1.0;   ///< m/s, at least 0
    double max_angular = 2.0;  ///< rad/s, at least 0

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
