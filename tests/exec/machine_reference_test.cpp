// The interpreter of machines against Appendix D taken literally, on random statecharts: states
// entered and left, transitions taken, what content did, all in order, and the configurations.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/random_machine.h"
#include "support/reference_machine.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

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
        const bool is_state = what.row && what.row.index != 0;
        const std::string name = is_state ? std::string(program_.name(what.row)) : "";
        if (what.kind == enter) { text += "enter " + name + '\n'; }
        if (what.kind == leave) { text += "leave " + name + '\n'; }
        if (what.kind == transition) { text += "take " + name + '\n'; }
        if (what.kind == log) { text += "log " + std::string(what.text) + '\n'; }
    }

    std::string text;

private:
    const Program& program_;
};

std::string configuration(const ScriptRun& run) {
    std::string out;
    for (std::uint32_t n = 1; n < run.program().rows.size(); ++n) {
        if (run.state.status[n] != Status::running) { continue; }
        out += (out.empty() ? "" : " ") + run.program().names[n];
    }
    return out;
}

struct Comparison {
    std::size_t machines = 0, events = 0, endless = 0, ended = 0, differ = 0;

    void add(const std::string& text, Random& random) {
        Diagnostics diagnostics;
        const std::optional<Document> document = read({.name = "test", .text = text}, diagnostics);
        REQUIRE(document.has_value());
        const Program program = loaded(text);
        ScriptRun run(program);
        ReferenceMachine reference(*document);
        Lines lines(program);
        const StepOptions options{.dt = 1.0, .trace = &lines, .budget = 5000};
        std::string sent;
        reference.start();
        if (reference.is_endless()) {
            ++endless;
            return;
        }
        ++machines;
        run.start(options);
        if (!run.state.fault) { run.step(options); }
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
            if (reference.is_endless()) {
                ++endless;
                return;
            }
            ++events;
            send(program, run.state, event);
            run.step(options);  // a fault is seen by the next comparison
        }
    }

    bool compare(const std::string& text, const std::string& sent, const std::string& here,
                 const ReferenceMachine& reference, const ScriptRun& run) {
        const bool equal = here == reference.trace && !run.state.fault &&
                           configuration(run) == reference.configuration();
        if (equal) { return true; }
        if (++differ <= 3) {
            CAPTURE(text);
            CAPTURE(sent);
            CHECK(describe_fault(run.program(), run.state) == "");
            CHECK(here == reference.trace);
            CHECK(configuration(run) == reference.configuration());
        }
        return false;
    }
};

}  // namespace

TEST_CASE("machine reference: random statecharts do the same, step by step") {
    Random random(std::int64_t{30});
    Comparison comparison;
    for (int i = 0; i < 20'000; ++i) {
        comparison.add(random_machine(random, static_cast<int>(random.whole(1, 14))), random);
    }
    MESSAGE(comparison.machines, " machines compared on ", comparison.events, " events, ",
            comparison.ended, " ended, ", comparison.endless, " are endless, ", comparison.differ,
            " differ");
    CHECK(comparison.differ == 0);
}

}  // namespace trellis::test
