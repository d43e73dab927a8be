// What each node makes of the statuses of its children: the rules of exec/tree_rules.cpp and its
// neighbours, for all statuses at once.
// SPDX-License-Identifier: MIT
#include "load/tree_statuses.h"

#include "core/ports.h"
#include "load/forms.h"

#include <algorithm>
#include <optional>

namespace trellis {

namespace {

using enum Status;
using Reason = NeverTicked::Reason;

class Analysis {
public:
    Analysis(const Program& program, const std::vector<SlotId>& unset)
        : program_(program), unset_(unset) {}

    TreeStatuses find() {
        found_.by_row.resize(program_.rows.size());
        auto conditions = program_.conditions.rbegin();
        for (auto i = static_cast<std::uint32_t>(program_.rows.size()); i-- != 0;) {
            const RowId n{i};
            const Row& row = program_.rows[i];
            StatusSet& can = found_.by_row[i];
            can = returned(n, row);
            if (row.conditional) { can = with_conditions(n, (conditions++)->second, can); }
        }
        drop_inner();
        return std::move(found_);
    }

private:
    StatusSet of(RowId n) const { return found_.by_row[n.index]; }
    StatusSet of_child(RowId n) const { return of({n.index + 1}); }
    StatusSet returned(RowId n, const Row& row);

    // controls
    StatusSet in_order(RowId n, Status stop, Status go_on, bool yields);
    StatusSet parallel(RowId n, const Row& row);
    StatusSet parallel_all(RowId n, const Row& row);
    StatusSet branch(RowId n);
    StatusSet switched(RowId n, const Row& row);
    StatusSet try_catch(RowId n);
    // decorators
    StatusSet mapped(RowId n, Status on_success, Status on_failure) const;
    StatusSet loop(RowId n, const Row& row, Status stop, Status go_on);
    StatusSet queue(RowId n, const Row& row);
    StatusSet precondition(RowId n, const Row& row);
    StatusSet timeout(RowId n, const Row& row) const;

    StatusSet with_conditions(RowId n, const Conditions& conditions, StatusSet own);
    bool keeps_its_status(RowId n) const;

    // literals
    CodeId port(const Row& row, std::uint32_t i) const {
        return program_.ports[program_.nodes[row.arg].first_port + i];
    }
    const Value* literal(CodeId code) const { return literal_of(program_.code, code); }
    std::optional<std::int64_t> integer(CodeId code) const;
    std::optional<bool> truth(CodeId code) const;
    StatusSet status(CodeId code) const;
    bool may_be_none(CodeId threshold, std::uint32_t children) const;

    std::uint32_t child_count(RowId n) const {
        std::uint32_t count = 0;
        for ([[maybe_unused]] const RowId child : children(program_, n)) {
            ++count;
        }
        return count;
    }
    void never(RowId first, RowId end, RowId cause, Reason reason) {
        found_.never_ticked.push_back({first, end, cause, reason});
    }
    void drop_inner();

