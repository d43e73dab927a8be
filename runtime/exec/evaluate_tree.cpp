// The tree setting: BehaviorTree.CPP 4.10's scripting to the letter. Numbers are int64 or double;
// every operator but .. and the bitwise ones computes in doubles. What a variable accepts
// (EntryType and the value it holds):
// SPDX-License-Identifier: MIT

//   missing                  only := makes it `any`; reading or assigning otherwise fails
//   any, no value yet        takes any value
//   holds a number           takes numbers that its type holds without loss; a text is converted:
//   by
//                            the entry's type, or for `any` to a double, which it then is
//   holds a text             takes texts
//   typed, no value yet      takes numbers as they are; a text is converted by the entry's type
//
// Covered by tests/exec/scripts_test.cpp (the recorded cases) and tests/exec/evaluate_test.cpp
// (typed entries).
#include "core/number.h"
#include "exec/evaluate_rules.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace trellis {
namespace {

// the host's booleans are numbers here
bool is_number(const Value& v) {
    return v.is_number() || v.is(Value::Kind::boolean);
}

// a number as a double; an integer that a double does not hold exactly is an error
bool as_double(EvalContext& context, const Value& v, double& number) {
    if (exact_number(v, number)) return true;
    number = v.number();
    if (!v.is(Value::Kind::integer)) return true;
    const std::optional<std::int64_t> back = truncated(number);
    if (back && *back == v.as_integer()) return true;
    return fail(context, EvalErrorKind::inexact, v, Value());
}

// a number as an integer without loss
std::optional<std::int64_t> as_integer(const Value& v) {
    if (!v.is(Value::Kind::real)) return v.as_integer();
    const std::optional<std::int64_t> whole = truncated(v.as_real());
    return whole && static_cast<double>(*whole) == v.as_real() ? whole : std::nullopt;
}

// a text beside a number: true, false, the name of an enum constant, or what it begins with
bool text_as_double(const CodeTable& code, EvalContext& context, const Value& v, double& number) {
    const std::string& text = v.as_text();
    if (text == "true" || text == "false") {
        number = text == "true" ? 1 : 0;
        return true;
    }
    const auto e = std::lower_bound(
        code.enums.begin(), code.enums.end(), text,
        [](const EnumValue& value, const std::string& name) { return value.name < name; });
    if (e != code.enums.end() && e->name == text) {
        number = e->value;
        return true;
    }
    const ParsedNumber parsed = parse_number(text);
    number = parsed.value;
    if (parsed.length > 0 && !parsed.out_of_range) return true;
    return fail(context, EvalErrorKind::text_not_a_number, v, Value());
}

void append_as_text(std::string& out, const Value& v) {
    switch (v.kind()) {
    case Value::Kind::real: append_fixed(out, v.as_real()); return;
    case Value::Kind::text: out += v.as_text(); return;
    default: append_integer(out, v.as_integer()); return;
    }
}

// `target` may be one of the operands
bool concatenate(Value& target, const Value& a, const Value& b) {
    std::string joined;
    if (&target == &a || &target == &b || !target.is(Value::Kind::text)) {
        append_as_text(joined, a);
        append_as_text(joined, b);
        target.set_text(joined);
    } else {
        std::string& out = target.as_text();
        out.clear();
        append_as_text(out, a);
        append_as_text(out, b);
    }
    return true;
}

// as BehaviorTree.CPP compares: what the opposite operator accepts is refused
template <class T>
bool compare(CodeOp op, const T& x, const T& y, bool same) {
    switch (op) {
    case CodeOp::less: return !(x >= y);
    case CodeOp::less_equal: return !(x > y);
    case CodeOp::greater: return !(x <= y);
    case CodeOp::greater_equal: return !(x < y);
    case CodeOp::equal: return same;
    default: return !same;
    }
}

bool comparison(const CodeTable& code, EvalContext& context, CodeOp op, const Value& a,
                const Value& b, Value& target) {
    const bool a_text = a.is(Value::Kind::text);
    const bool b_text = b.is(Value::Kind::text);
    if ((!a_text && !is_number(a)) || (!b_text && !is_number(b))) {
        return fail(context, EvalErrorKind::operands, a, b);
    }
    bool holds = false;
    if (a_text && b_text) {
        holds = compare(op, a.as_text(), b.as_text(), a.as_text() == b.as_text());
    } else {
        double x = 0;
        double y = 0;
        if (!(a_text ? text_as_double(code, context, a, x) : as_double(context, a, x)))
            return false;
        if (!(b_text ? text_as_double(code, context, b, y) : as_double(context, b, y)))
            return false;
        holds = compare(op, x, y, std::fabs(x - y) <= tree_tolerance);
    }
    target.set_real(holds ? 1 : 0);
    return true;
}

double arithmetic(CodeOp op, double x, double y) {
    switch (op) {
    case CodeOp::add:
    case CodeOp::assign_add: return x + y;
    case CodeOp::subtract:
    case CodeOp::assign_subtract: return x - y;
    case CodeOp::multiply:
    case CodeOp::assign_multiply: return x * y;
    default: return x / y;
    }
}

bool binary(EvalContext& context, CodeOp op, const Value& a, const Value& b, Value& target) {
    const bool a_text = a.is(Value::Kind::text);
    const bool b_text = b.is(Value::Kind::text);
    const bool a_number = is_number(a);
    const bool b_number = is_number(b);
    if (a_text && b_text && (op == CodeOp::add || op == CodeOp::concatenate))
        return concatenate(target, a, b);
    if (op == CodeOp::concatenate && ((a_text && b_number) || (a_number && b_text)))
        return concatenate(target, a, b);
    if (!a_number || !b_number) return fail(context, EvalErrorKind::operands, a, b);

    // BehaviorTree.CPP converts first and looks at the operator then
    double x = 0;
    double y = 0;
    if (!as_double(context, a, x) || !as_double(context, b, y)) return false;
    switch (op) {
    case CodeOp::concatenate: target.set_undefined(); return true;
    case CodeOp::bit_and:
    case CodeOp::bit_or:
    case CodeOp::bit_xor: {
        const std::optional<std::int64_t> i = as_integer(a);
        const std::optional<std::int64_t> j = as_integer(b);
        if (!i || !j) return fail(context, EvalErrorKind::not_integral, a, b);
        const std::int64_t bits = op == CodeOp::bit_and  ? *i & *j
                                  : op == CodeOp::bit_or ? *i | *j
                                                         : *i ^ *j;
        target.set_real(static_cast<double>(bits));
        return true;
    }
    case CodeOp::logical_and:
    case CodeOp::logical_or: {
        const Truth i = tree_condition(a);
        const Truth j = tree_condition(b);
        if (i == Truth::failed || j == Truth::failed)
            return fail(context, EvalErrorKind::not_a_condition, a, b);
        const bool both = op == CodeOp::logical_and;
        const bool holds =
            both ? i == Truth::yes && j == Truth::yes : i == Truth::yes || j == Truth::yes;
        target.set_real(holds ? 1 : 0);
        return true;
    }
    default: target.set_real(arithmetic(op, x, y)); return true;
    }
}

bool unary(EvalContext& context, CodeOp op, const Value& a, Value& target) {
    if (!is_number(a)) return fail(context, EvalErrorKind::operands, a, a);
    double x = 0;
    if (!as_double(context, a, x)) return false;
    if (op == CodeOp::negate) {
        target.set_real(-x);
    } else if (op == CodeOp::absolute) {
        target.set_real(std::fabs(x));
    } else if (op == CodeOp::logical_not) {
        target.set_real(x != 0 ? 0 : 1);
    } else {
        const std::optional<std::int64_t> bits = truncated(x);
        if (!bits) return fail(context, EvalErrorKind::not_integral, a, a);
        target.set_real(static_cast<double>(~*bits));
    }
    return true;
}

// writes `v` without changing the type of what the variable holds
bool copy_into(EvalContext& context, EntryType type, const Value& v, Value& variable) {
    if (variable.is(Value::Kind::undefined) || variable.kind() == v.kind()) {
        variable = v;
        return true;
    }
    if (!is_number(v) || !is_number(variable))
        return fail(context, EvalErrorKind::type_fixed, variable, v);
    if (variable.is(Value::Kind::real)) {
        double x = 0;
        if (!as_double(context, v, x)) return false;
        variable.set_real(x);
        return true;
    }
    const std::optional<std::int64_t> whole = as_integer(v);
    if (!whole || (type == EntryType::unsigned_integer && *whole < 0)) {
        return fail(context, EvalErrorKind::type_fixed, variable, v);
    }
    variable.set_integer(*whole);
    return true;
}

bool assign(const CodeTable& code, EvalContext& context, EntryType type, const Value& v,
            Value& variable) {
    if (v.is(Value::Kind::text) && !variable.is(Value::Kind::text)) {
        if (type != EntryType::any) {
            return convert_text(type, v.as_text(), variable) ||
                   fail(context, EvalErrorKind::type_fixed, variable, v);
        }
        if (is_number(variable)) {
            double number = 0;
            if (!text_as_double(code, context, v, number)) return false;
            variable.set_real(number);
            return true;
        }
        if (!variable.is(Value::Kind::undefined))
            return fail(context, EvalErrorKind::type_fixed, variable, v);
    }
    return copy_into(context, type, v, variable);
}

bool assign_with(EvalContext& context, CodeOp op, EntryType type, const Value& v, Value& variable) {
    if (variable.is(Value::Kind::undefined))
        return fail(context, EvalErrorKind::empty, variable, v);
    if (is_number(v) && is_number(variable)) {
        double x = 0;
        double y = 0;
        if (!as_double(context, variable, x) || !as_double(context, v, y)) return false;
        return copy_into(context, type, Value::real(arithmetic(op, x, y)), variable);
    }
    if (op != CodeOp::assign_add || !v.is(Value::Kind::text) || !variable.is(Value::Kind::text)) {
        return fail(context, EvalErrorKind::operands, variable, v);
    }
    variable.as_text() += v.as_text();
    return true;
}

bool assignment(const CodeTable& code, EvalContext& context, const Instruction& in) {
    const std::uint32_t slot = in.a.index();
    Value& variable = context.slots[slot];
    const Value& v = value_at(context, in.b);
    const auto type = static_cast<EntryType>(context.entry_types[slot]);
    if (type == EntryType::missing) return fail(context, EvalErrorKind::missing, variable, v);
    if (v.is(Value::Kind::undefined)) return fail(context, EvalErrorKind::empty, variable, v);
    const bool done = in.op == CodeOp::assign ? assign(code, context, type, v, variable)
                                              : assign_with(context, in.op, type, v, variable);
    if (!done) return false;
    if (context.writes != nullptr) ++context.writes[slot];
    return true;
}

bool existence(EvalContext& context, const Instruction& in) {
    std::uint8_t& type = context.entry_types[in.a.index()];
    if (static_cast<EntryType>(type) != EntryType::missing) return true;
    if (in.op == CodeOp::require) return fail(context, EvalErrorKind::missing, Value(), Value());
    type = static_cast<std::uint8_t>(EntryType::any);
    return true;
}

}  // namespace

