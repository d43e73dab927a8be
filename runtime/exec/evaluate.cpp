// Two loops over instructions. The fast one computes with numbers only, in registers, calls nothing
// and therefore needs no stack frame; at the first instruction that is beyond it, it hands over to
// the general one for the rest of the expression. Both are compiled once per kind of result, so
// that the last result leaves in a register. Measured with bench/expression_bench.cpp: one general
// loop alone takes twice as long, and computed jumps instead of the switch gain nothing. Covered by
// tests/exec/evaluate_test.cpp and tests/exec/scripts_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/evaluate.h"

#include "exec/evaluate_rules.h"
#include "exec/evaluate_sinks.h"

#include <cassert>
#include <cmath>
#include <cstring>

namespace trellis {
namespace {

template <class T>
T host_value(const EvalContext& context, std::uint32_t offset) {
    T value;
    std::memcpy(&value, context.host + offset, sizeof value);
    return value;
}

// where evaluation goes on after a failure; the table's end if it does not
std::uint32_t handler_of(const CodeTable& code, std::uint32_t instruction) {
    for (const Guard& g : code.guards) {
        if (instruction >= g.begin && instruction < g.end) return g.handler;
    }
    return static_cast<std::uint32_t>(code.instructions.size());
}

bool reads_missing_variable(const EvalContext& context, const Instruction& in) {
    return in.tree && in.a.space() == Space::slot &&
           static_cast<EntryType>(context.entry_types[in.a.index()]) == EntryType::missing;
}

void set_answer(Value& target, bool answer, bool tree) {
    if (tree)
        target.set_real(answer ? 1 : 0);
    else
        target.set_boolean(answer);
}

bool in_state(EvalContext& context, const Instruction& in, Value& target) {
    RowId row{in.extra};
    if (in.op == CodeOp::in_named) {
        const Value& name = value_at(context, in.a);
        if (!name.is(Value::Kind::text)) return fail(context, EvalErrorKind::operands, name, name);
        row = context.state_named != nullptr ? context.state_named(context.world, name.as_text())
                                             : RowId();
        if (!row) return fail(context, EvalErrorKind::no_such_state, name, name);
    }
    set_answer(target, context.in_state != nullptr && context.in_state(context.world, row),
               in.tree);
    return true;
}

// every operation that has a result and neither jumps nor only copies
bool operation(const CodeTable& code, EvalContext& context, const Instruction& in) {
    Value& target = context.temporaries[in.target];
    switch (in.op) {
    case CodeOp::elapsed_count:
        target.set_real(context.row_memory[in.extra] * context.dt);
        return true;
    case CodeOp::elapsed_since:
        target.set_real((context.cycle - context.row_memory[in.extra]) * context.dt);
        return true;
    case CodeOp::sensor_boolean:
        set_answer(target, host_value<bool>(context, in.extra), in.tree);
        return true;
    case CodeOp::sensor_integer:
        target.set_real(host_value<std::int32_t>(context, in.extra));
        return true;
    case CodeOp::sensor_real: target.set_real(host_value<double>(context, in.extra)); return true;
    case CodeOp::in_state:
    case CodeOp::in_named: return in_state(context, in, target);
    case CodeOp::truth:
        target.set_boolean(machine_condition(value_at(context, in.a)) == Truth::yes);
        return true;
    case CodeOp::defined:
        set_answer(target, !value_at(context, in.a).is(Value::Kind::undefined), in.tree);
        return true;
    case CodeOp::call: return call_function(context, in);
    case CodeOp::read_at:
    case CodeOp::store_at:
    case CodeOp::make_array:
    case CodeOp::make_object: return structure_operation(context, in);
    default: return in.tree ? tree_operation(code, context, in) : machine_operation(context, in);
    }
}

// The general loop, from `in` on; what the fast loop knows too comes here only with operands that
// it does not.
template <class Sink>
[[gnu::noinline]] typename Sink::Result run_general(const CodeTable& code, const Instruction* in,
                                                    EvalContext& context, Sink sink,
                                                    double accumulator) {
    const Instruction* const instructions = code.instructions.data();
    Value* const temporaries = context.temporaries;
    temporaries[accumulator_operand.index()].set_real(accumulator);

    for (;; ++in) {
        const Value& a = value_at(context, in->a);
        const Value* result = &temporaries[in->target];
        switch (in->op) {
        case CodeOp::copy:
            if (a.is(Value::Kind::undefined) && reads_missing_variable(context, *in)) {
                fail(context, EvalErrorKind::missing, a, a);
                goto failed;
            }
            result = &a;
            break;
        case CodeOp::store:
            context.slots[in->a.index()] = value_at(context, in->b);
            if (context.writes != nullptr) ++context.writes[in->a.index()];
            result = &a;
            break;
        case CodeOp::jump: in = instructions + in->extra - 1; continue;
        case CodeOp::jump_if:
        case CodeOp::jump_unless: {
            const Truth truth = in->tree ? tree_ternary(a) : machine_condition(a);
            if (truth == Truth::failed) {
                fail(context, EvalErrorKind::not_a_condition, a, a);
                goto failed;
            }
            if ((truth == Truth::yes) != (in->op == CodeOp::jump_if)) continue;
            if (in->last) return sink.answer(truth == Truth::yes, in->tree);
            in = instructions + in->extra - 1;
            continue;
        }
        case CodeOp::assign:
        case CodeOp::assign_add:
        case CodeOp::assign_subtract:
        case CodeOp::assign_multiply:
        case CodeOp::assign_divide:
            if (!operation(code, context, *in)) goto failed;
            result = &a;
            break;
        case CodeOp::fail: fail(context, static_cast<EvalErrorKind>(in->extra), a, a); goto failed;
        default:
            if (!operation(code, context, *in)) goto failed;
        }

        if (!in->last) {
            // the accumulator as target says that nobody reads the result
            if (result != &temporaries[in->target] && in->target != accumulator_operand.index()) {
                temporaries[in->target] = *result;
            }
            continue;
        }
        if (Sink::accepts(*result, in->tree)) return sink.value(*result, in->tree);
        fail(context, Sink::refusal, *result, *result);

    failed:
        context.error.instruction = static_cast<std::uint32_t>(in - instructions);
        const std::uint32_t handler = handler_of(code, context.error.instruction);
        if (handler == code.instructions.size()) return Sink::failure();
        in = instructions + handler - 1;
    }
}

// A number for the fast loop: the accumulator, a real, an integer that a double holds exactly.
inline bool number_at(const EvalContext& context, Operand operand, double accumulator, double& x) {
    if (operand == accumulator_operand) {
        x = accumulator;
        return true;
    }
    return exact_number(value_at(context, operand), x);
}

// Can the fast loop put a number there? Asked before an assignment, which must not happen twice.
inline bool takes_number(const EvalContext& context, const Instruction& in) {
    return in.last || context.temporaries[in.target].kind() < Value::Kind::text;
}

// `number` into a tree's variable that holds a number, which keeps its type. False: it is not as
// simple as that.
template <class Sink>
inline bool assigned(EvalContext& context, const Instruction& in, double number) {
    if (!takes_number(context, in)) return false;
    Value& variable = context.slots[in.a.index()];
    if (variable.is(Value::Kind::real)) {
        variable.set_real(number);
    } else {
        // the result would be an integer, which the fast loop knows only how to forget
        if (!Sink::forgets || !in.last) return false;
        const std::optional<std::int64_t> whole = truncated(number);
        if (!whole || static_cast<double>(*whole) != number) return false;
        variable.set_integer(*whole);
    }
    if (context.writes != nullptr) ++context.writes[in.a.index()];
    return true;
}

// The fast loop, over a whole expression.
template <class Sink>
inline typename Sink::Result run(const CodeTable& code, CodeId id, EvalContext& context,
                                 Sink sink) {
    assert(id.index < code.instructions.size());
    const Instruction* const instructions = code.instructions.data();
    const Instruction* in = instructions + id.index;
    double accumulator = 0;  // what temporaries[0] is in the general loop

    for (;; ++in) {
        // a case that breaks has a number, one that goes to `answered` an answer, one that
        // continues neither
        double x = 0;
        double y = 0;
        double number = 0;
        bool answer = false;
        const auto a = [&] { return number_at(context, in->a, accumulator, x); };
        const auto b = [&] { return number_at(context, in->b, accumulator, y); };
        switch (in->op) {
        case CodeOp::add:
            if (!a() || !b()) goto general;
            number = x + y;
            break;
        case CodeOp::subtract:
            if (!a() || !b()) goto general;
            number = x - y;
            break;
        case CodeOp::multiply:
            if (!a() || !b()) goto general;
            number = x * y;
            break;
        case CodeOp::divide:
            if (!a() || !b()) goto general;
            number = x / y;
            break;
        case CodeOp::negate:
            if (!a()) goto general;
            number = -x;
            break;
        case CodeOp::absolute:
            if (!a()) goto general;
            number = std::fabs(x);
            break;

        // BehaviorTree.CPP refuses what the opposite comparison accepts, so that comparisons with
        // NaN hold
        case CodeOp::less:
            if (!a() || !b()) goto general;
            answer = in->tree ? !(x >= y) : x < y;
            goto answered;
        case CodeOp::less_equal:
            if (!a() || !b()) goto general;
            answer = in->tree ? !(x > y) : x <= y;
            goto answered;
        case CodeOp::greater:
            if (!a() || !b()) goto general;
            answer = in->tree ? !(x <= y) : x > y;
            goto answered;
        case CodeOp::greater_equal:
            if (!a() || !b()) goto general;
            answer = in->tree ? !(x < y) : x >= y;
            goto answered;
        case CodeOp::equal:
            if (!a() || !b()) goto general;
            answer = in->tree ? std::fabs(x - y) <= tree_tolerance : x == y;
            goto answered;
        case CodeOp::not_equal:
            if (!a() || !b()) goto general;
            answer = in->tree ? !(std::fabs(x - y) <= tree_tolerance) : x != y;
            goto answered;

        case CodeOp::elapsed_count: number = context.row_memory[in->extra] * context.dt; break;
        case CodeOp::elapsed_since:
            number = (context.cycle - context.row_memory[in->extra]) * context.dt;
            break;
        case CodeOp::sensor_boolean: answer = host_value<bool>(context, in->extra); goto answered;
        case CodeOp::sensor_integer: number = host_value<std::int32_t>(context, in->extra); break;
        case CodeOp::sensor_real: number = host_value<double>(context, in->extra); break;

        case CodeOp::copy:
            if (!value_at(context, in->a).is(Value::Kind::real)) goto general;
            number = value_at(context, in->a).as_real();
            break;
        case CodeOp::jump: in = instructions + in->extra - 1; continue;
        case CodeOp::jump_if:
        case CodeOp::jump_unless: {
            const Value& condition = value_at(context, in->a);
            if (!condition.is(Value::Kind::boolean) && !condition.is(Value::Kind::real))
                goto general;
            const bool holds =
                condition.is(Value::Kind::real) ? condition.as_real() != 0 : condition.as_boolean();
            if (holds != (in->op == CodeOp::jump_if)) continue;
            if (in->last) return sink.answer(holds, in->tree);
            in = instructions + in->extra - 1;
            continue;
        }
        case CodeOp::truth:
            if (!a()) goto general;
            answer = x != 0;
            goto answered;

        case CodeOp::store: {
            Value& variable = context.slots[in->a.index()];
            const bool is_real =
                in->b == accumulator_operand || value_at(context, in->b).is(Value::Kind::real);
            if (!is_real || !b() || variable.kind() >= Value::Kind::text ||
                !takes_number(context, *in))
                goto general;
            number = y;
            variable.set_real(number);
            if (context.writes != nullptr) ++context.writes[in->a.index()];
            break;
        }
        case CodeOp::declare: {
            std::uint8_t& type = context.entry_types[in->a.index()];
            if (type == static_cast<std::uint8_t>(EntryType::missing))
                type = static_cast<std::uint8_t>(EntryType::any);
            continue;
        }
        case CodeOp::assign:
            if (!context.slots[in->a.index()].is_number() || !b()) goto general;
            number = y;
            if (!assigned<Sink>(context, *in, number)) goto general;
            break;
        case CodeOp::assign_add:
            if (!a() || !b()) goto general;
            number = x + y;
            if (!assigned<Sink>(context, *in, number)) goto general;
            break;
        case CodeOp::assign_subtract:
            if (!a() || !b()) goto general;
            number = x - y;
            if (!assigned<Sink>(context, *in, number)) goto general;
            break;
        case CodeOp::assign_multiply:
            if (!a() || !b()) goto general;
            number = x * y;
            if (!assigned<Sink>(context, *in, number)) goto general;
            break;
        case CodeOp::assign_divide:
            if (!a() || !b()) goto general;
            number = x / y;
            if (!assigned<Sink>(context, *in, number)) goto general;
            break;
        default: goto general;
        }

        if (in->last) {
            if (!Sink::accepts(number, in->tree)) goto general;
            return sink.number(number);
        }
        if (in->target == accumulator_operand.index()) {
            accumulator = number;
        } else {
            Value& target = context.temporaries[in->target];
            if (target.kind() >= Value::Kind::text) goto general;
            target.set_real(number);
        }
        continue;

    answered:
        if (in->last) return sink.answer(answer, in->tree);
        Value& target = context.temporaries[in->target];
        if (target.kind() >= Value::Kind::text) goto general;
        if (in->tree)
            target.set_real(answer ? 1 : 0);
        else
            target.set_boolean(answer);
    }

general:
    return run_general(code, in, context, sink, accumulator);
}

}  // namespace

bool evaluate(const CodeTable& code, CodeId id, EvalContext& context, Value& result) {
    return run(code, id, context, ValueSink{result});
}

bool execute(const CodeTable& code, CodeId id, EvalContext& context) {
    return run(code, id, context, NoSink{});
}

Truth evaluate_condition(const CodeTable& code, CodeId id, EvalContext& context) {
    return run(code, id, context, ConditionSink{});
}

bool evaluate_real(const CodeTable& code, CodeId id, EvalContext& context, double& result) {
    return run(code, id, context, RealSink{result});
}

}  // namespace trellis
