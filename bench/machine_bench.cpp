// Machines that are told events, per event, beside the same machine as a switch: two states, a ring
// of 512, ten levels deep, eight regions. Results per machine are in bench/README.md.
// SPDX-License-Identifier: MIT
#include "exec/step.h"
#include "support.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <string>

namespace trellis {
namespace {

std::string machine(const std::string& states) {
    return "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" version=\"1.0\" "
           "datamodel=\"script\">" +
           states + "</scxml>";
}

std::string state(const std::string& id, const std::string& content) {
    return "<state id=\"" + id + "\">" + content + "</state>";
}

std::string on(const std::string& event, const std::string& target) {
    return "<transition event=\"" + event + "\" target=\"" + target + "\"/>";
}

/// Sends `events` in turn, an event a step.
template <std::size_t count>
void send_in_turn(benchmark::State& bench, const std::string& states,
                  const std::array<const char*, count>& events) {
    const Program program = bench::loaded("bench.scxml", machine(states));
    State running = fresh_state(program);
    bench::Host host;
    start(program, running, host);
    std::array<EventId, count> ids;
    for (std::size_t i = 0; i < count; ++i) {
        ids[i] = find_event(program, events[i]);
    }
    std::size_t next = 0;
    for (auto _ : bench) {
        send(program, running, ids[next]);
        next = next + 1 == count ? 0 : next + 1;
        benchmark::DoNotOptimize(step(program, running, host));
    }
}

void two_states(benchmark::State& bench) {
    send_in_turn<2>(bench, state("ping", on("go", "pong")) + state("pong", on("back", "ping")),
                    {"go", "back"});
}
BENCHMARK(two_states)->Name("machine/two states");

void two_states_by_hand(benchmark::State& bench) {
    enum class At : std::uint8_t { ping, pong } at = At::ping;
    enum class Event : std::uint8_t { go, back } event = Event::go;
    for (auto _ : bench) {
        benchmark::DoNotOptimize(event);
        switch (at) {
        case At::ping:
            if (event == Event::go) { at = At::pong; }
            break;
        case At::pong:
            if (event == Event::back) { at = At::ping; }
            break;
        }
        event = event == Event::go ? Event::back : Event::go;
        benchmark::DoNotOptimize(at);
    }
}
BENCHMARK(two_states_by_hand)->Name("machine/two states, hand-written switch");

void ring(benchmark::State& bench) {
    const std::int64_t size = bench.range(0);
    std::string states;
    for (std::int64_t i = 0; i < size; ++i) {
        states += state("s" + std::to_string(i), on("next", "s" + std::to_string((i + 1) % size)));
    }
    send_in_turn<1>(bench, states, {"next"});
}
BENCHMARK(ring)->Name("machine/ring")->Arg(512);

// a and b lie below ten nested states each: a step leaves and enters ten
void deep(benchmark::State& bench) {
    const auto branch = [](const std::string& name, const std::string& content) {
        std::string inner = content;
        for (int level = 10; level-- > 0;) {
            inner = state(name + std::to_string(level), inner);
        }
        return inner;
    };
    send_in_turn<1>(bench, branch("a", on("next", "b9")) + branch("b", on("next", "a9")), {"next"});
}
BENCHMARK(deep)->Name("machine/ten levels");

// each event changes the state in every region
void parallel(benchmark::State& bench) {
    std::string regions;
    for (std::int64_t i = 0; i < bench.range(0); ++i) {
        const std::string n = std::to_string(i);
        regions += state("r" + n,
                         state("a" + n, on("next", "b" + n)) + state("b" + n, on("next", "a" + n)));
    }
    send_in_turn<1>(bench, "<parallel id=\"p\">" + regions + "</parallel>", {"next"});
}
BENCHMARK(parallel)->Name("machine/parallel")->Arg(8);

}  // namespace
}  // namespace trellis
