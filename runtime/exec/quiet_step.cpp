// How a quiet step ends when it turns out to be more, and how many of them lie ahead.
// SPDX-License-Identifier: MIT
#include "exec/stepper.h"

#include <algorithm>
#include <limits>

namespace trellis {

// The leaf at which a tree resumes, or the only activity of a machine, was ticked.
Status Stepper::finish_quiet_step(Status status) {
    in_step_ = true;
    const RowId root{0};
    const RowId leaf = s_.last_leaf;
    if (status == Status::idle) { return finish_step(returned_idle(leaf, p_.call(leaf))); }
    if (status == Status::running) { return finish_step(status); }
    keep(leaf, status);
    if (rows_[0].op != Op::machine) {
        return finish_step(rest_of_tree(root, end_resumed(root, status)));
    }
    end_invokes();
    return finish_step(s_.fault ? Status::idle : Status::running);
}

namespace {

// The least n for which n * dt > limit, at most 2^32; dt is not negative.
std::uint64_t cycles_until(double limit, double dt) {
    constexpr std::uint64_t most = std::uint64_t{1} << 32;
    const double quotient = limit / dt;
    if (limit < 0.0) { return 0; }
    if (!(quotient < static_cast<double>(most))) { return most; }
    // rounding has moved the quotient by a few cycles at most
    auto n = static_cast<std::uint64_t>(quotient);
    while (n != 0 && static_cast<double>(n - 1) * dt > limit) {
        --n;
    }
    while (n != most && !(static_cast<double>(n) * dt > limit)) {
        ++n;
    }
    return n;
}

}  // namespace

// After a step of a machine that goes on. Guards that ask for the time are asked for all cycles to
// come at once: nothing they depend on changes before one of them holds.
void Stepper::find_quiet_cycles() {
    const Session& session = s_.session;
    const QuietId id = p_.state(session.atom).quiet;
    if (!id || !(tick_.dt >= 0.0) || !session.internal.empty() || !session.pending.empty() ||
        !s_.children.empty()) {
        return;
    }
    const QuietState& quiet = p_.quiet_states[id.index];
    if (status_[quiet.activity.index] != Status::running) { return; }
    std::uint64_t cycles = std::numeric_limits<std::uint32_t>::max();
    if (!session.delayed.empty()) {
        // the cycle that delivers a message is none of them; this one is s_.tick
        const std::uint64_t due = session.delayed.front().due;
        cycles = std::min(cycles, due > s_.tick ? due - s_.tick - 1 : 0);
    }
    for (std::uint32_t i = quiet.first_time; i != quiet.time_end; ++i) {
        const Condition& guard = p_.quiet_times[i];
        double limit = guard.limit;
        if (guard.form == Condition::Form::elapsed_variable) {
            Value value;
            if (!evaluate(p_.code, guard.variables, context(), value) || !value.is_number()) {
                return;
            }
            limit = value.number();
        }
        const std::uint64_t first = cycles_until(limit, tick_.dt);
        const std::uint32_t now = session.clock - memory_[guard.at];
        cycles = std::min(cycles, first > now ? first - now : 0);
    }
    s_.quiet = {id, static_cast<std::uint32_t>(cycles), tick_.dt};
}

}  // namespace trellis
