// A behaviour that is stepped by hand, with or without a robot, and can go back: its State is a
// value, so going back is assigning. Knows no commands (try.cpp). Covered by
// tests/runner/try_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/state.h"
#include "runner/mocks.h"
#include "runner/row_statuses.h"
#include "sim/bridge/episode.h"

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

class Trial : TraceSink {
public:
    /// Steps that back() can undo.
    static constexpr std::size_t most_kept = 1000;

    /// `mocks` must outlive it. Without a world the robot stands still.
    Trial(Mocks& mocks, EpisodeSetup setup, bool world);

    /// Everything that changes.
    struct Moment {
        State state;
        Roomba robot;
        MockCalls calls;
        RowStatuses statuses;
        Status status = Status::idle;  ///< of the root in the last tick
    };

    /// One tick. False after a fault: it is where it was, and fault() says why.
    bool tick();
    /// Puts an event into the queue of a machine; it is taken in the next tick.
    void send(std::string_view event, Value data);
    /// Halts everything that runs.
    void halt();
    /// Undoes as many ticks, events, halts and assignments as are kept, at most `steps`; how many.
    std::size_t back(std::size_t steps);
    /// Begins again.
    void reset();
    /// Gives a variable a value, as text. What is wrong, in words; empty if nothing is.
    std::string assign(std::string_view name, std::string_view value);

    /// What a text means where no type is known: true, false, a number, else a text, which may
    /// stand in single quotes.
    static Value value_in(std::string_view text);

    const Moment& now() const { return now_; }
    const Program& program() const { return mocks_.program(); }
    /// A machine in its final state.
    bool is_over() const { return static_cast<bool>(now_.state.session.final); }
    const std::string& fault() const { return fault_; }
    /// What leaves returned, which transitions were taken, what was logged in the last step.
    const std::vector<std::string>& happened() const { return happened_; }
    /// The variables by name, in the order of the program.
    std::vector<std::pair<std::string, const Value*>> variables() const;

private:
    void on(const TraceEvent& event) override;
    void begin_step();
    template <class Act>
    void with_host(Act act);

    Mocks& mocks_;
    EpisodeSetup setup_;
    bool world_;
    Moment now_;
    std::deque<Moment> before_;
    std::vector<std::string> happened_;
    std::string fault_;
};

}  // namespace trellis