bool convert_text(EntryType type, std::string_view text, Value& out) {
    const char* const end = text.data() + text.size();
    switch (type) {
    case EntryType::boolean: {
        const bool yes = text == "1" || text == "true" || text == "True" || text == "TRUE";
        if (!yes && text != "0" && text != "false" && text != "False" && text != "FALSE") {
            return false;
        }
        out.set_integer(yes ? 1 : 0);
        return true;
    }
    case EntryType::integer:
    case EntryType::unsigned_integer: {
        std::int64_t value = 0;
        const auto [read, error] = std::from_chars(text.data(), end, value);
        if (error != std::errc() || (type == EntryType::unsigned_integer && value < 0)) {
            return false;
        }
        out.set_integer(value);
        return true;
    }
    case EntryType::real: {
        const ParsedNumber parsed = parse_number(text);
        if (parsed.length == 0 || parsed.out_of_range) { return false; }
        out.set_real(parsed.value);
        return true;
    }
    case EntryType::text: out.set_text(text); return true;
    case EntryType::missing:
    case EntryType::any: break;
    }
    return false;
}

bool tree_operation(const CodeTable& code, EvalContext& context, const Instruction& in) {
    const Value& a = value_at(context, in.a);
    const Value& b = value_at(context, in.b);
    Value& target = context.temporaries[in.target];
    switch (in.op) {
    case CodeOp::declare:
    case CodeOp::require: return existence(context, in);
    case CodeOp::assign:
    case CodeOp::assign_add:
    case CodeOp::assign_subtract:
    case CodeOp::assign_multiply:
    case CodeOp::assign_divide: return assignment(code, context, in);
    case CodeOp::negate:
    case CodeOp::absolute:
    case CodeOp::complement:
    case CodeOp::logical_not: return unary(context, in.op, a, target);
    case CodeOp::less:
    case CodeOp::less_equal:
    case CodeOp::greater:
    case CodeOp::greater_equal:
    case CodeOp::equal:
    case CodeOp::not_equal: return comparison(code, context, in.op, a, b, target);
    default: return binary(context, in.op, a, b, target);
    }
}

Truth tree_ternary(const Value& v) {
    if (v.is(Value::Kind::text)) {
        const ParsedNumber parsed = parse_number(v.as_text());
        if (parsed.length == 0 || parsed.out_of_range) return Truth::failed;
        return parsed.value != 0 ? Truth::yes : Truth::no;
    }
    if (!is_number(v)) return Truth::failed;
    return v.number() != 0 ? Truth::yes : Truth::no;
}

Truth tree_condition(const Value& v) {
    if (v.is(Value::Kind::real)) {
        if (v.as_real() < 0) return Truth::failed;
        return v.as_real() != 0 ? Truth::yes : Truth::no;
    }
    if (!is_number(v) || v.as_integer() < 0 || v.as_integer() > 1) return Truth::failed;
    return v.as_integer() == 1 ? Truth::yes : Truth::no;
}

}  // namespace trellis
