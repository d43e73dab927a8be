// The procedures of Appendix D, by their names there where there is one.
// SPDX-License-Identifier: MIT
#include "support/reference_machine.h"

#include <algorithm>
#include <sstream>

namespace trellis::test {

namespace {

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream in{std::string(text)};
    std::vector<std::string> out;
    for (std::string word; in >> word;) {
        out.push_back(word);
    }
    return out;
}

}  // namespace

ReferenceMachine::ReferenceMachine(const Document& document, Index root, ReferenceMachine* parent)
    : document_(document), root_(root), parent_(parent),
      outermost_(parent != nullptr ? parent->outermost_ : *this), number_(++outermost_.sessions_) {}

// The document ------------------------------------------------------------------------------------

std::vector<std::uint32_t> ReferenceMachine::children(Index e, std::string_view named) const {
    std::vector<Index> out;
    for (const ElementId child : document_.children({e})) {
        if (document_.name(child) == named) { out.push_back(child.index); }
    }
    return out;
}

bool ReferenceMachine::is_state(Index s) const {
    return name(s) == "state" || name(s) == "parallel" || name(s) == "final";
}

bool ReferenceMachine::is_compound(Index s) const {
    return name(s) == "scxml" || (name(s) == "state" && !is_atomic(s));
}

bool ReferenceMachine::is_descendant(Index s, Index of) const {
    while (s != root_) {
        s = parent(s);
        if (s == of) { return true; }
    }
    return false;
}

std::vector<std::uint32_t> ReferenceMachine::child_states(Index s) const {
    std::vector<Index> out;
    for (const ElementId child : document_.children({s})) {
        if (is_state(child.index)) { out.push_back(child.index); }
    }
    return out;
}

std::vector<std::uint32_t> ReferenceMachine::states_named(std::string_view names) const {
    std::vector<Index> out;
    for (const std::string& wanted : words_of(names)) {
        for (Index s = root_ + 1; s < document_.at({root_}).end.index; ++s) {
            if (name(s) == "scxml") {  // another machine's
                s = document_.at({s}).end.index - 1;
            } else if ((is_state(s) || name(s) == "history") && value(s, "id") == wanted) {
                out.push_back(s);
            }
        }
    }
    return out;
}

ReferenceMachine::Way ReferenceMachine::initial_way(Index s) const {
    Way way{.source = s, .targets = {}, .domain = s};
    for (const Index initial : children(s, "initial")) {
        way.element = initial + 1;
        way.targets = states_named(value(way.element, "target"));
    }
    if (document_.find({s}, "initial") != nullptr) {
        way.targets = states_named(value(s, "initial"));
    }
    if (way.targets.empty()) { way.targets.push_back(child_states(s).front()); }
    return way;
}

void ReferenceMachine::say(std::string_view what, Index state) {
    outermost_.trace += 's' + std::to_string(number_) + ' ' + std::string(what) + ' ' +
                        std::string(value(state, "id")) + '\n';
}

std::string ReferenceMachine::configuration() const {
    std::set<std::string> ids;
    for (const Index s : configuration_) {
        ids.insert(std::string(value(s, "id")));
    }
    std::string out;
    for (const std::string& id : ids) {
        out += (out.empty() ? "" : " ") + id;
    }
    return out;
}

// Selection ---------------------------------------------------------------------------------------

std::vector<std::uint32_t> ReferenceMachine::effective_targets(const Way& way) const {
    std::vector<Index> out;
    for (const Index target : way.targets) {
        if (name(target) != "history") {
            out.push_back(target);
        } else if (histories_.count(target) != 0) {
            const std::vector<Index>& stored = histories_.at(target);
            out.insert(out.end(), stored.begin(), stored.end());
        } else {
            const Index transition = children(target, "transition").front();
            const Way initial{.targets = states_named(value(transition, "target"))};
            const std::vector<Index> more = effective_targets(initial);
            out.insert(out.end(), more.begin(), more.end());
        }
    }
    return out;
}

// getTransitionDomain, with findLCCA
std::uint32_t ReferenceMachine::domain(const Way& way) const {
    const std::vector<Index> targets = effective_targets(way);
    const auto is_around = [&](Index s) {
        return std::all_of(targets.begin(), targets.end(),
                           [&](Index target) { return is_descendant(target, s); });
    };
    if (way.internal && is_compound(way.source) && is_around(way.source)) { return way.source; }
    Index s = parent(way.source);
    while (!is_compound(s) || !is_around(s)) {
        s = parent(s);
    }
    return s;
}

