// What the machine of reference_machine.h does besides entering and leaving states: executable
// content, messages, invoked machines.
// SPDX-License-Identifier: MIT
#include "support/reference_machine.h"

#include <algorithm>

namespace trellis::test {

// Turns -------------------------------------------------------------------------------------------

void ReferenceMachine::cycle() {
    ++time_;
    queue_due();
    take_turns(true);
    if (!running_) { exit_interpreter(); }
}

// A machine takes all its events, then the machines it has invoked do, until no events are left.
void ReferenceMachine::take_turns(bool begins) {
    if (begins && running_) { come_to_rest(); }
    begun_ = outermost_.time_;
    take_external();
    while (running_ && !children_.empty() && !outermost_.is_endless()) {
        run_child_machines();
        if (!anything_waits()) { return; }
        take_external();
    }
}

void ReferenceMachine::take_external() {
    while (running_ && !external_.empty() && !outermost_.is_endless()) {
        const Message message = external_.front();
        external_.pop_front();
        ++outermost_.microsteps_;
        const bool current =
            message.invoke != 0 && message.activation == activations_[message.invoke];
        if (message.completes && !current) { continue; }
        if (current && configuration_.count(parent(message.invoke)) != 0) {
            for (const Index finalize : children(message.invoke, "finalize")) {
                run_content(finalize);
            }
        }
        for (Child& child : children_) {
            if (value(child.invoke, "autoforward") != "true") { continue; }
            child.machine.external_.push_back({.name = message.name});
        }
        const std::vector<Way> ways = select(&message.name);
        if (!ways.empty()) { microstep(ways); }
        come_to_rest();
    }
}

void ReferenceMachine::run_child_machines() {
    for (auto child = children_.begin(); child != children_.end();) {
        ReferenceMachine& machine = child->machine;
        if (machine.running_) { machine.take_turns(machine.begun_ != outermost_.time_); }
        if (machine.running_) {
            ++child;
            continue;
        }
        machine.exit_interpreter();
        external_.push_back({.name = "done.invoke." + std::string(value(child->invoke, "id")),
                             .invoke = child->invoke,
                             .activation = activations_[child->invoke],
                             .completes = true});
        child = children_.erase(child);
    }
}

bool ReferenceMachine::anything_waits() const {
    return !external_.empty() ||
           std::any_of(children_.begin(), children_.end(),
                       [](const Child& c) { return c.machine.anything_waits(); });
}

void ReferenceMachine::start_invokes() {
    const std::set<Index> states = std::move(to_invoke_);
    to_invoke_.clear();
    for (const Index state : states) {
        for (const Index invoke : children(state, "invoke")) {
            ++activations_[invoke];
            const Index content = children(invoke, "content").front();
            const auto place = std::find_if(children_.begin(), children_.end(),
                                            [&](const Child& c) { return c.invoke > invoke; });
            const auto child = children_.emplace(place, invoke, document_,
                                                 children(content, "scxml").front(), this);
            child->machine.outer_invoke_ = invoke;
            child->machine.start();
            if (child->machine.running_) { continue; }
            child->machine.exit_interpreter();
            external_.push_back({.name = "done.invoke." + std::string(value(invoke, "id")),
                                 .invoke = invoke,
                                 .activation = activations_[invoke],
                                 .completes = true});
            children_.erase(child);
        }
    }
}

void ReferenceMachine::cancel_invokes(Index state) {
    for (const Index invoke : children(state, "invoke")) {
        const auto child = std::find_if(children_.begin(), children_.end(),
                                        [&](const Child& c) { return c.invoke == invoke; });
        if (child == children_.end()) { continue; }
        child->machine.mute_ = true;
        child->machine.exit_interpreter();
        children_.erase(child);
    }
}

// Messages ----------------------------------------------------------------------------------------

// Of all sessions, in the order of their time.
void ReferenceMachine::queue_due() {
    const auto due = [&](const Delayed& d) { return d.due <= outermost_.time_; };
    const std::vector<Delayed> all = delayed_;
    std::erase_if(delayed_, due);
    for (const Delayed& message : all) {
        if (due(message) && !deliver(message.target, message.message)) {
            internal_.push_back("error.communication");
        }
    }
    for (Child& child : children_) {
        child.machine.queue_due();
    }
}

bool ReferenceMachine::deliver(std::string_view target, Message message) {
    if (mute_) { return true; }
    if (target.empty()) {
        external_.push_back(message);
        return true;
    }
    if (target == "#_parent") {
        if (parent_ == nullptr) { return false; }
        message.invoke = outer_invoke_;
        message.activation = parent_->activations_[outer_invoke_];
        parent_->external_.push_back(message);
        return true;
    }
    if (target.starts_with("#_scxml_s")) {
        ReferenceMachine* const session = outermost_.find_session(target.substr(9));
        if (session == nullptr) { return false; }
        session->external_.push_back(message);
        return true;
    }
    for (Child& child : children_) {
        if (value(child.invoke, "id") != target.substr(2) || !child.machine.running_) { continue; }
        child.machine.external_.push_back(message);
        return true;
    }
    return false;
}

ReferenceMachine* ReferenceMachine::find_session(std::string_view number) {
    if (!running_) { return nullptr; }
    if (std::to_string(number_) == number) { return this; }
    for (Child& child : children_) {
        if (ReferenceMachine* const found = child.machine.find_session(number)) { return found; }
    }
    return nullptr;
}

bool ReferenceMachine::run_send(Index send) {
    const std::string target(value(send, "target"));
    const Message message{.name = std::string(value(send, "event"))};
    if (!target.empty() && !target.starts_with("#_")) {
        internal_.push_back("error.execution");
        return false;
    }
    if (target == "#_internal") {
        internal_.push_back(message.name);
    } else if (const std::string_view delay = value(send, "delay"); !delay.empty()) {
        const Delayed delayed{.due = outermost_.time_ + std::stoi(std::string(delay)),
                              .target = target,
                              .sendid = std::string(value(send, "id")),
                              .message = message};
        const auto place =
            std::find_if(delayed_.begin(), delayed_.end(),
                         [&](const Delayed& other) { return other.due > delayed.due; });
        delayed_.insert(place, delayed);
    } else if (!deliver(target, message)) {
        internal_.push_back("error.communication");
    }
    return true;
}

// Executable content ------------------------------------------------------------------------------

void ReferenceMachine::run_blocks(Index s, std::string_view element) {
    for (const Index block : children(s, element)) {
        run_content(block);
    }
}

bool ReferenceMachine::run_content(Index parent) {
    for (const ElementId action : document_.children({parent})) {
        if (!run_action(action.index)) { return false; }
    }
    return true;
}

bool ReferenceMachine::run_action(Index action) {
    const std::string_view kind = name(action);
    if (kind == "raise") {
        internal_.emplace_back(value(action, "event"));
    } else if (kind == "log") {
        outermost_.trace +=
            's' + std::to_string(number_) + " log " + std::string(value(action, "label")) + '\n';
    } else if (kind == "assign") {
        if (value(action, "expr") != "n + 1") {
            internal_.emplace_back("error.execution");
            return false;
        }
        ++n_;
    } else if (kind == "if") {
        return run_branches(action);
    } else if (kind == "foreach") {
        return run_loop(action);
    } else if (kind == "send") {
        return run_send(action);
    } else if (kind == "cancel") {
        std::erase_if(delayed_,
                      [&](const Delayed& d) { return d.sendid == value(action, "sendid"); });
    }
    return true;
}

bool ReferenceMachine::run_branches(Index branches) {
    bool taken = condition(value(branches, "cond"));
    bool done = false;
    for (const ElementId child : document_.children({branches})) {
        const std::string_view kind = document_.name(child);
        if (kind == "elseif" || kind == "else") {
            done = done || taken;
            taken = !done && (kind == "else" || condition(document_.value(child, "cond")));
        } else if (taken && !done && !run_action(child.index)) {
            return false;
        }
    }
    return true;
}

bool ReferenceMachine::run_loop(Index loop) {
    const std::string_view array = value(loop, "array");
    if (!array.starts_with('[')) {
        internal_.emplace_back("error.execution");
        return false;
    }
    const auto commas = std::count(array.begin(), array.end(), ',');
    for (std::ptrdiff_t i = 0; array != "[]" && i <= commas; ++i) {
        if (!run_content(loop)) { return false; }
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
    if (text == "_x.bumper") { return outermost_.bumper; }
    if (text.starts_with('!')) { return !truth(text.substr(1), failed); }
    if (text.starts_with("In('")) {
        const std::vector<Index> named = states_named(text.substr(4, text.size() - 6));
        return !named.empty() && configuration_.count(named.front()) != 0;
    }
    if (text.starts_with("n < ")) { return n_ < std::stoi(std::string(text.substr(4))); }
    if (text.starts_with("n > ")) { return n_ > std::stoi(std::string(text.substr(4))); }
    failed = true;
    return false;
}

}  // namespace trellis::test
