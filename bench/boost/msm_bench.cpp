// The same machines as in machine_bench.cpp, compiled by Boost.MSM: the compile-time engine that
// the runtime one is held beside. Built where Boost's headers are found.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <boost/msm/back/state_machine.hpp>
#include <boost/msm/front/functor_row.hpp>
#include <boost/msm/front/state_machine_def.hpp>

namespace {

namespace msm = boost::msm;
using msm::front::Row;
using none = msm::front::none;

struct Go {};
struct Back {};

struct PingPongDefinition : msm::front::state_machine_def<PingPongDefinition> {
    struct Ping : msm::front::state<> {};
    struct Pong : msm::front::state<> {};
    using initial_state = Ping;
    struct transition_table
        : boost::mpl::vector<Row<Ping, Go, Pong, none, none>, Row<Pong, Back, Ping, none, none>> {};
};

void two_states(benchmark::State& state) {
    msm::back::state_machine<PingPongDefinition> machine;
    machine.start();
    bool go = true;
    for (auto _ : state) {
        if (go) {
            machine.process_event(Go());
        } else {
            machine.process_event(Back());
        }
        go = !go;
        benchmark::DoNotOptimize(machine);
    }
}
BENCHMARK(two_states)->Name("machine/two states, Boost.MSM");

// The lab's machine: what its guards ask comes with the event.
struct Cycle {
    bool bumper;
    double elapsed;  // s
};

template <int seconds>
struct After {
    template <class Machine, class Source, class Target>
    bool operator()(const Cycle& cycle, Machine&, Source&, Target&) const {
        return cycle.elapsed > seconds;
    }
};

struct Bumped {
    template <class Machine, class Source, class Target>
    bool operator()(const Cycle& cycle, Machine&, Source&, Target&) const {
        return cycle.bumper;
    }
};

struct RoombaDefinition : msm::front::state_machine_def<RoombaDefinition> {
    struct MoveForward : msm::front::state<> {};
    struct MoveInSpiral : msm::front::state<> {};
    struct GoBack : msm::front::state<> {};
    struct Rotate : msm::front::state<> {};
    using initial_state = MoveForward;
    // of several rows with one source, the last is tried first
    struct transition_table
        : boost::mpl::vector<Row<MoveForward, Cycle, MoveInSpiral, none, After<3>>,
                             Row<MoveForward, Cycle, GoBack, none, Bumped>,
                             Row<MoveInSpiral, Cycle, MoveForward, none, After<20>>,
                             Row<MoveInSpiral, Cycle, GoBack, none, Bumped>,
                             Row<GoBack, Cycle, Rotate, none, After<1>>,
                             Row<Rotate, Cycle, MoveForward, none, After<2>>> {};
    template <class Machine, class Event>
    void no_transition(const Event&, Machine&, int) {}
};

void roomba_guards(benchmark::State& state) {
    msm::back::state_machine<RoombaDefinition> machine;
    machine.start();
    Cycle cycle{false, 0.0};
    for (auto _ : state) {
        benchmark::DoNotOptimize(cycle);
        machine.process_event(cycle);
        benchmark::DoNotOptimize(machine);
    }
}
BENCHMARK(roomba_guards)->Name("machine/roomba guards, none holds, Boost.MSM");

}  // namespace