bool ReferenceMachine::matches(Index transition, const std::string& event) const {
    for (std::string descriptor : words_of(value(transition, "event"))) {
        if (descriptor == "*" || descriptor == ".*") { return true; }
        if (descriptor.ends_with(".*")) { descriptor.resize(descriptor.size() - 2); }
        if (descriptor.ends_with('.')) { descriptor.pop_back(); }
        if (event == descriptor || event.starts_with(descriptor + '.')) { return true; }
    }
    return false;
}

bool ReferenceMachine::find_enabled(Index atom, const std::string* event, Way& found) {
    for (Index s = atom; s != root_; s = parent(s)) {
        for (const Index t : children(s, "transition")) {
            const bool eventless = document_.find({t}, "event") == nullptr;
            if (eventless != (event == nullptr) || (event != nullptr && !matches(t, *event))) {
                continue;
            }
            if (document_.find({t}, "cond") != nullptr && !condition(value(t, "cond"))) {
                continue;
            }
            found = {.element = t,
                     .source = s,
                     .targets = states_named(value(t, "target")),
                     .internal = value(t, "type") == "internal"};
            if (!found.targets.empty()) { found.domain = domain(found); }
            return true;
        }
    }
    return false;
}

// selectTransitions, and selectEventlessTransitions without an event
std::vector<ReferenceMachine::Way> ReferenceMachine::select(const std::string* event) {
    std::vector<Way> enabled;
    for (const Index s : configuration_) {
        Way way;
        if (!is_atomic(s) || !find_enabled(s, event, way)) { continue; }
        const bool known = std::any_of(enabled.begin(), enabled.end(),
                                       [&](const Way& w) { return w.element == way.element; });
        if (!known) { enabled.push_back(way); }
    }
    return without_conflicts(enabled);
}

ReferenceMachine::States ReferenceMachine::exit_set(const Way& way) const {
    States out;
    for (const Index s : configuration_) {
        if (!way.targets.empty() && is_descendant(s, way.domain)) { out.insert(s); }
    }
    return out;
}

// removeConflictingTransitions
std::vector<ReferenceMachine::Way>
ReferenceMachine::without_conflicts(const std::vector<Way>& enabled) const {
    std::vector<Way> filtered;
    for (const Way& way : enabled) {
        const States mine = exit_set(way);
        std::vector<Way> kept;
        bool preempted = false;
        for (const Way& other : filtered) {
            const States theirs = exit_set(other);
            const bool conflict = std::any_of(mine.begin(), mine.end(),
                                              [&](Index s) { return theirs.count(s) != 0; });
            if (!conflict) {
                kept.push_back(other);
            } else if (!is_descendant(way.source, other.source)) {
                preempted = true;
                break;
            }
        }
        if (preempted) { continue; }
        kept.push_back(way);
        filtered = std::move(kept);
    }
    return filtered;
}

// Microsteps --------------------------------------------------------------------------------------

void ReferenceMachine::microstep(const std::vector<Way>& ways) {
    ++outermost_.microsteps_;
    for (const Way& way : ways) {
        say("take", way.source);
    }
    exit_states(ways);
    for (const Way& way : ways) {
        run_content(way.element);
    }
    enter_states(ways);
}

void ReferenceMachine::exit_states(const std::vector<Way>& ways) {
    States leaving;
    for (const Way& way : ways) {
        leaving.merge(exit_set(way));
    }
    for (const Index s : leaving) {
        to_invoke_.erase(s);
        for (const Index history : children(s, "history")) {
            std::vector<Index>& stored = histories_[history];
            stored.clear();
            for (const Index active : configuration_) {
                const bool counts = value(history, "type") == "deep"
                                        ? is_atomic(active) && is_descendant(active, s)
                                        : parent(active) == s;
                if (counts) { stored.push_back(active); }
            }
        }
    }
    for (auto s = leaving.rbegin(); s != leaving.rend(); ++s) {
        run_blocks(*s, "onexit");
        cancel_invokes(*s);
        configuration_.erase(*s);
        say("leave", *s);
    }
}

