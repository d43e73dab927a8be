// Sentences.
// SPDX-License-Identifier: MIT
#include "runner/explanation.h"

#include "core/number.h"
#include "runner/places.h"

#include <optional>
#include <string_view>

namespace trellis {

namespace {

/// How far a run is followed to see what it does next, s.
constexpr double look_ahead = 60.0;

std::string ordinal(std::uint64_t n) {
    const std::uint64_t last = n % 10;
    const bool teen = n / 10 % 10 == 1;
    const char* suffix = teen        ? "th"
                         : last == 1 ? "st"
                         : last == 2 ? "nd"
                         : last == 3 ? "rd"
                                     : "th";
    return std::to_string(n) + suffix;
}

std::string ticks(std::uint64_t n) {
    return std::to_string(n) + (n == 1 ? " tick" : " ticks");
}

/// "3.0 s".
std::string seconds(const Contestant& contestant, std::uint64_t n) {
    return print_number(static_cast<double>(n) * contestant.episode().setup().dt) + " s";
}

std::string name(const Contestant& contestant, RowId row) {
    return row ? std::string(contestant.entrant().program.name(row)) : "nothing";
}

std::string targets(const Entrant& entrant, TransitionId id) {
    const Transition& transition = entrant.program.transitions[id.index];
    std::string out;
    for (std::uint32_t i = 0; i < transition.target_count; ++i) {
        const RowId target = entrant.program.targets[transition.first_target + i];
        out += (i == 0 ? "" : " and ") + std::string(entrant.program.name(target));
    }
    return out;
}

std::string describe(const Contestant& contestant, const Happening& happening) {
    const std::string row = name(contestant, happening.row);
    switch (happening.kind) {
    case Happening::Kind::began: return row + " began";
    case Happening::Kind::ended:
        return row + " ended with " + std::string(name_of(happening.status)) + " in its " +
               ordinal(happening.ticks) + " tick (" + seconds(contestant, happening.ticks) + ")";
    case Happening::Kind::left:
        return row + " was left after " + ticks(happening.ticks) + " (" +
               seconds(contestant, happening.ticks) + ")";
    case Happening::Kind::transition:
        return "the transition " + describe_transition(contestant.entrant(), happening.transition) +
               " of " + row + " was taken";
    }
    return {};
}

/// Whether the run came to another label, or began one anew.
bool changed(const Contestant& contestant) {
    return !contestant.happenings().empty();
}

/// The run at the next tick in which something happens; none if nothing does for a long time.
std::optional<Contestant> next_change(Contestant run) {
    const double dt = run.episode().setup().dt;
    for (double time = 0.0; time < look_ahead && run.tick(); time += dt) {
        if (changed(run)) { return run; }
    }
    return {};
}

/// How this kind of behaviour comes from one label to the next, with the numbers of this tick.
std::string rule(const Contestant& contestant) {
    const Entrant& entrant = contestant.entrant();
    if (!entrant.program.is_machine()) {
        return "A tree ticks its leaf first; when the leaf ends, the next one begins in the same "
               "tick.";
    }
    const RowId before = contestant.row_before();
    std::string out = "A machine tests the transitions of its state first, before the state runs";
    std::string tests;
    for (RowId n = before; n; n = entrant.program.at(n).parent) {
        const StateInfo& state = entrant.program.state(n);
        for (std::uint32_t i = 0; i < state.transition_count; ++i) {
            const TransitionId id{state.first_transition + i};
            const std::string to = targets(entrant, id);
            tests += (tests.empty() ? "" : ", then ") + describe_transition(entrant, id) +
                     (to.empty() ? "" : " to " + to);
        }
    }
    if (!tests.empty()) { out += ": " + tests; }
    if (before && before == contestant.row() && !changed(contestant)) {
        const std::uint64_t ran = contestant.ticks_of(before) - 1;
        out += ". None of them fired: " + name(contestant, before) + " had run for " + ticks(ran) +
               " (" + seconds(contestant, ran) + ")";
    }
    return out + ".";
}

std::string conclusion(const Contestant& gone, const Contestant& waiting,
                       const std::optional<Contestant>& later) {
    const std::string to = name(gone, gone.row());
    if (!later || name(*later, later->row()) != to) {
        return "So " + gone.entrant().file + " is now in " + to + ", and " +
               waiting.entrant().file + " still in " + name(waiting, waiting.row()) + ".";
    }
    const std::uint64_t delay = later->episode().state().tick - waiting.episode().state().tick;
    return "So the step to " + to + " comes " + ticks(delay) + " later in " +
           waiting.entrant().file + ", and the robot has moved differently by then.";
}

/// The case in which neither run came to another label.
std::string same_label(const Contestant& a, const Contestant& b) {
    const std::uint64_t a_ticks = a.ticks_of(a.row());
    const std::uint64_t b_ticks = b.ticks_of(b.row());
    if (a_ticks == b_ticks) {
        return "Both go on with what they do, but do not command the same velocity.";
    }
    return "Both go on with what they do, but one is in its " + ordinal(a_ticks) +
           " tick and the other in its " + ordinal(b_ticks) + ".";
}

}  // namespace

std::string describe_transition(const Entrant& entrant, TransitionId transition) {
    const ElementId e = Places(entrant.program, entrant.document).of(transition);
    if (!e) { return "number " + std::to_string(transition.index); }
    const Document& document = entrant.document;
    std::string_view words = document.value(e, "cond");
    std::string out;
    if (words.empty()) {
        words = document.value(e, "event");
        out = "on ";
    }
    if (words.empty()) { return "(line " + std::to_string(document.at(e).where.line) + ")"; }
    return out + '"' + std::string(words) + "\" (line " +
           std::to_string(document.at(e).where.line) + ')';
}

std::string describe_tick(const Contestant& contestant) {
    if (!changed(contestant)) {
        const std::uint64_t n = contestant.ticks_of(contestant.row());
        return name(contestant, contestant.row()) + " went on, in its " + ordinal(n) + " tick (" +
               seconds(contestant, n) + ")";
    }
    std::string out;
    const std::size_t count = contestant.happenings().size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i != 0) { out += i + 1 == count ? ", and " : ", "; }
        out += describe(contestant, contestant.happenings()[i]);
    }
    return out;
}

std::vector<std::string> explain(const Contestant& a, const Contestant& b) {
    std::vector<std::string> lines;
    const std::string tick = std::to_string(a.episode().state().tick);
    for (const Contestant* contestant : {&a, &b}) {
        const std::string& file = contestant->entrant().file;
        lines.push_back(file + ": in tick " + tick + ", " + describe_tick(*contestant) + ".");
        lines.push_back("  " + rule(*contestant));
        if (changed(*contestant)) { continue; }
        if (const std::optional<Contestant> later = next_change(*contestant)) {
            lines.push_back("  Next, in tick " + std::to_string(later->episode().state().tick) +
                            ": " + describe_tick(*later) + ".");
        }
    }
    if (changed(a) && !changed(b)) {
        lines.push_back(conclusion(a, b, next_change(b)));
    } else if (changed(b) && !changed(a)) {
        lines.push_back(conclusion(b, a, next_change(a)));
    } else if (changed(a)) {
        lines.push_back("Both come to something new in this tick: what each tests first decides.");
    } else {
        lines.push_back(same_label(a, b));
    }
    return lines;
}

}  // namespace trellis
