// The procedures of Appendix D, by their names there where there is one.
// SPDX-License-Identifier: MIT
#include "support/reference_machine.h"

#include <cstdint>
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

ReferenceMachine::ReferenceMachine(const Document& document) : document_(document) {}

// The document
// --------------------------------------------------------------------------------------

bool ReferenceMachine::is_state(std::uint32_t s) const {
    const std::string_view name = document_.name({s});
    return name == "state" || name == "final" || name == "scxml";
}

bool ReferenceMachine::is_final(std::uint32_t s) const {
    return document_.name({s}) == "final";
}

std::uint32_t ReferenceMachine::parent(std::uint32_t s) const {
    return document_.at({s}).parent.index;
}

bool ReferenceMachine::is_descendant(std::uint32_t s, std::uint32_t of) const {
    while (s != 0) {
        s = parent(s);
        if (s == of) { return true; }
    }
    return false;
}

std::vector<std::uint32_t> ReferenceMachine::child_states(std::uint32_t s) const {
    std::vector<std::uint32_t> out;
    for (const ElementId child : document_.children({s})) {
        if (is_state(child.index)) { out.push_back(child.index); }
    }
    return out;
}

std::string ReferenceMachine::id(std::uint32_t s) const {
    return std::string(document_.value({s}, "id"));
}

std::vector<std::uint32_t> ReferenceMachine::states_named(std::string_view names) const {
    std::vector<std::uint32_t> out;
    for (const std::string& name : words_of(names)) {
        for (std::uint32_t s = 1; s < document_.elements.size(); ++s) {
            if (is_state(s) && id(s) == name) { out.push_back(s); }
        }
    }
    return out;
}

ReferenceMachine::Way ReferenceMachine::initial_way(std::uint32_t s) const {
    Way way{.element = {}, .source = s, .targets = {}};
    for (const ElementId child : document_.children({s})) {
        if (document_.name(child) != "initial") { continue; }
        way.element = {child.index + 1};
        way.targets = states_named(document_.value(way.element, "target"));
    }
    if (document_.find({s}, "initial") != nullptr) {
        way.targets = states_named(document_.value({s}, "initial"));
    }
    if (way.targets.empty()) { way.targets.push_back(child_states(s).front()); }
    return way;
}

// Selection ---------------------------------------------------------------------------------------

std::uint32_t ReferenceMachine::domain(const Way& way) const {
    const auto around_targets = [&](std::uint32_t s) {
        for (const std::uint32_t target : way.targets) {
            if (!is_descendant(target, s)) { return false; }
        }
        return true;
    };
    if (way.internal && around_targets(way.source)) { return way.source; }
    std::uint32_t s = parent(way.source);
    while (!around_targets(s)) {
        s = parent(s);
    }
    return s;
}

bool ReferenceMachine::matches(ElementId transition, const std::string& event) const {
    for (std::string descriptor : words_of(document_.value(transition, "event"))) {
        if (descriptor == "*" || descriptor == ".*") { return true; }
        if (descriptor.ends_with(".*")) { descriptor.resize(descriptor.size() - 2); }
        if (descriptor.ends_with('.')) { descriptor.pop_back(); }
        if (event == descriptor || event.starts_with(descriptor + '.')) { return true; }
    }
    return false;
}

// selectTransitions and selectEventlessTransitions: one atomic state is active
bool ReferenceMachine::find_enabled(const std::string* event, Way& found) {
    std::uint32_t s = *configuration_.rbegin();
    for (;; s = parent(s)) {
        for (const ElementId t : document_.children({s})) {
            if (document_.name(t) != "transition") { continue; }
            const bool eventless = document_.find(t, "event") == nullptr;
            if (eventless != (event == nullptr) || (event != nullptr && !matches(t, *event))) {
                continue;
            }
            if (document_.find(t, "cond") != nullptr && !condition(document_.value(t, "cond"))) {
                continue;
            }
            found = {.element = t,
                     .source = s,
                     .targets = states_named(document_.value(t, "target")),
                     .internal = document_.value(t, "type") == "internal"};
            return true;
        }
        if (s == 0) { return false; }
    }
}

// Microsteps --------------------------------------------------------------------------------------

void ReferenceMachine::microstep(const Way& way) {
    ++microsteps_;
    trace += "take " + id(way.source) + '\n';
    exit_states(way);
    run_content(way.element);
    enter_states(way);
}

void ReferenceMachine::exit_states(const Way& way) {
    if (way.targets.empty()) { return; }
    const std::uint32_t top = domain(way);
    States leaving;
    for (const std::uint32_t s : configuration_) {
        if (is_descendant(s, top)) { leaving.insert(s); }
    }
    for (auto s = leaving.rbegin(); s != leaving.rend(); ++s) {
        run_blocks(*s, "onexit");
        configuration_.erase(*s);
        trace += "leave " + id(*s) + '\n';
    }
}