void ReferenceMachine::enter_states(const std::vector<Way>& ways) {
    Entry entry;
    for (const Way& way : ways) {
        for (const Index target : way.targets) {
            add_descendants(target, entry);
        }
        for (const Index target : effective_targets(way)) {
            add_ancestors(target, way.domain, entry);
        }
    }
    for (const Index s : entry.states) {
        // Appendix D adds the states between a history's default and its parent, active or not
        if (!configuration_.insert(s).second) { continue; }
        to_invoke_.insert(s);
        say("enter", s);
        run_blocks(s, "onentry");
        if (entry.by_default.count(s) != 0 && initial_way(s).element != 0) {
            run_content(initial_way(s).element);
        }
        if (entry.history_content.count(s) != 0) { run_content(entry.history_content.at(s)); }
        if (name(s) == "final") { finish(s); }
    }
}

// addDescendantStatesToEnter
void ReferenceMachine::add_descendants(Index s, Entry& entry) const {
    if (name(s) == "history") {
        const Way way{.targets = {s}};
        if (histories_.count(s) == 0) {
            const Index transition = children(s, "transition").front();
            entry.history_content[parent(s)] = transition;
            for (const Index target : states_named(value(transition, "target"))) {
                add_descendants(target, entry);
            }
        } else {
            for (const Index stored : histories_.at(s)) {
                add_descendants(stored, entry);
            }
        }
        for (const Index target : effective_targets(way)) {
            add_ancestors(target, parent(s), entry);
        }
        return;
    }
    entry.states.insert(s);
    if (is_compound(s)) {
        entry.by_default.insert(s);
        const Way way = initial_way(s);
        for (const Index target : way.targets) {
            add_descendants(target, entry);
        }
        for (const Index target : effective_targets(way)) {
            add_ancestors(target, s, entry);
        }
    }
    if (name(s) == "parallel") { add_regions(s, entry); }
}

// addAncestorStatesToEnter
void ReferenceMachine::add_ancestors(Index s, Index top, Entry& entry) const {
    for (Index up = parent(s); up != top; up = parent(up)) {
        entry.states.insert(up);
        if (name(up) == "parallel") { add_regions(up, entry); }
    }
}

void ReferenceMachine::add_regions(Index parallel, Entry& entry) const {
    for (const Index region : child_states(parallel)) {
        const bool entered = std::any_of(entry.states.begin(), entry.states.end(),
                                         [&](Index s) { return is_descendant(s, region); });
        if (!entered) { add_descendants(region, entry); }
    }
}

void ReferenceMachine::finish(Index final_state) {
    Index around = parent(final_state);
    if (around == root_) {
        running_ = false;
        return;
    }
    internal_.push_back("done.state." + std::string(value(around, "id")));
    for (around = parent(around); name(around) == "parallel" && is_finished(around);
         around = parent(around)) {
        internal_.push_back("done.state." + std::string(value(around, "id")));
    }
}

// isInFinalState
bool ReferenceMachine::is_finished(Index s) const {
    const std::vector<Index> states = child_states(s);
    if (name(s) == "parallel") {
        return std::all_of(states.begin(), states.end(), [&](Index c) { return is_finished(c); });
    }
    return std::any_of(states.begin(), states.end(),
                       [&](Index c) { return name(c) == "final" && configuration_.count(c) != 0; });
}

// The main loop -----------------------------------------------------------------------------------

void ReferenceMachine::start() {
    running_ = true;
    begun_ = outermost_.time_;
    for (const Index datamodel : children(root_, "datamodel")) {
        n_ = std::stoi(std::string(value(children(datamodel, "data").front(), "expr")));
    }
    enter_states({initial_way(root_)});
    come_to_rest();
}

// Eventless transitions and internal events; then what is to be invoked.
void ReferenceMachine::come_to_rest() {
    while (running_ && !outermost_.is_endless()) {
        if (const std::vector<Way> ways = select(nullptr); !ways.empty()) {
            microstep(ways);
            continue;
        }
        if (internal_.empty()) {
            if (to_invoke_.empty()) { return; }
            start_invokes();
            if (internal_.empty()) { return; }
            continue;
        }
        const std::string event = internal_.front();
        internal_.pop_front();
        ++outermost_.microsteps_;
        if (const std::vector<Way> ways = select(&event); !ways.empty()) { microstep(ways); }
    }
}

void ReferenceMachine::exit_interpreter() {
    while (!configuration_.empty()) {
        const Index s = *configuration_.rbegin();
        run_blocks(s, "onexit");
        cancel_invokes(s);
        configuration_.erase(s);
        say("leave", s);
    }
    delayed_.clear();
}

}  // namespace trellis::test
