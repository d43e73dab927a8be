// Leaves that have ports and do nothing. Covered by the tests that register them; no test looks at
// what they do.
// SPDX-License-Identifier: MIT
#include "support/example_registry.h"

#include <cstdint>
#include <string_view>

namespace trellis::test {

namespace {

struct NoHost {};

struct Drive {
    double speed = 0.5;     // m/s
    double duration = 3.0;  // s
    Status tick(const Tick&) { return Status::success; }
};

struct Spiral {
    double speed = 0.5;      // m/s
    double duration = 20.0;  // s
    Status tick(const Tick&) { return Status::success; }
};

struct Turn {
    double speed = 0.5;  // rad/s
    Status tick(const Tick&) { return Status::success; }
};

struct SetVelocity {
    double linear = 0.0;   // m/s
    double angular = 0.0;  // rad/s
    bool hold = true;
    Status tick(const Tick&) { return Status::running; }
};

struct Wait {
    double duration = 1.0;  // s
    Status tick(const Tick&) { return Status::success; }
};

struct Bumped {
    bool tick(const Tick&) { return false; }
};

struct Say {
    std::string_view message;
    std::int32_t times = 1;
    Status tick(const Tick&) { return Status::success; }
};

struct Measure {
    std::int64_t sensor = 0;
    Out<double> distance;  // m
    Status tick(const Tick&) { return Status::success; }
};

struct Count {
    const Value* what = nullptr;
    Out<std::int32_t> total;
    Status tick(const Tick&) { return Status::success; }
};

}  // namespace

void register_examples(Registry& registry) {
    registry.add<Drive, NoHost>("MoveForward", "drive straight until a time has passed")
        .input("speed", &Drive::speed, "m/s", "forwards")
        .input("duration", &Drive::duration, "s");
    registry.add<Spiral, NoHost>("MoveInSpiral", "drive a spiral that opens")
        .input("speed", &Spiral::speed, "m/s")
        .input("duration", &Spiral::duration, "s");
    registry.add<Drive, NoHost>("GoBack", "drive backwards until a time has passed")
        .input("speed", &Drive::speed, "m/s")
        .input("duration", &Drive::duration, "s");
    registry.add<Turn, NoHost>("Rotate", "turn by a random angle")
        .input("speed", &Turn::speed, "rad/s");
    registry.add<SetVelocity, NoHost>("SetVelocity", "command a velocity")
        .input("linear", &SetVelocity::linear, "m/s")
        .input("angular", &SetVelocity::angular, "rad/s")
        .input("hold", &SetVelocity::hold, "", "whether it stays running");
    registry.add<Wait, NoHost>("Wait", "do nothing until a time has passed")
        .input("duration", &Wait::duration, "s");
    registry.add<Bumped, NoHost>("Bumped", "whether the bumper is pressed");
    registry.add<Say, NoHost>("Say", "say something")
        .input("message", &Say::message, "", "what is said")
        .required()
        .input("times", &Say::times);
    registry.add<Measure, NoHost>("Measure", "measure a distance")
        .input("sensor", &Measure::sensor)
        .output("distance", &Measure::distance, "m");
    registry.add<Count, NoHost>("Count", "count what is seen")
        .input("what", &Count::what)
        .inout("total", &Count::total);
    registry.enumerator("FRONT", 0);
    registry.enumerator("BACK", 1);
}

}  // namespace trellis::test