    const Program& program_;
    const std::vector<SlotId>& unset_;
    TreeStatuses found_;
};

StatusSet Analysis::returned(RowId n, const Row& row) {
    switch (row.op) {
    case Op::sequence:
    case Op::reactive_sequence: return in_order(n, failure, success, false);
    case Op::fallback:
    case Op::reactive_fallback: return in_order(n, success, failure, false);
    case Op::async_sequence:
    case Op::sequence_with_memory: return in_order(n, failure, success, true);
    case Op::async_fallback: return in_order(n, success, failure, true);
    case Op::parallel: return parallel(n, row);
    case Op::parallel_all: return parallel_all(n, row);
    case Op::if_then_else:
    case Op::while_do_else: return branch(n);
    case Op::switch2:
    case Op::switch3:
    case Op::switch4:
    case Op::switch5:
    case Op::switch6: return switched(n, row);
    case Op::try_catch: return try_catch(n);
    case Op::inverter: return mapped(n, failure, success);
    case Op::force_success: return mapped(n, success, success);
    case Op::force_failure: return mapped(n, failure, failure);
    case Op::repeat: return loop(n, row, failure, success);
    case Op::retry: return loop(n, row, success, failure);
    case Op::keep_running:
        return (of_child(n) & failure) |
               (of_child(n).has_any({success, running, skipped}) ? running : StatusSet());
    case Op::delay:
    case Op::wait_value_update: return of_child(n) | running;
    case Op::timeout: return timeout(n, row);
    case Op::run_once:
    case Op::skip_unless_updated: return of_child(n) | skipped;
    case Op::precondition: return precondition(n, row);
    case Op::loop_int:
    case Op::loop_bool:
    case Op::loop_double:
    case Op::loop_string: return queue(n, row);
    case Op::always_success:
    case Op::script:
    case Op::unset_blackboard: return success;
    case Op::always_failure: return failure;
    case Op::set_blackboard:
        return literal(port(row, 0)) != nullptr ? success : StatusSet{success, failure};
    case Op::script_condition: {
        const std::optional<bool> holds = truth(program_.ports[row.arg]);
        return !holds ? StatusSet{success, failure} : *holds ? success : failure;
    }
    case Op::was_entry_updated: return {success, failure};
    case Op::sleep: return {running, success};
    case Op::condition:
        return program_.call(n).type->condition ? StatusSet{success, failure}
                                                : StatusSet{success, failure, skipped};
    case Op::action:
    case Op::run_machine:
    case Op::test: return StatusSet::all();
    case Op::tree:
    case Op::subtree: return of_child(n);
    case Op::machine:
    case Op::state:
    case Op::final:
    case Op::parallel_state:
    case Op::history:
    case Op::invoke: break;  // not ticked as nodes are
    }
    return {};
}

// Controls ----------------------------------------------------------------------------------------

// A child is reached once all before it have gone on or were skipped.
StatusSet Analysis::in_order(RowId n, Status stop, Status go_on, bool yields) {
    const RowId end = program_.at(n).end;
    StatusSet result;
    bool all_skip = true;
    bool goes_on = false;
    for (const RowId child : children(program_, n)) {
        const StatusSet can = of(child);
        const RowId next = program_.at(child).end;
        result |= can & StatusSet{stop, running};
        goes_on |= can.has(go_on);
        all_skip &= can.has(skipped);
        if (next == end) { break; }
        if (yields && can.has(go_on)) { result |= running; }
        if (!can.has_any({go_on, skipped})) {
            never(next, end, child,
                  go_on == success ? Reason::never_succeeds : Reason::never_fails);
            return result;
        }
    }
    if (goes_on) { result |= go_on; }
    if (all_skip) { result |= skipped; }
    return result;
}

StatusSet Analysis::parallel(RowId n, const Row& row) {
    StatusSet any;
    bool all_skip = true;
    for (const RowId child : children(program_, n)) {
        any |= of(child);
        all_skip &= of(child).has(skipped);
    }
    const std::uint32_t count = child_count(n);
    StatusSet result = any & StatusSet{running, failure};
    // a skipped child may count as one that succeeded, or be waited for
    if (any.has(skipped)) { result |= {success, running}; }
    if (any.has(success) || may_be_none(port(row, 0), count)) { result |= success; }
    if (may_be_none(port(row, 1), count)) { result |= failure; }
    if (all_skip) { result |= skipped; }
    return result;
}

StatusSet Analysis::parallel_all(RowId n, const Row& row) {
    StatusSet any;
    bool all_skip = true;
    for (const RowId child : children(program_, n)) {
        any |= of(child);
        all_skip &= of(child).has(skipped);
    }
    StatusSet result = any & StatusSet{running, success, failure};
    if (any.has(skipped)) { result |= success; }
    // more failures may be allowed than there are, so that no failure of a child is one
    if (any.has(failure)) { result |= success; }
    if (may_be_none(port(row, 0), child_count(n))) { result |= failure; }
    if (all_skip) { result |= skipped; }
    return result;
}

// IfThenElse and WhileDoElse. A question that is skipped ends the run.
StatusSet Analysis::branch(RowId n) {
    const RowId end = program_.at(n).end;
    const RowId question{n.index + 1};
    const RowId then = program_.at(question).end;
    const RowId otherwise = program_.at(then).end;
    const StatusSet answer = of(question);
    StatusSet result = answer & running;
    if (answer.has(success)) {
        result |= of(then);
    } else {
        never(then, otherwise, question, Reason::never_succeeds);
    }
    if (answer.has(failure)) {
        result |= otherwise != end ? of(otherwise) : failure;
    } else if (otherwise != end) {
        never(otherwise, end, question, Reason::never_fails);
    }
    return result;
}

StatusSet Analysis::switched(RowId n, const Row& row) {
    const SlotId variable = variable_of(program_.code, port(row, 0));
    if (std::binary_search(unset_.begin(), unset_.end(), variable)) {
        RowId last{n.index + 1};
        while (program_.at(last).end != row.end) {
            last = program_.at(last).end;
        }
        never({n.index + 1}, last, n, Reason::no_variable);
        return of(last);
    }
    StatusSet result;
    std::uint32_t i = 1;
    for (const RowId child : children(program_, n)) {
        result |= of(child);
        if (program_.at(child).end == row.end) { break; }  // of no case
        const Value* const value = literal(port(row, i));
        std::uint32_t k = 1;
        for (const RowId earlier : children(program_, n)) {
            if (k == i) { break; }
            const Value* const other = literal(port(row, k++));
            if (value != nullptr && other != nullptr && *value == *other) {
                never(child, program_.at(child).end, earlier, Reason::same_case);
                break;
            }
        }
        ++i;
    }
    return result;
}

StatusSet Analysis::try_catch(RowId n) {
    const RowId end = program_.at(n).end;
    StatusSet tried;
    bool all_skip = true;
    bool ends = true;
    RowId child{n.index + 1};
    for (RowId next = program_.at(child).end; next != end; next = program_.at(child).end) {
        const StatusSet can = of(child);
        if (ends) { tried |= can; }
        all_skip &= can.has(skipped);
        const bool is_last = program_.at(next).end == end;
        if (ends && !is_last && !can.has_any({success, skipped})) {
            // the last child is not one of those after it
            RowId last = next;
            while (program_.at(last).end != end) {
                last = program_.at(last).end;
            }
            never(next, last, child, Reason::never_succeeds);
        }
        ends = ends && can.has_any({success, skipped});
        child = next;
    }
    StatusSet result = tried & running;
    if (ends && tried.has(success)) { result |= success; }
    if (ends && all_skip) { result |= skipped; }
    const bool caught_on_halt =
        tried.has_any({running, skipped}) && truth(port(program_.at(n), 0)) != false;
    if (tried.has(failure)) {
        result |= of(child) & running;
        if (of(child).has_any({success, failure, skipped})) { result |= failure; }
    } else if (!caught_on_halt) {
        never(child, end, n, Reason::nothing_fails);
    }
    return result;
}

// Decorators --------------------------------------------------------------------------------------

StatusSet Analysis::mapped(RowId n, Status on_success, Status on_failure) const {
    const StatusSet can = of_child(n);
    StatusSet result = can & StatusSet{running, skipped};
    if (can.has(success)) { result |= on_success; }
    if (can.has(failure)) { result |= on_failure; }
    return result;
}

// Repeat and RetryUntilSuccessful: each cycle that ends in the tick in which it began yields.
StatusSet Analysis::loop(RowId n, const Row& row, Status stop, Status go_on) {
    const StatusSet can = of_child(n);
    const std::optional<std::int64_t> cycles = integer(program_.ports[row.arg]);
    if (cycles && (*cycles == 0 || *cycles < -1)) {
        never({n.index + 1}, row.end, n,
              row.op == Op::repeat ? Reason::no_cycles : Reason::no_attempts);
        return go_on;
    }
    StatusSet result = can & StatusSet{stop, running, skipped};
    if (!cycles || (*cycles != -1 && can.has(go_on))) { result |= go_on; }
    if (can.has(go_on) && cycles != 1) { result |= running; }
    if (cycles == -1 && can == StatusSet(go_on)) { found_.endless.push_back(n); }
    return result;
}

StatusSet Analysis::queue(RowId n, const Row& row) {
    const Value* const elements = literal(port(row, 0));
    const StatusSet at_end = status(port(row, 1));
    if (elements != nullptr && elements->elements().empty()) {
        never({n.index + 1}, row.end, n, Reason::no_elements);
        return at_end;
    }
    const StatusSet can = of_child(n);
    const bool goes_on = can.has_any({success, skipped, running});
    return (can & failure) | at_end | (goes_on ? running : StatusSet());
}

StatusSet Analysis::precondition(RowId n, const Row& row) {
    const std::optional<bool> holds = truth(port(row, 0));
    if (holds == false) { never({n.index + 1}, row.end, n, Reason::switched_off); }
    StatusSet result;
    if (holds != false) { result |= of_child(n); }
    if (holds != true) { result |= status(port(row, 1)); }
    return result;
}

// A child that is skipped may have been left running.
StatusSet Analysis::timeout(RowId n, const Row& row) const {
    const StatusSet can = of_child(n);
    const std::optional<std::int64_t> ms = integer(port(row, 0));
    const bool limited = !ms || *ms > 0;
    return limited && can.has_any({running, skipped}) ? can | failure : can;
}

// Conditions --------------------------------------------------------------------------------------

// What decides before the node is ticked (TREES §1.5).
StatusSet Analysis::with_conditions(RowId n, const Conditions& conditions, StatusSet own) {
    const struct {
        CodeId code;
        bool decides;
        Status forced;
    } before[] = {
        {conditions.failure_if, true, failure},
        {conditions.success_if, true, success},
        {conditions.skip_if, true, skipped},
        {conditions.while_true, false, skipped},
    };
    StatusSet result;
    for (const auto& [code, decides, forced] : before) {
        if (!code) { continue; }
        const std::optional<bool> holds = truth(code);
        if (holds == !decides) { continue; }
        result |= forced;
        if (holds && !keeps_its_status(n)) {
            never(n, program_.at(n).end, n, Reason::switched_off);
            return result;
        }
    }
    return result | own;
}

// The question of IfThenElse and WhileDoElse is ticked again without being reset, and a node that
// is not idle is not asked for its conditions.
bool Analysis::keeps_its_status(RowId n) const {
    const RowId parent = program_.at(n).parent;
    if (!parent || n.index != parent.index + 1) { return false; }
    const Op op = program_.at(parent).op;
    return op == Op::if_then_else || op == Op::while_do_else;
}

// Literals ----------------------------------------------------------------------------------------

std::optional<std::int64_t> Analysis::integer(CodeId code) const {
    const Value* const value = literal(code);
    std::int64_t result = 0;
    return value != nullptr && to_integer(*value, result) ? std::optional(result) : std::nullopt;
}

std::optional<bool> Analysis::truth(CodeId code) const {
    const Value* const value = literal(code);
    bool result = false;
    return value != nullptr && to_boolean(*value, result) ? std::optional(result) : std::nullopt;
}

StatusSet Analysis::status(CodeId code) const {
    const Value* const value = literal(code);
    for (const Status status : {running, success, failure, skipped}) {
        if (value == nullptr) { break; }
        if (value->is(Value::Kind::text) && value->as_text() == name_of(status)) { return status; }
    }
    return StatusSet::all();
}

// Whether a threshold of Parallel may be 0: then it is reached by nothing.
bool Analysis::may_be_none(CodeId threshold, std::uint32_t children) const {
    const std::optional<std::int64_t> asked = integer(threshold);
    return !asked || *asked == 0 || *asked + children + 1 <= 0;
}

// What lies in rows that are never ticked needs no reason of its own.
void Analysis::drop_inner() {
    std::vector<NeverTicked>& all = found_.never_ticked;
    std::sort(all.begin(), all.end(), [](const NeverTicked& a, const NeverTicked& b) {
        return a.first != b.first ? a.first < b.first : b.end < a.end;
    });
    RowId end{0};
    const auto is_inner = [&](const NeverTicked& rows) {
        if (rows.first < end) { return true; }
        end = rows.end;
        return false;
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_inner), all.end());
    std::reverse(found_.endless.begin(), found_.endless.end());
}

}  // namespace

TreeStatuses find_statuses(const Program& program, const std::vector<SlotId>& unset) {
    return Analysis(program, unset).find();
}

}  // namespace trellis
