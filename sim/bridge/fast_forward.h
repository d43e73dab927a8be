// Letting ticks of a run pass at once: where the leaf that runs can say what it will command and
// for how long, and nothing is met meanwhile, the robot is put where that many ticks would bring
// it, to within 1e-9 m and rad. Only in the lab's room, whose walls have no corners inside;
// everything else is ticked. Ticking stays the judge: tests/sim/fast_forward_test.cpp compares
// leaves, bumps and poses with it.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/bridge/episode.h"

#include <cstdint>
#include <vector>

namespace trellis {

/// A way whose turning follows the time, as a spiral's: where the robot is after so many ticks, and
/// circles around parts of it.
struct TimedWay {
    struct Place {
        double x = 0.0, y = 0.0, rotation = 0.0;  // m, rad, from where it began
        double asked = 0.0;                       // rad/s, as the leaf has it
        double angular = 0.0;                     // rad/s, as the drive does it
    };
    struct Circle {
        double x = 0.0, y = 0.0, radius = 0.0;  // m
    };
    /// Ticks in the parts that have a circle.
    static constexpr std::uint32_t part = 16, large_part = 128;

    std::uint32_t key = 0;                          // the row of the leaf
    double first = 0.0, second = 0.0, third = 0.0;  // the numbers it follows from
    double linear = 0.0;                            // m/s
    std::vector<Place> places;
    std::vector<Circle> parts, large_parts;

    /// Adds the circles, when all places are there.
    void enclose();
};

/// For the runs of one program, one after the other. Not for several threads.
class FastForward {
public:
    explicit FastForward(const Program& program) : program_(&program) {}

    /// Lets ticks of the run pass, at most `most`. Their number: 0 if the next one has to be
    /// ticked. In those that pass, the run is at the same leaf and no wall is touched. `places`, if
    /// not null, gets where the robot is at the end of each.
    std::uint64_t leap(Episode& run, std::uint64_t most, std::vector<Point>* places = nullptr);

private:
    /// What the leaf that runs will do.
    struct Course {
        std::uint64_t ticks = 0;  // for which it goes on; 0: nobody knows
        double linear = 0.0, angular = 0.0;
        const TimedWay* way = nullptr;  // in the place of `angular`
        std::uint32_t begun = 0;        // ticks of the way that are behind
    };

    Course course_of(const Episode& run);
    Course machine_course(const Episode& run);
    Course tree_course(const Episode& run);
    const TimedWay* spiral(const Episode& run, std::uint32_t row, double speed, double radius,
                           double growth, double duration);
    const TimedWay* formula_way(const Episode& run, const Course& course);
    std::uint64_t drive(const Episode& run, const Course& course, std::uint64_t most, Roomba& robot,
                        std::vector<Point>* places) const;
    std::uint64_t drive_timed(const Episode& run, const Course& course, std::uint64_t most,
                              Roomba& robot, std::vector<Point>* places) const;
    void pass(Episode& run, const Course& course, std::uint64_t ticks) const;

    const Program* program_;
    std::vector<TimedWay> ways_;  // made when they are first needed
};

}  // namespace trellis
