// A program that uses an installed Trellis through its public headers only: a leaf of its own, a
// behaviour in a text, a run. Exit 0 means that it ran as it should. Built and run by
// tests/consumer.
// SPDX-License-Identifier: MIT
#include <trellis/exec/step.h>
#include <trellis/load/load.h>

#include <cstdio>

struct Lamp {
    bool on = false;
};

/// Switches the lamp on for some ticks.
struct Shine {
    int ticks = 3;  // input
    int done = 0;   // state
    trellis::Status tick(Lamp& lamp, const trellis::Tick&) {
        lamp.on = ++done < ticks;
        return lamp.on ? trellis::Status::running : trellis::Status::success;
    }
};

int main() {
    trellis::Registry registry;
    registry.add<Shine, Lamp>("Shine", "switch the lamp on for some ticks")
        .input("ticks", &Shine::ticks)
        .state(&Shine::done);

    trellis::Diagnostics diagnostics;
    const auto program =
        trellis::load({"shine.xml", "<root BTCPP_format='4'><BehaviorTree ID='Main'>"
                                    "<Inverter><Shine ticks='2'/></Inverter>"
                                    "</BehaviorTree></root>"},
                      registry, diagnostics);
    std::fputs(diagnostics.render().c_str(), stderr);
    if (!program) { return 1; }

    Lamp lamp;
    trellis::State state = trellis::fresh_state(*program);
    const bool shines = trellis::step(*program, state, lamp) == trellis::Status::running && lamp.on;
    const bool ends = trellis::step(*program, state, lamp) == trellis::Status::failure && !lamp.on;
    return shines && ends ? 0 : 1;
}
