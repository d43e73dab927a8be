// Steps, and the moments before them.
// SPDX-License-Identifier: MIT
#include "runner/trial.h"

#include "core/number.h"
#include "exec/step.h"
#include "load/load.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace trellis {

namespace {

/// The number that the whole text spells.
std::optional<Value> number_in(std::string_view text) {
    const ParsedNumber number = parse_whole_number(text);
    if (number.length == 0) { return {}; }
    const bool whole = text.find_first_not_of("+-0123456789") == std::string_view::npos;
    if (whole && number.value >= -9e15 && number.value <= 9e15) {
        return Value::integer(static_cast<std::int64_t>(number.value));
    }
    return Value::real(number.value);
}

/// The text as a value of the type that a variable has; none if it is none.
std::optional<Value> value_of_type(EntryType type, std::string_view text) {
    Value value = Trial::value_in(text);
    switch (type) {
    case EntryType::missing:
    case EntryType::any: return value;
    case EntryType::text: return Value::text(value.is(Value::Kind::text) ? value.as_text() : text);
    case EntryType::boolean:
        if (value.is(Value::Kind::boolean)) { return value; }
        if (text == "0" || text == "1") { return Value::boolean(text == "1"); }
        return {};
    case EntryType::real:
        if (value.is(Value::Kind::integer)) {
            return Value::real(static_cast<double>(value.as_integer()));
        }
        return value.is(Value::Kind::real) ? std::optional(value) : std::nullopt;
    case EntryType::integer:
    case EntryType::unsigned_integer:
        return value.is(Value::Kind::integer) ? std::optional(value) : std::nullopt;
    }
    return {};
}

std::string_view type_word(EntryType type) {
    switch (type) {
    case EntryType::boolean: return "true or false";
    case EntryType::real: return "a number";
    case EntryType::integer:
    case EntryType::unsigned_integer: return "a whole number";
    case EntryType::text:
    case EntryType::missing:
    case EntryType::any: break;
    }
    return "a value";
}

}  // namespace

Value Trial::value_in(std::string_view text) {
    if (text == "true" || text == "false") { return Value::boolean(text == "true"); }
    if (const std::optional<Value> number = number_in(text)) { return *number; }
    const bool quoted = text.size() >= 2 && text.front() == '\'' && text.back() == '\'';
    return Value::text(quoted ? text.substr(1, text.size() - 2) : text);
}

Trial::Trial(Mocks& mocks, EpisodeSetup setup, bool world)
    : mocks_(mocks), setup_(std::move(setup)),
      world_(world), now_{.state = {},
                          .robot = {},
                          .calls = {},
                          .statuses = RowStatuses(mocks.program())} {
    reset();
}

void Trial::reset() {
    before_.clear();
    happened_.clear();
    fault_.clear();
    now_ = {.state = fresh_state(program()),
            .robot = at_start(setup_.world),
            .calls = mocks_.no_calls(),
            .statuses = RowStatuses(program())};
    now_.state.random = setup_.random;
    with_host([&](HostRef host) {
        start(program(), now_.state, host, {.dt = setup_.dt, .trace = this});
    });
}

template <class Act>
void Trial::with_host(Act act) {
    Mocks::Host host{now_.robot, &mocks_, &now_.calls, &now_.state.last_leaf};
    act(HostRef(host.robot));
    now_.robot = host.robot;
}

void Trial::begin_step() {
    if (before_.size() == most_kept) { before_.pop_front(); }
    before_.push_back(now_);
    happened_.clear();
    fault_.clear();
}

bool Trial::tick() {
    begin_step();
    if (world_) { sense(setup_.world, now_.robot); }
    with_host([&](HostRef host) {
        now_.status = step(program(), now_.state, host, {.dt = setup_.dt, .trace = this});
    });
    if (now_.state.fault) {
        fault_ = describe_fault(program(), now_.state);
        now_ = std::move(before_.back());
        before_.pop_back();
        return false;
    }
    if (world_) { move(now_.robot, setup_.dt); }
    return true;
}

void Trial::send(std::string_view event, Value data) {
    begin_step();
    trellis::send(program(), now_.state, event, std::move(data));
}

void Trial::halt() {
    begin_step();
    with_host([&](HostRef host) {
        trellis::halt(program(), now_.state, host, {.dt = setup_.dt, .trace = this});
    });
    now_.status = Status::idle;
}

std::size_t Trial::back(std::size_t steps) {
    const std::size_t undone = std::min(steps, before_.size());
    if (undone == 0) { return 0; }
    now_ = std::move(before_[before_.size() - undone]);
    before_.resize(before_.size() - undone, now_);
    happened_.clear();
    return undone;
}

std::string Trial::assign(std::string_view name, std::string_view value) {
    std::vector<std::string> paths;
    for (std::uint32_t i = 0; i < program().slots.size(); ++i) {
        paths.push_back(path_of(program(), program().slots[i]));
        if (paths.back() != name) { continue; }
        const EntryType type = program().is_machine() ? EntryType::any : now_.state.entries[i];
        std::optional<Value> assigned = value_of_type(type, value);
        if (!assigned) {
            return std::string(name) + " takes " + std::string(type_word(type)) + ", found \"" +
                   std::string(value) + '"';
        }
        begin_step();
        now_.state.slots[i] = std::move(*assigned);
        wake(now_.state);
        if (type == EntryType::missing) { now_.state.entries[i] = EntryType::any; }
        return {};
    }
    return "there is no variable \"" + std::string(name) + '"' +
           suggestion(name, {paths.begin(), paths.end()});
}

std::vector<std::pair<std::string, const Value*>> Trial::variables() const {
    std::vector<std::pair<std::string, const Value*>> all;
    for (std::uint32_t i = 0; i < program().slots.size(); ++i) {
        all.emplace_back(path_of(program(), program().slots[i]), &now_.state.slots[i]);
    }
    return all;
}

void Trial::on(const TraceEvent& event) {
    now_.statuses.on(event);
    const std::string name(event.row ? program().name(event.row) : "");
    switch (event.kind) {
    case TraceEvent::Kind::tick:
        happened_.push_back(name + ' ' + std::string(name_of(event.to)));
        break;
    case TraceEvent::Kind::halt: happened_.push_back(name + " halted"); break;
    case TraceEvent::Kind::leave:
        if (!is_end(program(), event.row)) { happened_.push_back(name + " left"); }
        break;
    case TraceEvent::Kind::enter: happened_.push_back(name + " entered"); break;
    case TraceEvent::Kind::log: happened_.push_back("log " + std::string(event.text)); break;
    case TraceEvent::Kind::error: happened_.push_back("error " + std::string(event.text)); break;
    case TraceEvent::Kind::status:
    case TraceEvent::Kind::skip:
    case TraceEvent::Kind::transition:
    case TraceEvent::Kind::event: break;
    }
}

}  // namespace trellis
