// The controls that choose between their children or tick several at once (TREES §1.1), one
// function each. Sequences and fallbacks are in tree_rules.cpp. Covered by
// tests/exec/tree_nodes_test.cpp and, on all small trees, tests/exec/tree_reference_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/number.h"
#include "exec/evaluate_rules.h"
#include "exec/stepper.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace trellis {

namespace {

/// TryCatch: the last child is being ticked.
constexpr std::uint32_t catching = 0x40000000;

/// The text of a value as a text port of BehaviorTree.CPP reads it; `buffer` may hold it.
const std::string* spelling(const Value& value, std::string& buffer) {
    switch (value.kind()) {
    case Value::Kind::text: return &value.as_text();
    case Value::Kind::boolean:
    case Value::Kind::integer:
        buffer.clear();
        append_integer(buffer, value.is(Value::Kind::integer) ? value.as_integer()
                                                              : std::int64_t{value.as_boolean()});
        return &buffer;
    case Value::Kind::real:
        buffer.clear();
        append_fixed(buffer, value.as_real());
        return &buffer;
    case Value::Kind::undefined:
    case Value::Kind::null:
    case Value::Kind::array:
    case Value::Kind::object: break;
    }
    return nullptr;
}

/// The whole number that all of a text is, or the enumerator it names.
bool whole_number(const CodeTable& code, const std::string& text, double& number) {
    for (const EnumValue& value : code.enums) {
        if (value.name == text) {
            number = value.value;
            return true;
        }
    }
    std::int32_t integer = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, integer);
    number = integer;
    return error == std::errc() && stop == end;
}

bool real_number(const std::string& text, double& number) {
    const ParsedNumber parsed = parse_number(text);
    number = parsed.value;
    return parsed.length != 0 && parsed.length == text.size() && !parsed.out_of_range;
}

/// As a Switch compares: as texts, as integers, as numbers with a tolerance.
bool is_case(const CodeTable& code, const std::string& a, const std::string& b) {
    double x = 0.0;
    double y = 0.0;
    if (a == b) { return true; }
    if (whole_number(code, a, x) && whole_number(code, b, y) && x == y) { return true; }
    return real_number(a, x) && real_number(b, y) && std::fabs(x - y) <= tree_tolerance;
}

}  // namespace

// Parallel and ParallelAll ------------------------------------------------------------------------

// The number of children that a port of n children asks for: -1 is all, -2 all but one. False
// after a fault.
bool Stepper::threshold(RowId n, CodeId port, std::uint32_t children, std::uint32_t& result,
                        bool& is_relative) {
    std::int64_t asked = 0;
    if (!integer_port(n, port, asked)) { return false; }
    is_relative = asked < 0;
    if (is_relative) { asked = std::max<std::int64_t>(children + asked + 1, 0); }
    if (asked > children) {
        fault(Fault::Kind::node, n,
              "asks for " + std::to_string(asked) + " of " + std::to_string(children) +
                  " children");
        return false;
    }
    result = static_cast<std::uint32_t>(asked);
    return true;
}

std::uint32_t Stepper::children_that(RowId n, Status stored) const {
    std::uint32_t count = 0;
    for (const RowId child : children(p_, n)) {
        count += status_[child.index] == stored ? 1U : 0U;
    }
    return count;
}

// A child that has completed keeps its status until the node ends, and is not ticked again. The
// thresholds are looked at after every child, also after one that was not ticked.
Status Stepper::tick_parallel(RowId n, const Row& row) {
    const NodeInfo& node = p_.nodes[row.arg];
    const std::uint32_t total = child_count(n);
    std::uint32_t needed = 0;
    std::uint32_t allowed = 0;
    bool counts_skipped = false;
    bool relative = false;
    if (!threshold(n, port(node, 0), total, needed, counts_skipped) ||
        !threshold(n, port(node, 1), total, allowed, relative)) {
        return Status::idle;
    }
    store(n, Status::running);
    std::uint32_t succeeded = children_that(n, Status::success);
    std::uint32_t failed = children_that(n, Status::failure);
    std::uint32_t skipped = 0;
    for (const RowId child : children(p_, n)) {
        if (!is_done(status_[child.index])) {
            const Status status = tick(child);
            if (status == Status::idle) { return status; }
            skipped += status == Status::skipped ? 1U : 0U;
            succeeded += status == Status::success ? 1U : 0U;
            failed += status == Status::failure ? 1U : 0U;
        }
        if (succeeded + (counts_skipped ? skipped : 0) >= needed) {
            reset_children(n);
            return Status::success;
        }
        if (total - failed < needed || failed == allowed) {
            reset_children(n);
            return Status::failure;
        }
    }
    return skipped == total ? Status::skipped : Status::running;
}

Status Stepper::tick_parallel_all(RowId n, const Row& row) {
    const std::uint32_t total = child_count(n);
    std::uint32_t allowed = 0;
    bool relative = false;
    if (!threshold(n, port(p_.nodes[row.arg], 0), total, allowed, relative)) {
        return Status::idle;
    }
    store(n, Status::running);
    std::uint32_t skipped = 0;
    for (const RowId child : children(p_, n)) {
        if (is_done(status_[child.index])) { continue; }
        const Status status = tick(child);
        if (status == Status::idle) { return status; }
        skipped += status == Status::skipped ? 1U : 0U;
    }
    if (skipped == total) { return Status::skipped; }
    const std::uint32_t failed = children_that(n, Status::failure);
    if (children_that(n, Status::success) + failed + skipped < total) { return Status::running; }
    reset_children(n);
    return failed >= allowed ? Status::failure : Status::success;
}

