// Executable content and data: blocks of actions (SCXML 4, 5). An action that fails raises
// error.execution and ends its block, and only it. Sending is in messages.cpp. Covered by
// tests/exec/machine_test.cpp and messages_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/ports.h"
#include "exec/evaluate_rules.h"
#include "exec/stepper.h"

#include <utility>

namespace trellis {

void Stepper::run_blocks(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        run_block(p_.blocks[first + i]);
    }
}

// False if an action failed, or the machine cannot go on.
bool Stepper::run_block(BlockId block) {
    for (std::uint32_t i = block.index;;) {
        const Action& action = p_.actions[i];
        switch (action.kind) {
        case Action::Kind::end: return true;
        case Action::Kind::unless: i = holds({0}, action.code) ? i + 1 : action.go_to.index; break;
        case Action::Kind::jump: i = action.go_to.index; break;
        case Action::Kind::each:
            if (!for_each(action, {i + 1})) { return false; }
            i = action.go_to.index;
            break;
        default:
            if (!run_action(action)) { return false; }
            ++i;
        }
    }
}

// One action that does not decide what comes next.
bool Stepper::run_action(const Action& action) {
    bool done = true;
    switch (action.kind) {
    case Action::Kind::run: done = execute(p_.code, action.code, context()); break;
    case Action::Kind::assign: done = assign(action); break;
    case Action::Kind::initialise: done = initialise(action); break;
    case Action::Kind::raise: raise({.name = action.event}); return !s_.fault;
    case Action::Kind::log: done = log(action); break;
    case Action::Kind::send: return send(p_.sends[action.arg]);
    case Action::Kind::cancel: done = cancel(action); break;
    case Action::Kind::refuse: raise_error(p_.error_event, p_.labels[action.arg]); return false;
    case Action::Kind::end:
    case Action::Kind::unless:
    case Action::Kind::jump:
    case Action::Kind::each: break;
    }
    if (!done) { raise_error({0}); }
    return done;
}

// To a variable directly; to a place below one through the temporary that its code stores.
bool Stepper::assign(const Action& action) {
    if (action.slot) {
        return evaluate(p_.code, action.code, context(), s_.slots[action.slot.index]);
    }
    return evaluate(p_.code, action.code, context(), s_.temporaries[stored_temporary]) &&
           execute(p_.code, action.store, context());
}

bool Stepper::write(const Place& place, const Value& value) {
    if (place.slot) {
        s_.slots[place.slot.index] = value;
        return true;
    }
    s_.temporaries[stored_temporary] = value;
    return execute(p_.code, place.store, context());
}

// Gives a variable its first value, once, unless the host has given it one (SCXML 5.3).
bool Stepper::initialise(const Action& action) {
    EntryType& entry = s_.entries[action.slot.index];
    if (entry != EntryType::missing) { return true; }
    entry = EntryType::any;
    Value& variable = s_.slots[action.slot.index];
    if (evaluate(p_.code, action.code, context(), variable)) { return true; }
    variable.set_undefined();
    return false;
}

// Goes through the elements that the array has at the beginning (SCXML 4.6).
bool Stepper::for_each(const Action& action, BlockId body) {
    Value& array = s_.work.loops[action.arg];
    if (!evaluate(p_.code, action.code, context(), array)) {
        raise_error({0});
        return false;
    }
    if (!array.is(Value::Kind::array)) {
        raise_error(p_.error_event,
                    "<foreach> needs an array, found " + std::string(name_of(array.kind())));
        return false;
    }
    const Loop& loop = p_.loops[action.arg];
    for (std::size_t i = 0; i < array.elements().size(); ++i) {
        if (!spend(1)) { return false; }
        s_.slots[loop.item.index] = array.element(i);
        if (loop.index) { s_.slots[loop.index.index].set_real(static_cast<double>(i)); }
        if (!run_block(body)) { return false; }
    }
    return true;
}

bool Stepper::log(const Action& action) {
    Value value;
    if (action.code && !evaluate(p_.code, action.code, context(), value)) { return false; }
    if (trace_ == nullptr) { return true; }
    std::string text = p_.labels[action.arg];
    if (action.code) {
        if (!text.empty()) { text += ": "; }
        append_text(text, value);
    }
    // between leaving and entering no state is active
    const RowId row = s_.session.atom ? s_.session.atom : RowId{0};
    trace({.kind = TraceEvent::Kind::log, .row = row, .text = text});
    return true;
}

// Puts what a message carries into an event: a <param> that fails is left out, anything else that
// fails is the failure of the whole (SCXML 5.7). Each failure raises error.execution.
bool Stepper::carry(PayloadId id, Event& event) {
    if (!id) { return true; }
    const Payload& payload = p_.payloads[id.index];
    if (payload.content) {
        if (evaluate(p_.code, payload.content, context(), event.data)) { return true; }
        raise_error({0});
        return false;
    }
    std::string raw;
    for (std::uint32_t i = 0; i < payload.item_count; ++i) {
        const PayloadItem& item = p_.payload_items[payload.first_item + i];
        Value value;
        if (!evaluate(p_.code, item.code, context(), value)) {
            raise_error({0});
            if (item.listed) { return false; }
            continue;
        }
        raw += (raw.empty() ? "" : "&") + item.name + '=';
        append_text(raw, value);
        if (!event.data.is(Value::Kind::object)) { event.data.set_object(); }
        event.data.set_member(item.name, std::move(value));
    }
    if (!raw.empty()) { event.raw.set_text(raw); }
    return true;
}

// Errors ------------------------------------------------------------------------------------------

void Stepper::raise_error(RowId n) {
    raise({.name = p_.error_event, .type = Event::Type::platform});
    if (trace_ == nullptr) { return; }
    const std::string text = evaluation_error();
    trace({.kind = TraceEvent::Kind::error, .row = n, .text = text});
}

void Stepper::raise_error(EventId error, std::string_view why, Value sendid) {
    raise({.name = error, .type = Event::Type::platform, .sendid = std::move(sendid)});
    trace({.kind = TraceEvent::Kind::error, .row = {0}, .text = why});
}

void Stepper::raise(Event event) {
    if (s_.session.internal.size() >= max_waiting_events) {
        fault(Fault::Kind::livelock, s_.session.atom, too_many_events());
        return;
    }
    s_.session.internal.push_back(std::move(event));
}

}  // namespace trellis
