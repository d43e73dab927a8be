// The decorators that wait, count or watch (TREES §1.2), one function each. Time is logical: a
// deadline is the number of a tick. Those that only map a status are in tree_rules.cpp. Covered by
// tests/exec/tree_nodes_test.cpp and tests/exec/tree_reference_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/ports.h"
#include "exec/evaluate_rules.h"
#include "exec/stepper.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace trellis {

namespace {

/// Queue loops: the child runs.
constexpr std::uint32_t child_runs = 0x80000000;

}  // namespace

Status Stepper::tick_keep_running(RowId n) {
    store(n, Status::running);
    const RowId child = first_child(n);
    const Status status = tick(child);
    if (is_done(status)) { reset(child); }
    return status == Status::failure || status == Status::idle ? status : Status::running;
}

// Time --------------------------------------------------------------------------------------------

Status Stepper::tick_delay(RowId n, const Row& row) {
    enum : std::uint32_t { not_begun, waiting, over };
    const NodeInfo& node = p_.nodes[row.arg];
    std::uint32_t& phase = memory_[n.index];
    std::int64_t ms = 0;
    if (!integer_port(n, port(node, 0), ms)) { return Status::idle; }
    if (phase == not_begun) {
        store(n, Status::running);
        s_.words[node.word.index] = tick_after(ms);
        phase = waiting;
    }
    if (phase == waiting && tick_.count < s_.words[node.word.index]) { return Status::running; }
    phase = over;
    const RowId child = first_child(n);
    const Status status = tick(child);
    if (is_done(status)) {
        phase = not_begun;
        reset(child);
    }
    return status;
}

// The child is halted when the time is over, in the tick that then fails. One that does not run at
// that time is not limited any more.
Status Stepper::tick_timeout(RowId n, const Row& row) {
    enum : std::uint32_t { not_begun, limited, unlimited };
    const NodeInfo& node = p_.nodes[row.arg];
    const RowId child = first_child(n);
    std::uint32_t& phase = memory_[n.index];
    std::int64_t ms = 0;
    if (!integer_port(n, port(node, 0), ms)) { return Status::idle; }
    if (phase == not_begun) {
        store(n, Status::running);
        s_.words[node.word.index] = tick_after(ms);
        phase = ms > 0 ? limited : unlimited;
    } else if (phase == limited && tick_.count >= s_.words[node.word.index]) {
        phase = unlimited;
        if (status_[child.index] == Status::running) {
            reset(child);
            phase = not_begun;
            return Status::failure;
        }
    }
    const Status status = tick(child);
    if (is_done(status)) {
        phase = not_begun;
        reset(child);
    }
    return status;
}

// Once --------------------------------------------------------------------------------------------

// Never begun anew, not even after a halt.
Status Stepper::tick_run_once(RowId n, const Row& row) {
    std::uint32_t& ended = memory_[n.index];
    bool skips = true;
    if (!boolean_port(n, port(p_.nodes[row.arg], 0), skips)) { return Status::idle; }
    if (ended != 0) { return skips ? Status::skipped : static_cast<Status>(ended); }
    store(n, Status::running);
    const RowId child = first_child(n);
    const Status status = tick(child);
    if (is_done(status)) {
        ended = static_cast<std::uint32_t>(status);
        reset(child);
    }
    return status;
}

// The script is not asked while the child runs, nor after it was skipped.
Status Stepper::tick_precondition(RowId n, const Row& row) {
    const NodeInfo& node = p_.nodes[row.arg];
    std::uint32_t& let_in = memory_[n.index];
    bool holds = let_in != 0;
    if (!holds && !condition(n, port(node, 0), holds)) { return Status::idle; }
    if (!holds) { return status_port(n, port(node, 1)); }
    let_in = 1;
    const RowId child = first_child(n);
    const Status status = tick(child);
    if (is_done(status)) {
        let_in = 0;
        reset(child);
    }
    return status;
}

// Queues ------------------------------------------------------------------------------------------

