// The interpreter of machines against Appendix D taken literally, on random statecharts: states
// entered and left, transitions taken, what content did, all in order, and the configurations.
// TRELLIS_MACHINES=100000 compares more than 2,000.
// SPDX-License-Identifier: MIT
#include "support/configuration.h"
#include "support/loading.h"
#include "support/random_machine.h"
#include "support/reference_machine.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace trellis::test {
namespace {

/// Writes what ReferenceMachine::trace says.
class Lines final : public TraceSink {
public:
    explicit Lines(const Program& program) : program_(program) {}

    void on(const TraceEvent& what) override {
        using enum TraceEvent::Kind;
        const Program& program = what.machine != nullptr ? *what.machine : program_;
        const bool is_state = what.row && what.row.index != 0;
        const std::string name = is_state ? std::string(program.name(what.row)) : "";
        const std::string session = 's' + std::to_string(what.session) + ' ';
        if (what.kind == enter) { text += session + "enter " + name + '\n'; }
        if (what.kind == leave) { text += session + "leave " + name + '\n'; }
        if (what.kind == transition) { text += session + "take " + name + '\n'; }
        if (what.kind == log) { text += session + "log " + std::string(what.text) + '\n'; }
    }

    std::string text;

private:
    const Program& program_;
};

struct Comparison {
    std::size_t machines = 0, cycles = 0, endless = 0, ended = 0, invoked = 0, differ = 0;

    void add(const std::string& text, Random& random) {
        Diagnostics diagnostics;
        const std::optional<Document> document = read({.name = "test", .text = text}, diagnostics);
        REQUIRE(document.has_value());
        const Program program = loaded(text);
        ScriptRun run(program);
        ReferenceMachine reference(*document);
        Lines lines(program);
        const StepOptions options{.dt = 1.0, .trace = &lines, .budget = 50'000};
        std::string sent;
        reference.start();
        if (reference.is_endless()) {
            ++endless;
            return;
        }
        ++machines;
        run.start(options);
        for (int i = 0; i < 12; ++i) {
            if (!compare(text, sent, lines.text, reference, run)) { return; }
            if (!reference.is_running()) {
                ++ended;
                return;
            }
            const std::string event = random_event(random);
            run.host.bumper = reference.bumper = random.whole(0, 1) == 1;
            sent += ' ' + event;
            reference.send(event);
            reference.cycle();
            if (reference.is_endless()) {
                ++endless;
                return;
            }
            ++cycles;
            send(program, run.state, event);
            run.step(options);  // a fault is seen by the next comparison
        }
        invoked += run.state.session.sessions - 1;
    }

    bool compare(const std::string& text, const std::string& sent, const std::string& here,
                 const ReferenceMachine& reference, const ScriptRun& run) {
        // where a machine ends while it starts, the reference leaves its states in the next cycle
        const bool equal = here == reference.trace && !run.state.fault &&
                           configuration(run.program(), run.state) == reference.configuration();
        if (equal) { return true; }
        if (++differ <= 3) {
            CAPTURE(text);
            CAPTURE(sent);
            CHECK(describe_fault(run.program(), run.state) == "");
            CHECK(here == reference.trace);
            CHECK(configuration(run.program(), run.state) == reference.configuration());
        }
        return false;
    }
};

}  // namespace

TEST_CASE("machine reference: random statecharts do the same, step by step") {
    const char* const given = std::getenv("TRELLIS_MACHINES");
    const int count = given != nullptr ? std::atoi(given) : 2000;
    Random random(std::int64_t{30});
    Comparison comparison;
    for (int i = 0; i < count; ++i) {
        const std::int64_t most = i % 10 == 0 ? 60 : 16;
        comparison.add(random_machine(random, static_cast<int>(random.whole(1, most))), random);
    }
    MESSAGE(comparison.machines, " machines compared in ", comparison.cycles, " cycles, ",
            comparison.ended, " ended, ", comparison.endless, " are endless, ", comparison.invoked,
            " machines were invoked, ", comparison.differ, " differ");
    CHECK(comparison.differ == 0);
}

}  // namespace trellis::test
