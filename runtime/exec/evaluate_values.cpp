// Arrays, objects, places in them, and the functions of core/functions.def. Both settings share
// them; what answers a question is true or false in machines and 1.0 or 0.0 in trees. Covered by
// tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#include "exec/evaluate_rules.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

namespace trellis {
namespace {

std::span<const Value> values_from(const EvalContext& context, Operand first, std::uint32_t count) {
    if (count == 0) return {};
    return {&value_at(context, first), count};
}

void set_answer(Value& target, bool answer, bool tree) {
    if (tree)
        target.set_real(answer ? 1 : 0);
    else
        target.set_boolean(answer);
}

// members that are missing are undefined, but undefined itself has no members
bool read_at(EvalContext& context, const Instruction& in, Value& target) {
    const Value* at = &value_at(context, in.a);
    for (const Value& key : values_from(context, in.b, in.extra)) {
        if (at->is(Value::Kind::undefined))
            return fail(context, EvalErrorKind::no_such_place, *at, key);
        const Value* next = nullptr;
        if (at->is(Value::Kind::object) && !key.is(Value::Kind::text)) {
            std::string name;
            append_text(name, key);
            next = at->member(name);
        } else {
            next = at->child(key);
        }
        at = next != nullptr ? next : &value_at(context, no_operand);
    }
    target = *at;
    return true;
}

bool store_at(EvalContext& context, const Instruction& in, const Value& value) {
    Value& variable = context.slots[in.a.index()];
    const std::span<const Value> keys = values_from(context, in.b, in.extra);
    if (!variable.set_at(keys, value)) {
        const bool deep = value.depth() + keys.size() > Value::max_depth;
        const EvalErrorKind kind =
            deep ? EvalErrorKind::nested_too_deeply : EvalErrorKind::no_such_place;
        return fail(context, kind, variable, keys.back());
    }
    if (context.writes != nullptr) ++context.writes[in.a.index()];
    return true;
}

bool make_array(EvalContext& context, std::span<const Value> elements, Value& target) {
    Value array = Value::array();
    for (const Value& v : elements) {
        if (!array.append(v)) return fail(context, EvalErrorKind::nested_too_deeply, v, v);
    }
    target = std::move(array);
    return true;
}

bool make_object(EvalContext& context, std::span<const Value> members, Value& target) {
    Value object = Value::object();
    for (std::size_t i = 0; i + 1 < members.size(); i += 2) {
        if (!object.set_member(members[i].as_text(), members[i + 1])) {
            return fail(context, EvalErrorKind::nested_too_deeply, members[i + 1], members[i + 1]);
        }
    }
    target = std::move(object);
    return true;
}

// ---- functions ----

bool is_numeric(const Value& v) {
    return v.is_number() || v.is(Value::Kind::boolean);
}

// the functions of one and two numbers; `f` is one of them
double number_function(Function f, double x, double y) {
    switch (f) {
    case Function::sqrt: return std::sqrt(x);
    case Function::sin: return std::sin(x);
    case Function::cos: return std::cos(x);
    case Function::tan: return std::tan(x);
    case Function::atan2: return std::atan2(x, y);
    case Function::floor: return std::floor(x);
    case Function::ceil: return std::ceil(x);
    case Function::round: return std::round(x);
    case Function::pow: return std::pow(x, y);
    case Function::exp: return std::exp(x);
    case Function::log: return std::log(x);
    default: return 0;
    }
}

bool random_number(EvalContext& context, Function f, double x, double y, Value& target) {
    if (context.random == nullptr) return fail(context, EvalErrorKind::no_random, Value(), Value());
    Random& random = *context.random;
    if (f == Function::uniform) {
        target.set_real(random.uniform(x, y));
    } else if (f == Function::gauss) {
        target.set_real(random.gauss(x, y));
    } else {
        const std::optional<std::int64_t> low = truncated(x);
        const std::optional<std::int64_t> high = truncated(y);
        if (!low || !high)
            return fail(context, EvalErrorKind::not_integral, Value::real(x), Value::real(y));
        target.set_real(static_cast<double>(random.whole(*low, *high)));
    }
    return true;
}

bool extreme(EvalContext& context, Function f, std::span<const Value> arguments, Value& target) {
    double result = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Value& v = arguments[i];
        if (!is_numeric(v)) return fail(context, EvalErrorKind::operands, v, v);
        // the first of equal ones stays, as in Python
        const double x = v.number();
        if (i == 0 || (f == Function::min ? x < result : x > result)) result = x;
    }
    target.set_real(result);
    return true;
}

// characters of UTF-8: bytes that continue none
double text_length(std::string_view text) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    return static_cast<double>(std::count_if(text.begin(), text.end(), begins));
}