// IfThenElse and WhileDoElse ----------------------------------------------------------------------

// The first child. A leaf that has answered and was not reset would repeat its answer for ever, as
// it does in BehaviorTree.CPP: here it is asked again.
Status Stepper::tick_question(RowId n) {
    const RowId question = first_child(n);
    const Op op = rows_[question.index].op;
    const bool repeats = op == Op::action || op == Op::sleep || op == Op::test;
    if (repeats && is_done(status_[question.index])) { reset(question); }
    const Status status = tick(question);
    if (status != Status::skipped) { return status; }
    return fault(Fault::Kind::node, n, "its condition was skipped, so there is no answer");
}

Status Stepper::tick_if_then_else(RowId n) {
    store(n, Status::running);
    std::uint32_t& chosen = memory_[n.index];
    if (chosen == 0) {
        const Status answer = tick_question(n);
        if (!is_done(answer)) { return answer; }
        const RowId then = rows_[first_child(n).index].end;
        const RowId otherwise = rows_[then.index].end;
        if (answer == Status::failure && otherwise == rows_[n.index].end) { return answer; }
        chosen = answer == Status::success ? then.index : otherwise.index;
    }
    const Status status = tick({chosen});
    if (status == Status::running || status == Status::idle) { return status; }
    reset_children(n);
    chosen = 0;
    return status;
}

Status Stepper::tick_while_do_else(RowId n) {
    store(n, Status::running);
    Status status = tick_question(n);
    if (!is_done(status)) { return status; }
    const RowId body = rows_[first_child(n).index].end;
    const RowId otherwise = rows_[body.index].end;
    const bool has_else = otherwise != rows_[n.index].end;
    if (status == Status::success) {
        if (has_else) { reset(otherwise); }
        status = tick(body);
    } else if (has_else) {
        reset(body);
        status = tick(otherwise);
    }
    if (status == Status::running || status == Status::idle) { return status; }
    reset_children(n);
    return status;
}

// Switch ------------------------------------------------------------------------------------------

// The child of the first case that is equal to the variable, or the last one. What has no value
// equals nothing.
RowId Stepper::chosen_case(RowId n, const Row& row) {
    const NodeInfo& node = p_.nodes[row.arg];
    const Value* value = port_value(port(node, 0));
    const std::string* text = value != nullptr ? spelling(*value, s_.left) : nullptr;
    RowId child = first_child(n);
    for (std::uint32_t i = 1; rows_[child.index].end != row.end; ++i) {
        const Value* other = text != nullptr ? port_value(port(node, i)) : nullptr;
        const std::string* other_text = other != nullptr ? spelling(*other, s_.right) : nullptr;
        if (other_text != nullptr && is_case(p_.code, *text, *other_text)) { break; }
        child = rows_[child.index].end;
    }
    return child;
}

Status Stepper::tick_switch(RowId n, const Row& row) {
    std::uint32_t& running = memory_[n.index];
    const RowId child = chosen_case(n, row);
    if (running != 0 && running != child.index) { reset({running}); }
    const Status status = tick(child);
    if (status == Status::idle) { return status; }
    running = status == Status::running ? child.index : 0;
    if (is_done(status)) { reset_children(n); }
    return status;
}

// TryCatch ----------------------------------------------------------------------------------------

Status Stepper::tick_try_catch(RowId n, const Row& row) {
    std::uint32_t& memory = memory_[n.index];
    const NodeInfo& node = p_.nodes[row.arg];
    if (status_[n.index] == Status::idle) {
        s_.words[node.word.index] = 0;
        memory &= ~catching;
    }
    store(n, Status::running);
    if ((memory & catching) != 0) { return tick_catch(n, row); }

    RowId child{memory};
    if (memory == 0) { child = first_child(n); }
    for (RowId next = rows_[child.index].end; next != row.end; next = rows_[child.index].end) {
        const Status status = tick(child);
        if (status == Status::running) { memory = child.index; }
        if (status == Status::running || status == Status::idle) { return status; }
        if (status == Status::failure) {
            reset_children(n);
            memory = catching;
            return tick_catch(n, row);
        }
        if (status == Status::skipped) { ++s_.words[node.word.index]; }
        child = next;
    }
    memory = 0;
    reset_children(n);
    const bool all_skipped = s_.words[node.word.index] == child_count(n) - 1;
    s_.words[node.word.index] = 0;
    return all_skipped ? Status::skipped : Status::success;
}

// What ends here has failed, whatever the last child says.
Status Stepper::tick_catch(RowId n, const Row& row) {
    const Status status = tick(last_child(n, row));
    if (status == Status::running || status == Status::idle) { return status; }
    reset_children(n);
    memory_[n.index] = 0;
    return Status::failure;
}

RowId Stepper::last_child(RowId n, const Row& row) const {
    RowId child = first_child(n);
    while (rows_[child.index].end != row.end) {
        child = rows_[child.index].end;
    }
    return child;
}

// With catch_on_halt the last child gets one tick before it is halted too.
void Stepper::halt_try_catch(RowId n, const Row& row) {
    std::uint32_t& memory = memory_[n.index];
    const NodeInfo& node = p_.nodes[row.arg];
    bool catches = false;
    if (status_[n.index] != Status::idle && (memory & catching) == 0 &&
        boolean_port(n, port(node, 0), catches) && catches) {
        const RowId last = last_child(n, row);
        reset_from(first_child(n), last);
        if (tick(last) == Status::running) { reset(last); }
    }
    memory = 0;
    s_.words[node.word.index] = 0;
    reset_children(n);
}

}  // namespace trellis
