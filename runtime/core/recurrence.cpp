// Comparing states member by member, as same() does, with a rule for each that counts up.
// SPDX-License-Identifier: MIT
#include "core/recurrence.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace trellis {
namespace {

template <class Holds>
bool any_instruction(const Program& program, const Holds& holds) {
    return std::any_of(program.code.instructions.begin(), program.code.instructions.end(), holds) ||
           std::any_of(program.machines.begin(), program.machines.end(),
                       [&](const Program& machine) { return any_instruction(machine, holds); });
}

/// The word in which a row keeps the tick at which something is over; none if it has no such word.
WordId deadline_of(const Program& program, const Row& row) {
    if (row.op == Op::delay || row.op == Op::timeout || row.op == Op::sleep)
        return program.nodes[row.arg].word;
    if (row.op == Op::test) return program.tests[row.arg].word;
    return {};
}

class Comparison {
public:
    Comparison(const Program& outermost, const Program& program, const State& a, const State& b)
        : outermost_(outermost), p_(program), a_(a), b_(b), clock_is_read_(program.rows.size()) {
        for (const Instruction& i : program.code.instructions) {
            if (i.op == CodeOp::elapsed_count || i.op == CodeOp::elapsed_since)
                clock_is_read_[i.extra] = true;
        }
    }

    bool holds() const {
        return !a_.fault && !b_.fault && !p_.counts_writes && a_.started == b_.started &&
               a_.woken == b_.woken && a_.last_leaf == b_.last_leaf && a_.status == b_.status &&
               leaves() && memory() && words() && a_.slots == b_.slots &&
               a_.entries == b_.entries && a_.queues == b_.queues && session() && children() &&
               a_.random == b_.random;
    }

private:
    bool runs(std::size_t row) const { return a_.status[row] == Status::running; }

    bool leaves() const {
        for (const LeafCall& call : p_.calls) {
            for (const StateMember& member : call.type->state) {
                const std::size_t at = call.offset + member.offset;
                if (std::memcmp(&a_.leaves[at], &b_.leaves[at], member.size) != 0) return false;
            }
        }
        return true;
    }

    bool memory() const {
        for (std::size_t i = 0; i < p_.rows.size(); ++i) {
            if (!same_memory(i)) return false;
        }
        return true;
    }

    /// What State::memory holds is told in exec/stepper.h.
    bool same_memory(std::size_t row) const {
        const Op op = p_.rows[row].op;
        const OpGroup group = op_table()[op].group;
        // its activations, to which only events that wait refer
        if (op == Op::invoke) return true;
        // ticks since it was entered
        if (group == OpGroup::scope)
            return !clock_is_read_[row] || a_.memory[row] == b_.memory[row];
        // the cycle in which it was entered, which counts while it is active
        if (group == OpGroup::state)
            return !clock_is_read_[row] || !runs(row) ||
                   a_.session.clock - a_.memory[row] == b_.session.clock - b_.memory[row];
        return a_.memory[row] == b_.memory[row];
    }

    bool words() const {
        std::vector<bool> is_deadline(p_.words);
        for (std::size_t i = 0; i < p_.rows.size(); ++i) {
            const WordId word = deadline_of(p_, p_.rows[i]);
            if (!word) continue;
            is_deadline[word.index] = true;
            // what does not run sets it when it begins
            if (runs(i) && a_.words[word.index] - a_.tick != b_.words[word.index] - b_.tick)
                return false;
        }
        for (std::size_t i = 0; i < is_deadline.size(); ++i) {
            if (!is_deadline[i] && a_.words[i] != b_.words[i]) return false;
        }
        return true;
    }

    // ids given to sessions and messages count up, and mean nothing to the behaviour itself
    bool session() const {
        const Session& s = a_.session;
        const Session& t = b_.session;
        const auto no_event = [](const Session& of) {
            return of.internal_next == of.internal.size() &&
                   of.external_next == of.external.size() && of.delayed.empty();
        };
        return no_event(s) && no_event(t) && s.active == t.active && s.pending == t.pending &&
               s.invokes == t.invokes && s.histories == t.histories && s.final == t.final;
    }

    bool children() const {
        return std::equal(
            a_.children.begin(), a_.children.end(), b_.children.begin(), b_.children.end(),
            [&](const Child& c, const Child& d) {
                return c.invoke == d.invoke && c.machine == d.machine &&
                       Comparison(outermost_, program_of(outermost_, c), c.state, d.state).holds();
            });
    }

    const Program& outermost_;
    const Program& p_;
    const State& a_;
    const State& b_;
    std::vector<bool> clock_is_read_;  // by row: an expression asks for its elapsed()
};

}  // namespace

bool recurs(const Program& program, const State& a, const State& b) {
    return Comparison(program, program, a, b).holds();
}

bool reads_sensor_but(const Program& program, std::span<const std::uint32_t> known) {
    return any_instruction(program, [&](const Instruction& i) {
        const bool is_sensor = i.op == CodeOp::sensor_boolean || i.op == CodeOp::sensor_integer ||
                               i.op == CodeOp::sensor_real;
        return is_sensor && std::find(known.begin(), known.end(), i.extra) == known.end();
    });
}

}  // namespace trellis
