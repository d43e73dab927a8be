// Messages: <send>, <cancel>, the sessions they go to, and those that wait for their time
// (SCXML 6.2, 6.3, C.1). Covered by tests/exec/messages_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/number.h"
#include "exec/evaluate_rules.h"
#include "exec/stepper.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace trellis {

std::string session_address(std::uint32_t id) {
    return std::string(session_prefix) + std::to_string(id);
}

// The row of the name, or of its longest prefix that has one: each is looked up.
Event event_named(const Program& program, std::string_view name) {
    const auto by_name = [](const EventName& row, std::string_view wanted) {
        return token_less(row.text, wanted);
    };
    Event event{.name = {0}, .type = Event::Type::external};
    for (std::string_view prefix = name; !prefix.empty();) {
        const auto row =
            std::lower_bound(program.events.begin(), program.events.end(), prefix, by_name);
        if (row != program.events.end() && row->text == prefix) {
            event.name = {static_cast<std::uint32_t>(row - program.events.begin())};
            break;
        }
        const std::size_t dot = prefix.rfind('.');
        prefix = dot == std::string_view::npos ? std::string_view() : prefix.substr(0, dot);
    }
    if (program.events[event.name.index].text != name) { event.unknown.set_text(name); }
    return event;
}

namespace {

/// A session somewhere in the tree of them.
struct Recipient {
    const Program* program = nullptr;
    State* state = nullptr;
};

/// The session with that number; none if it has ended or never was.
Recipient find_session(const Program& outermost, const Program& program, State& state,
                       std::uint32_t id) {
    if (state.session.final) { return {}; }
    if (state.session.id == id) { return {&program, &state}; }
    for (Child& child : state.children) {
        const Recipient found =
            find_session(outermost, program_of(outermost, child), child.state, id);
        if (found.state != nullptr) { return found; }
    }
    return {};
}

std::string_view full_name(const Program& program, const Event& event) {
    return event.unknown.is(Value::Kind::text) ? std::string_view(event.unknown.as_text())
                                               : program.events[event.name.index].text;
}

/// Queues an event of one machine in another, which numbers names differently. False if more wait
/// there than may.
bool hand_over(const Program& sender, Event event, const Recipient& to) {
    if (to.state->session.external.size() >= max_waiting_events) { return false; }
    if (&sender != to.program) {
        Event named = event_named(*to.program, full_name(sender, event));
        event.name = named.name;
        event.unknown = std::move(named.unknown);
    }
    to.state->session.external.push_back(std::move(event));
    return true;
}

bool is_supported(std::string_view type) {
    return type.empty() || type == "scxml" || type == event_processor;
}

}  // namespace

// Sending -----------------------------------------------------------------------------------------

// Everything is evaluated now, whenever the message is delivered (SCXML 6.2).
bool Stepper::send(const Send& send) {
    Event event;
    event.origin = s_.session.id;
    std::string target;
    double seconds = 0.0;
    if (!fill(send, event, target, seconds)) { return false; }
    if (target == "#_internal") {
        event.type = Event::Type::internal;
        event.origin = 0;
        raise(std::move(event));
    } else if (seconds > 0.0) {
        delay(seconds, target, std::move(event));
    } else {
        Value sendid = event.sendid;
        if (!deliver(target, std::move(event)) && !s_.fault) {
            raise_error(p_.communication_event, "there is no session " + target, std::move(sendid));
        }
    }
    return !s_.fault;
}

// False, after the error, if something cannot be evaluated or is not what it should be.
bool Stepper::fill(const Send& send, Event& event, std::string& target, double& seconds) {
    if (!send.id.empty()) { event.sendid.set_text(send.id); }
    const auto failed = [&](std::string_view why) {
        raise_error(p_.error_event, why, event.sendid);
        return false;
    };
    if (send.id_place) {
        event.sendid.set_text("send.s" + std::to_string(s_.session.id) + '.' +
                              std::to_string(++s_.session.made_ids));
        if (!write(send.id_place, event.sendid)) { return failed(evaluation_error()); }
    }
    const Value sendid = event.sendid;
    std::string text;
    if (send.event_code) {
        if (!text_of(send.event_code, text)) { return failed(evaluation_error()); }
        event.name = event_named(p_, text).name;
        event.unknown = event_named(p_, text).unknown;
    } else {
        event.name = send.event ? send.event : EventId{0};
    }
    event.type = Event::Type::external;
    std::string type;
    std::string wait;
    if (!text_of(send.target, target) || !text_of(send.type, type) ||
        (send.delay_code && !text_of(send.delay_code, wait))) {
        return failed(evaluation_error());
    }
    seconds = send.delay;
    if (send.delay_code) {
        const std::optional<double> given = parse_duration(wait);
        if (!given) { return failed('"' + wait + "\" is not a duration"); }
        seconds = *given;
    }
    if (!carry(send.payload, event)) { return false; }
    if (!is_supported(type)) { return failed("there is no event processor \"" + type + '"'); }
    if (!target.empty() && !target.starts_with("#_")) {
        return failed('"' + target + "\" is not the target of a message");
    }
    return true;
}

bool Stepper::text_of(CodeId code, std::string& text) {
    Value value;
    if (!evaluate(p_.code, code, context(), value)) { return false; }
    text.clear();
    append_text(text, value);
    return true;
}

bool Stepper::text_of(const LiveText& live, std::string& text) {
    if (live.code) { return text_of(live.code, text); }
    text = live.text;
    return true;
}