void ReferenceMachine::enter_states(const Way& way) {
    States to_enter;
    States by_default;
    for (const std::uint32_t target : way.targets) {
        add_descendants(target, to_enter, by_default);
    }
    if (!way.targets.empty()) {
        const std::uint32_t top = way.source == 0 ? 0 : domain(way);
        for (const std::uint32_t target : way.targets) {
            add_ancestors(target, top, to_enter);
        }
    }
    for (const std::uint32_t s : to_enter) {
        configuration_.insert(s);
        trace += "enter " + id(s) + '\n';
        run_blocks(s, "onentry");
        if (by_default.contains(s)) {
            if (const Way initial = initial_way(s); initial.element) {
                run_content(initial.element);
            }
        }
        if (!is_final(s)) { continue; }
        if (parent(s) == 0) {
            running_ = false;
        } else {
            internal_.push_back("done.state." + id(parent(s)));
        }
    }
}

void ReferenceMachine::add_descendants(std::uint32_t s, States& to_enter,
                                       States& by_default) const {
    to_enter.insert(s);
    if (child_states(s).empty()) { return; }
    by_default.insert(s);
    for (const std::uint32_t target : initial_way(s).targets) {
        add_descendants(target, to_enter, by_default);
        add_ancestors(target, s, to_enter);
    }
}

void ReferenceMachine::add_ancestors(std::uint32_t s, std::uint32_t top, States& to_enter) const {
    for (std::uint32_t up = parent(s); up != top; up = parent(up)) {
        to_enter.insert(up);
    }
}

// The main loop -----------------------------------------------------------------------------------

void ReferenceMachine::start() {
    running_ = true;
    for (std::uint32_t e = 0; e < document_.elements.size(); ++e) {
        if (document_.name({e}) == "data" && document_.value({e}, "id") == "n") {
            n_ = std::stoi(std::string(document_.value({e}, "expr")));
        }
    }
    configuration_.insert(0);
    const Way way = initial_way(0);
    enter_states(way);
    come_to_rest();
}

void ReferenceMachine::send(std::string_view event) {
    if (!running_) { return; }
    const std::string name(event);
    Way way;
    if (find_enabled(&name, way)) { microstep(way); }
    come_to_rest();
}

void ReferenceMachine::come_to_rest() {
    while (running_ && !is_endless()) {
        Way way;
        if (find_enabled(nullptr, way)) {
            microstep(way);
            continue;
        }
        if (internal_.empty()) { return; }
        const std::string event = internal_.front();
        internal_.pop_front();
        ++microsteps_;
        if (find_enabled(&event, way)) { microstep(way); }
    }
    if (!running_) { exit_interpreter(); }
}

void ReferenceMachine::exit_interpreter() {
    while (configuration_.size() > 1) {
        const std::uint32_t s = *configuration_.rbegin();
        run_blocks(s, "onexit");
        configuration_.erase(s);
        trace += "leave " + id(s) + '\n';
    }
}

std::string ReferenceMachine::configuration() const {
    std::string out;
    for (const std::uint32_t s : configuration_) {
        if (s != 0) { out += (out.empty() ? "" : " ") + id(s); }
    }
    return out;
}

// Executable content ------------------------------------------------------------------------------

void ReferenceMachine::run_blocks(std::uint32_t s, std::string_view element) {
    for (const ElementId child : document_.children({s})) {
        if (document_.name(child) == element) { run_content(child); }
    }
}

bool ReferenceMachine::run_content(ElementId parent) {
    for (const ElementId action : document_.children(parent)) {
        if (!run_action(action)) { return false; }
    }
    return true;
}

bool ReferenceMachine::run_action(ElementId action) {
    const std::string_view name = document_.name(action);
    if (name == "raise") {
        internal_.emplace_back(document_.value(action, "event"));
    } else if (name == "log") {
        trace += "log " + std::string(document_.value(action, "label")) + '\n';
    } else if (name == "assign") {
        if (document_.value(action, "expr") != "n + 1") {
            internal_.emplace_back("error.execution");
            return false;
        }
        ++n_;
    } else if (name == "if") {
        return run_branches(action);
    }
    return true;
}

bool ReferenceMachine::run_branches(ElementId branches) {
    bool taken = condition(document_.value(branches, "cond"));
    bool done = false;
    for (const ElementId child : document_.children(branches)) {
        const std::string_view name = document_.name(child);
        if (name == "elseif" || name == "else") {
            done = done || taken;
            taken = !done && (name == "else" || condition(document_.value(child, "cond")));
        } else if (taken && !done && !run_action(child)) {
            return false;
        }
    }
    return true;
}

// A condition that cannot be evaluated is false, and an error (SCXML 5.9.1).
bool ReferenceMachine::condition(std::string_view text) {
    bool failed = false;
    const bool holds = truth(text, failed);
    if (failed) { internal_.emplace_back("error.execution"); }
    return holds;
}

bool ReferenceMachine::truth(std::string_view text, bool& failed) const {
    if (text == "true" || text == "false") { return text == "true"; }
    if (text == "_x.bumper") { return bumper; }
    if (text.starts_with('!')) { return !truth(text.substr(1), failed); }
    if (text.starts_with("In('")) {
        const std::string name(text.substr(4, text.size() - 6));
        const std::vector<std::uint32_t> named = states_named(name);
        return !named.empty() && configuration_.contains(named.front());
    }
    if (text.starts_with("n < ")) { return n_ < std::stoi(std::string(text.substr(4))); }
    if (text.starts_with("n > ")) { return n_ > std::stoi(std::string(text.substr(4))); }
    failed = true;
    return false;
}

}  // namespace trellis::test
