// The inner loop: one switch over instructions, two numbers handled in place, everything else in
// evaluate_tree.cpp, evaluate_machine.cpp and evaluate_values.cpp. The loop is compiled once per
// kind of result, so that the last result leaves in a register instead of through memory. Computed
// jumps instead of the switch, and results kept in registers between instructions, were measured
// and gained nothing (bench/expression_bench.cpp). Covered by tests/exec/evaluate_test.cpp and
// tests/exec/scripts_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/evaluate.h"

#include "exec/evaluate_rules.h"

#include <cassert>
#include <cmath>
#include <cstring>

namespace trellis {
namespace {

// where the last result goes; each returns whether it is acceptable
struct ValueSink {
    Value& result;
    bool real(double x, bool) { return result.set_real(x), true; }
    bool boolean(bool x, bool tree) {
        if (tree)
            result.set_real(x ? 1 : 0);
        else
            result.set_boolean(x);
        return true;
    }
    bool value(const Value& v, bool) { return result = v, true; }
    static constexpr EvalErrorKind refusal = EvalErrorKind::none;
};

struct NoSink {
    bool real(double, bool) { return true; }
    bool boolean(bool, bool) { return true; }
    bool value(const Value&, bool) { return true; }
    static constexpr EvalErrorKind refusal = EvalErrorKind::none;
};

struct ConditionSink {
    Truth truth = Truth::failed;
    bool real(double x, bool tree) {
        truth = x != 0 ? Truth::yes : Truth::no;
        return !tree || !(x < 0);
    }
    bool boolean(bool x, bool) { return truth = x ? Truth::yes : Truth::no, true; }
    bool value(const Value& v, bool tree) {
        truth = tree ? tree_condition(v) : machine_condition(v);
        return truth != Truth::failed;
    }
    static constexpr EvalErrorKind refusal = EvalErrorKind::not_a_condition;
};

struct RealSink {
    double number = 0;
    bool real(double x, bool) { return number = x, true; }
    bool boolean(bool x, bool) { return number = x ? 1 : 0, true; }
    bool value(const Value& v, bool) {
        if (!v.is_number() && !v.is(Value::Kind::boolean)) return false;
        number = v.number();
        return true;
    }
    static constexpr EvalErrorKind refusal = EvalErrorKind::not_a_number;
};

// two reals, the case that matters, first
inline bool numbers(const Value& a, const Value& b, double& x, double& y) {
    if (a.is(Value::Kind::real) && b.is(Value::Kind::real)) [[likely]] {
        x = a.as_real();
        y = b.as_real();
        return true;
    }
    return exact_number(a, x) && exact_number(b, y);
}

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

// the operations that the inner loop does not know
bool other_operation(const CodeTable& code, EvalContext& context, const Instruction& in) {
    switch (in.op) {
    case CodeOp::call: return call_function(context, in);
    case CodeOp::read_at:
    case CodeOp::store_at:
    case CodeOp::make_array:
    case CodeOp::make_object: return structure_operation(context, in);
    default: return in.tree ? tree_operation(code, context, in) : machine_operation(context, in);
    }
}

bool in_state(EvalContext& context, const Instruction& in, bool& answer) {
    RowId row{in.extra};
    if (in.op == CodeOp::in_named) {
        const Value& name = value_at(context, in.a);
        if (!name.is(Value::Kind::text))
            return fail(context, EvalErrorKind::operands, name, Value());
        row = context.state_named != nullptr ? context.state_named(context.world, name.as_text())
                                             : RowId();
        if (!row) return fail(context, EvalErrorKind::no_such_state, name, Value());
    }
    answer = context.in_state != nullptr && context.in_state(context.world, row);
    return true;
}

template <class Sink>
bool run(const CodeTable& code, CodeId id, EvalContext& context, Sink& sink) {
    assert(id.index < code.instructions.size());
    const Instruction* const instructions = code.instructions.data();
    const Instruction* in = instructions + id.index;
    Value* const temporaries = context.temporaries;

    for (;; ++in) {
        const auto a = [&]() -> const Value& { return value_at(context, in->a); };
        const auto b = [&]() -> const Value& { return value_at(context, in->b); };
        double x = 0;
        double y = 0;
        // a case that breaks has a number, one that goes to `answered` an answer, one that goes to
        // `delivered` a result
        double number = 0;
        bool answer = false;
        const Value* result = nullptr;
        switch (in->op) {
        case CodeOp::add:
            if (!numbers(a(), b(), x, y)) goto other;
            number = x + y;
            break;
        case CodeOp::subtract:
            if (!numbers(a(), b(), x, y)) goto other;
            number = x - y;
            break;
        case CodeOp::multiply:
            if (!numbers(a(), b(), x, y)) goto other;
            number = x * y;
            break;
        case CodeOp::divide:
            if (!numbers(a(), b(), x, y)) goto other;
            number = x / y;
            break;
        case CodeOp::negate:
            if (!exact_number(a(), x)) goto other;
            number = -x;
            break;

        // BehaviorTree.CPP refuses what the opposite comparison accepts, so that comparisons with
        // NaN hold
        case CodeOp::less:
            if (!numbers(a(), b(), x, y)) goto other;
            answer = in->tree ? !(x >= y) : x < y;
            goto answered;
        case CodeOp::less_equal:
            if (!numbers(a(), b(), x, y)) goto other;
            answer = in->tree ? !(x > y) : x <= y;
            goto answered;
        case CodeOp::greater:
            if (!numbers(a(), b(), x, y)) goto other;
            answer = in->tree ? !(x <= y) : x > y;
            goto answered;
        case CodeOp::greater_equal:
            if (!numbers(a(), b(), x, y)) goto other;
            answer = in->tree ? !(x < y) : x >= y;
            goto answered;
        case CodeOp::equal:
            if (!numbers(a(), b(), x, y)) goto other;
            answer = in->tree ? std::fabs(x - y) <= tree_tolerance : x == y;
            goto answered;
        case CodeOp::not_equal:
            if (!numbers(a(), b(), x, y)) goto other;
            answer = in->tree ? !(std::fabs(x - y) <= tree_tolerance) : x != y;
            goto answered;

        case CodeOp::elapsed_count: number = context.row_memory[in->extra] * context.dt; break;
        case CodeOp::elapsed_since:
            number = (context.cycle - context.row_memory[in->extra]) * context.dt;
            break;
        case CodeOp::sensor_boolean: answer = host_value<bool>(context, in->extra); goto answered;
        case CodeOp::sensor_integer: number = host_value<std::int32_t>(context, in->extra); break;
        case CodeOp::sensor_real: number = host_value<double>(context, in->extra); break;
        case CodeOp::in_state:
        case CodeOp::in_named:
            if (!in_state(context, *in, answer)) goto failed;
            goto answered;

        case CodeOp::copy:
            if (a().is(Value::Kind::undefined) && reads_missing_variable(context, *in)) {
                fail(context, EvalErrorKind::missing, a(), Value());
                goto failed;
            }
            result = &a();
            goto delivered;
        case CodeOp::truth: answer = machine_condition(a()) == Truth::yes; goto answered;
        case CodeOp::defined: answer = !a().is(Value::Kind::undefined); goto answered;
        case CodeOp::jump: in = instructions + in->extra - 1; continue;
        case CodeOp::jump_if:
        case CodeOp::jump_unless: {
            const Truth truth = in->tree ? tree_ternary(a()) : machine_condition(a());
            if (truth == Truth::failed) {
                fail(context, EvalErrorKind::not_a_condition, a(), Value());
                goto failed;
            }
            if ((truth == Truth::yes) != (in->op == CodeOp::jump_if)) continue;
            if (in->last) return sink.value(a(), in->tree);  // 0, 1 or a boolean: never refused
            in = instructions + in->extra - 1;
            continue;
        }
        case CodeOp::fail: {
            fail(context, static_cast<EvalErrorKind>(in->extra), Value(), Value());
            goto failed;
        }

        case CodeOp::store: {
            Value& variable = context.slots[in->a.index()];
            variable = b();
            if (context.writes != nullptr) ++context.writes[in->a.index()];
            result = &variable;
            goto delivered;
        }
        case CodeOp::assign: {
            // a variable that holds a number exists; any other assignment is for other_operation()
            Value& variable = context.slots[in->a.index()];
            if (!variable.is_number() || !exact_number(b(), x)) goto other;
            if (variable.is(Value::Kind::real)) {
                variable.set_real(x);
            } else {
                const std::optional<std::int64_t> whole = truncated(x);
                if (!whole || static_cast<double>(*whole) != x) goto other;
                variable.set_integer(*whole);
            }
            if (context.writes != nullptr) ++context.writes[in->a.index()];
            result = &variable;
            goto delivered;
        }

        case CodeOp::remainder:
        case CodeOp::complement:
        case CodeOp::bit_and:
        case CodeOp::bit_or:
        case CodeOp::bit_xor:
        case CodeOp::concatenate:
        case CodeOp::logical_not:
        case CodeOp::logical_and:
        case CodeOp::logical_or:
        case CodeOp::declare:
        case CodeOp::require:
        case CodeOp::assign_add:
        case CodeOp::assign_subtract:
        case CodeOp::assign_multiply:
        case CodeOp::assign_divide:
        case CodeOp::store_at:
        case CodeOp::read_at:
        case CodeOp::make_array:
        case CodeOp::make_object:
        case CodeOp::call: goto other;
        }

        if (in->last) {
            if (sink.real(number, in->tree)) return true;
            fail(context, Sink::refusal, Value::real(number), Value());
            goto failed;
        }
        temporaries[in->target].set_real(number);
        continue;

    answered:
        if (in->last) return sink.boolean(answer, in->tree);
        if (in->tree)
            temporaries[in->target].set_real(answer ? 1 : 0);
        else
            temporaries[in->target].set_boolean(answer);
        continue;

    other:
        if (!other_operation(code, context, *in)) goto failed;
        if (!in->last) continue;
        result = &temporaries[in->target];

    delivered:
        if (!in->last) {
            temporaries[in->target] = *result;
            continue;
        }
        if (sink.value(*result, in->tree)) return true;
        fail(context, Sink::refusal, *result, Value());

    failed:
        context.error.instruction = static_cast<std::uint32_t>(in - instructions);
        const std::uint32_t handler = handler_of(code, context.error.instruction);
        if (handler == code.instructions.size()) return false;
        in = instructions + handler - 1;
    }
}

}  // namespace

bool evaluate(const CodeTable& code, CodeId id, EvalContext& context, Value& result) {
    ValueSink sink{result};
    return run(code, id, context, sink);
}

bool execute(const CodeTable& code, CodeId id, EvalContext& context) {
    NoSink sink;
    return run(code, id, context, sink);
}

Truth evaluate_condition(const CodeTable& code, CodeId id, EvalContext& context) {
    ConditionSink sink;
    return run(code, id, context, sink) ? sink.truth : Truth::failed;
}

bool evaluate_real(const CodeTable& code, CodeId id, EvalContext& context, double& result) {
    RealSink sink;
    if (!run(code, id, context, sink)) return false;
    result = sink.number;
    return true;
}

}  // namespace trellis
