// A machine of a few lines that is told events and tells what happened, in one line of a test.
// Covered by tests/exec/machine_test.cpp and tests/exec/invoke_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/loading.h"
#include "support/script_leaves.h"

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

namespace trellis::test {

/// The machine file with these states; `attributes` go into <scxml>.
inline std::string machine_file(std::string_view states, std::string_view attributes = {}) {
    return "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" version=\"1.0\" name=\"m\" "
           "datamodel=\"script\" " +
           std::string(attributes) + '>' + std::string(states) + "</scxml>";
}

/// Everything that happened, shortly: "+a -a (text) !" for entered, left, log, error.
class Story final : public TraceSink {
public:
    explicit Story(const Program& program) : program_(program) {}

    void on(const TraceEvent& what) override {
        using enum TraceEvent::Kind;
        const Program& program = what.machine != nullptr ? *what.machine : program_;
        const std::string name(what.row ? program.name(what.row) : "");
        if (what.kind == enter) { text += " +" + name; }
        if (what.kind == leave) { text += " -" + name; }
        if (what.kind == log) { text += " (" + std::string(what.text) + ')'; }
        if (what.kind == error) { text += " !"; }
    }
    std::string take() {
        std::string out = text.empty() ? text : text.substr(1);
        text.clear();
        return out;
    }

    std::string text;

private:
    const Program& program_;
};

/// A machine that is told events and tells its story.
struct Machine {
    Program program;
    ScriptRun run;
    Story story;

    explicit Machine(std::string_view states, std::string_view attributes = {},
                     const LoadOptions& options = {}, const Registry& registry = script_registry())
        : program(loaded(machine_file(states, attributes), options, registry)), run(program),
          story(program) {}

    std::string start() {
        run.start({.dt = 0.5, .trace = &story});
        return story.take();
    }
    /// Sends the events, steps once, and tells what happened.
    std::string step(std::initializer_list<const char*> events = {}) {
        for (const char* event : events) {
            send(program, run.state, event);
        }
        last = run.step({.dt = 0.5, .trace = &story});
        return story.take();
    }
    Value variable(std::string_view name) const {
        for (std::size_t i = 0; i < program.slots.size(); ++i) {
            if (program.slots[i].name == name) { return run.state.slots[i]; }
        }
        return {};
    }
    std::string active() const {
        return run.state.session.atom ? std::string(program.name(run.state.session.atom)) : "";
    }

    Status last = Status::idle;
};

}  // namespace trellis::test