// One element per tick: a tick that finds the queue empty ends the loop.
Status Stepper::tick_queue(RowId n, const Row& row, EntryType elements) {
    const NodeInfo& node = p_.nodes[row.arg];
    std::uint32_t& memory = memory_[n.index];
    if (status_[n.index] == Status::idle) {
        memory = 0;
        s_.queues[node.queue.index].set_undefined();
    }
    if ((memory & child_runs) == 0) {
        Value taken;
        const Value* element = nullptr;
        if (!next_element(n, row, elements, taken, element)) { return Status::idle; }
        if (element == nullptr) { return status_port(n, port(node, 1)); }
        if (node.entry && !write_element(n, node.entry, elements, *element)) {
            return Status::idle;
        }
    }
    if (status_[n.index] == Status::idle) { store(n, Status::running); }
    const RowId child = first_child(n);
    const Status status = tick(child);
    if (status == Status::idle) { return status; }
    memory = status == Status::running ? memory | child_runs : memory & ~child_runs;
    if (is_done(status)) { reset(child); }
    return status == Status::failure ? status : Status::running;
}

// Takes the next element; null if there is none, false after a fault. An array in a variable
// is used up; a text is read when the loop begins.
bool Stepper::next_element(RowId n, const Row& row, EntryType elements, Value& taken,
                           const Value*& element) {
    const NodeInfo& node = p_.nodes[row.arg];
    const CodeId code = port(node, 0);
    const Value* queue = port_value(code);
    if (!is_literal(code)) {
        const Operand from = p_.code.instructions[code.index].a;
        if (queue != nullptr && queue->is(Value::Kind::array)) {
            taken = s_.slots[from.index()].take_first();
            if (!taken.is(Value::Kind::undefined)) { element = &taken; }
            return true;
        }
        Value& read = s_.queues[node.queue.index];
        if (read.is(Value::Kind::undefined)) {
            if (queue == nullptr || !queue->is(Value::Kind::text)) {
                fault(Fault::Kind::expression, n,
                      "the queue must be an array or a text, found " +
                          (queue == nullptr ? "nothing" : print(*queue)));
                return false;
            }
            if (!split_queue(n, queue->as_text(), elements, read)) { return false; }
        }
        queue = &read;
    }
    std::uint32_t& count = memory_[n.index];
    if (count < queue->elements().size()) { element = &queue->element(count++); }
    return true;
}

bool Stepper::write_element(RowId n, SlotId slot, EntryType elements, const Value& element) {
    EntryType& type = s_.entries[slot.index];
    std::string why;
    if (type == EntryType::missing) { type = elements; }
    if (write_entry(PortType::any, element, s_.slots[slot.index], type, why)) {
        count_write(slot);
        return true;
    }
    fault(Fault::Kind::output, n, "output \"value\": " + why);
    return false;
}

bool Stepper::split_queue(RowId n, std::string_view text, EntryType elements, Value& queue) {
    Value found = Value::array();
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(';', at), text.size());
        Value element;
        if (!convert_text(elements, text.substr(at, end - at), element)) {
            fault(Fault::Kind::expression, n,
                  "the queue '" + std::string(text) + "' has an element that does not convert");
            return false;
        }
        found.append(std::move(element));
        at = end + 1;
    }
    queue = std::move(found);
    return true;
}

// Watching ----------------------------------------------------------------------------------------

// Whether the entry was written since this was last asked. One that does not exist was not.
bool Stepper::was_written(const NodeInfo& node) {
    if (s_.entries[node.entry.index] == EntryType::missing) { return false; }
    std::uint64_t& seen = s_.words[node.word.index];
    const std::uint32_t now = s_.writes[node.entry.index];
    const bool written = seen != now;
    seen = now;
    return written;
}

// SkipUnlessUpdated and WaitValueUpdate: a child that runs goes on without being asked for.
Status Stepper::tick_updated(RowId n, const Row& row, Status otherwise) {
    std::uint32_t& runs = memory_[n.index];
    if (runs == 0 && !was_written(p_.nodes[row.arg])) { return otherwise; }
    const RowId child = first_child(n);
    const Status status = tick(child);
    if (status == Status::idle) { return status; }
    runs = status == Status::running ? 1 : 0;
    if (is_done(status)) {
        store(n, status);
        reset(child);
    }
    return status;
}

}  // namespace trellis