// Only messages of this session, and all that have the id (SCXML 6.3).
bool Stepper::cancel(const Action& action) {
    std::string id;
    if (!text_of(action.code, id)) { return false; }
    std::erase_if(s_.session.delayed, [&](const Delayed& message) {
        const Value& sendid = message.event.sendid;
        return sendid.is(Value::Kind::text) && sendid.as_text() == id;
    });
    return true;
}

// Delivering --------------------------------------------------------------------------------------

// False if there is no such session (any more).
bool Stepper::deliver(std::string_view target, Event event) {
    if (is_mute_) { return true; }
    if (target == "#_parent") { return deliver_to_parent(std::move(event)); }
    Recipient to{&p_, &s_};
    if (target.starts_with(session_prefix)) {
        const std::string_view digits = target.substr(session_prefix.size());
        std::uint32_t id = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), id);
        if (error != std::errc() || end != digits.data() + digits.size()) { return false; }
        to = find_session(outermost_.p_, outermost_.p_, outermost_.s_, id);
    } else if (!target.empty()) {
        to = {};
        for (Child& child : s_.children) {
            const InvokeInfo* const invoke = invoke_of(child);
            if (invoke == nullptr || invoke->id != target.substr(2)) { continue; }
            if (!child.state.session.final) {
                to = {&program_of(outermost_.p_, child), &child.state};
            }
        }
    }
    if (to.state == nullptr) { return false; }
    if (!hand_over(p_, std::move(event), to)) {
        fault(Fault::Kind::livelock, s_.session.atom, too_many_events());
    }
    return true;
}

bool Stepper::deliver_to_parent(Event event) {
    // a <Machine> of a tree has nobody to send to
    if (parent_ == nullptr || parent_->rows_[invoked_by_.index].op != Op::invoke) { return false; }
    event.invoke = invoked_by_;
    event.activation = parent_->memory_[invoked_by_.index];
    if (!hand_over(p_, std::move(event), {&parent_->p_, &parent_->s_})) {
        fault(Fault::Kind::livelock, s_.session.atom, too_many_events());
    }
    return true;
}

// An exact copy of an external event for every machine that asks for it (SCXML 6.4.1). `tick` is
// no message: each machine has its own.
void Stepper::forward(const Event& event) {
    for (Child& child : s_.children) {
        const InvokeInfo* const invoke = invoke_of(child);
        if (invoke == nullptr || !invoke->autoforward) { continue; }
        Event copy = event;
        if (event.invoke) { copy.invokeid.set_text(p_.invokes[rows_[event.invoke.index].arg].id); }
        copy.invoke = {};
        copy.completes = false;
        if (!hand_over(p_, std::move(copy), {&program_of(outermost_.p_, child), &child.state})) {
            fault(Fault::Kind::livelock, s_.session.atom, too_many_events());
        }
    }
}

// Messages that wait ------------------------------------------------------------------------------

// Time is kept in whole ticks: a message is delivered in the first cycle whose time is not before
// the message's. The tolerance makes 1 s sixty cycles of 1/60 s.
void Stepper::delay(double seconds, std::string_view target, Event event) {
    constexpr double tolerance = 1e-9;  // cycles
    constexpr double longest = 1e15;    // cycles
    std::vector<Delayed>& delayed = s_.session.delayed;
    if (delayed.size() >= max_waiting_events) {
        fault(Fault::Kind::livelock, s_.session.atom, too_many_events());
        return;
    }
    const double cycles = std::min(std::ceil(seconds / tick_.dt - tolerance), longest);
    Delayed message{.due = now() + std::max<std::uint64_t>(static_cast<std::uint64_t>(cycles), 1),
                    .time = static_cast<double>(now()) * tick_.dt + seconds,
                    .target = target.empty() ? Value() : Value::text(target),
                    .event = std::move(event)};
    const auto later = [](const Delayed& a, const Delayed& b) {
        return a.due != b.due ? a.due < b.due : a.time < b.time;
    };
    const auto place = std::upper_bound(delayed.begin(), delayed.end(), message, later);
    delayed.insert(place, std::move(message));
}

// Delivers what is due in this cycle, of all sessions, in the order of its time.
void Stepper::deliver_due() {
    if (!p_.has_messages) { return; }
    std::vector<Workspace::Due>& due = s_.work.due;
    collect_due(due);
    if (!s_.children.empty()) {
        std::stable_sort(due.begin(), due.end(),
                         [](const Workspace::Due& a, const Workspace::Due& b) {
                             return a.message.time < b.message.time;
                         });
    }
    for (Workspace::Due& each : due) {
        in_session(each.session, [&](Stepper& session) {
            const std::string target = each.message.target.is(Value::Kind::text)
                                           ? each.message.target.as_text()
                                           : std::string();
            Value sendid = each.message.event.sendid;
            if (!session.deliver(target, std::move(each.message.event))) {
                session.raise_error(session.p_.communication_event, "there is no session " + target,
                                    std::move(sendid));
            }
        });
    }
    due.clear();
}

void Stepper::collect_due(std::vector<Workspace::Due>& due) {
    std::vector<Delayed>& delayed = s_.session.delayed;
    std::size_t count = 0;
    for (; count < delayed.size() && delayed[count].due <= now(); ++count) {
        due.push_back({s_.session.id, std::move(delayed[count])});
    }
    delayed.erase(delayed.begin(), delayed.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < s_.children.size(); ++i) {
        in_child(i, [&](Stepper& child) { child.collect_due(due); });
    }
}

template <class Visit>
void Stepper::in_session(std::uint32_t id, Visit visit) {
    if (s_.session.id == id) { return visit(*this); }
    for (std::size_t i = 0; i < s_.children.size(); ++i) {
        in_child(i, [&](Stepper& child) { child.in_session(id, visit); });
    }
}

}  // namespace trellis