bool length(EvalContext& context, const Value& v, Value& target) {
    switch (v.kind()) {
    case Value::Kind::text: target.set_real(text_length(v.as_text())); return true;
    case Value::Kind::array: target.set_real(static_cast<double>(v.elements().size())); return true;
    case Value::Kind::object: target.set_real(static_cast<double>(v.members().size())); return true;
    default: return fail(context, EvalErrorKind::operands, v, v);
    }
}

bool append(EvalContext& context, std::span<const Value> arguments, Value& target) {
    if (!arguments[0].is(Value::Kind::array))
        return fail(context, EvalErrorKind::operands, arguments[0], Value());
    Value array = arguments[0];
    for (const Value& v : arguments.subspan(1)) {
        if (!array.append(v)) return fail(context, EvalErrorKind::nested_too_deeply, v, v);
    }
    target = std::move(array);
    return true;
}

std::string_view type_name(const Value& v) {
    switch (v.kind()) {
    case Value::Kind::integer:
    case Value::Kind::real: return "number";
    case Value::Kind::text: return "string";
    default: return name_of(v.kind());
    }
}

}  // namespace

bool structure_operation(EvalContext& context, const Instruction& in) {
    Value& target = context.temporaries[in.target];
    switch (in.op) {
    case CodeOp::read_at: return read_at(context, in, target);
    case CodeOp::store_at: return store_at(context, in, target);
    case CodeOp::make_array:
        return make_array(context, values_from(context, in.a, in.extra), target);
    default: return make_object(context, values_from(context, in.a, in.extra), target);
    }
}

bool call_function(EvalContext& context, const Instruction& in) {
    const std::span<const Value> arguments = values_from(context, in.a, in.extra);
    Value& target = context.temporaries[in.target];
    const Value& first = arguments[0];
    const Value& second = arguments[arguments.size() > 1 ? 1 : 0];
    const auto f = static_cast<Function>(in.b.index());
    switch (f) {
    case Function::sqrt:
    case Function::sin:
    case Function::cos:
    case Function::tan:
    case Function::atan2:
    case Function::floor:
    case Function::ceil:
    case Function::round:
    case Function::pow:
    case Function::exp:
    case Function::log:
        if (!is_numeric(first) || !is_numeric(second))
            return fail(context, EvalErrorKind::operands, first, second);
        target.set_real(number_function(f, first.number(), second.number()));
        return true;
    case Function::min:
    case Function::max: return extreme(context, f, arguments, target);
    case Function::uniform:
    case Function::gauss:
    case Function::randint:
        if (!is_numeric(first) || !is_numeric(second))
            return fail(context, EvalErrorKind::operands, first, second);
        return random_number(context, f, first.number(), second.number(), target);
    case Function::len: return length(context, first, target);
    case Function::has: {
        if (!first.is(Value::Kind::object))
            return fail(context, EvalErrorKind::operands, first, second);
        const bool member =
            second.is(Value::Kind::text) && first.member(second.as_text()) != nullptr;
        set_answer(target, member, in.tree);
        return true;
    }
    case Function::append: return append(context, arguments, target);
    case Function::startsWith:
        if (!first.is(Value::Kind::text) || !second.is(Value::Kind::text)) {
            return fail(context, EvalErrorKind::operands, first, second);
        }
        set_answer(target, first.as_text().starts_with(second.as_text()), in.tree);
        return true;
    case Function::str: {
        std::string text;
        append_text(text, first);
        target.set_text(text);
        return true;
    }
    case Function::type: target.set_text(type_name(first)); return true;
    }
    return false;
}

}  // namespace trellis
