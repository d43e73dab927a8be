// The lab's machine as a programmer would write it by hand: one switch, no allocation. It is the
// judge of the recorded runs and the yardstick of the benchmark, and knows nothing of the runtime.
// Covered by tests/sim/lab_streams_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/lab_world.h"
#include "sim/roomba.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace trellis::test {

/// The four things the lab's robot does.
enum class LabLeaf : std::uint8_t { move_forward, move_in_spiral, go_back, rotate };

/// A list of angles in rad, drawn one after the other; begins again when it is used up.
class Angles {
public:
    /// `list` is not empty and outlives this.
    explicit Angles(std::span<const double> list) : list_(list) {}

    double draw() {
        const double angle = list_[next_];
        next_ = next_ + 1 < list_.size() ? next_ + 1 : 0;
        return angle;
    }

private:
    std::span<const double> list_;
    std::size_t next_ = 0;
};

/// The lab's finite state machine. One `tick` between `sense` and `move` of each tick of the world.
class HandWrittenFsm {
public:
    explicit HandWrittenFsm(Angles angles) : angles_(angles) {}

    LabLeaf leaf() const { return leaf_; }

    /// At most one transition, then the activity of the state that is active then. The bumper is
    /// tested before the time, the time before this tick is counted.
    void tick(Roomba& robot) {
        const double time = ticks_ * lab_dt;
        switch (leaf_) {
        case LabLeaf::move_forward:
            if (robot.bumper)
                enter(LabLeaf::go_back);
            else if (time > 3.0)
                enter(LabLeaf::move_in_spiral);
            break;
        case LabLeaf::move_in_spiral:
            if (robot.bumper)
                enter(LabLeaf::go_back);
            else if (time > 20.0)
                enter(LabLeaf::move_forward);
            break;
        case LabLeaf::go_back:
            if (time > 0.5) {
                enter(LabLeaf::rotate);
                angle_ = angles_.draw();
            }
            break;
        case LabLeaf::rotate:
            if (time > std::fabs(angle_) / 0.5) enter(LabLeaf::move_forward);
            break;
        }
        ++ticks_;
        act(robot);
    }

private:
    void enter(LabLeaf next) {
        leaf_ = next;
        ticks_ = 0;
    }

    void act(Roomba& robot) const {
        switch (leaf_) {
        case LabLeaf::move_forward: robot.set_velocity(0.5, 0.0); break;
        case LabLeaf::move_in_spiral:
            robot.set_velocity(0.5, 0.5 / (0.2 + 0.05 * (ticks_ * lab_dt)));
            break;
        case LabLeaf::go_back: robot.set_velocity(-0.1, 0.0); break;
        case LabLeaf::rotate: robot.set_velocity(0.0, angle_ > 0.0 ? 0.5 : -0.5); break;
        }
    }

    Angles angles_;
    double angle_ = 0.0;  // rad, of this turn
    int ticks_ = 0;       // since the state was entered
    LabLeaf leaf_ = LabLeaf::move_forward;
};

}  // namespace trellis::test
