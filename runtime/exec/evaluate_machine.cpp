// The machine setting: dynamic types, truth as statechart authors know it, exact equality. Booleans
// count as 0 and 1 in arithmetic; texts join with + and compare by their bytes. Covered by
// tests/exec/evaluate_test.cpp, against a slow reference over the syntax tree.
// SPDX-License-Identifier: MIT
#include "core/number.h"
#include "exec/evaluate_rules.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace trellis {
namespace {

bool is_number(const Value& v) {
    return v.is_number() || v.is(Value::Kind::boolean);
}

bool is_scalar_text(const Value& v) {
    return is_number(v) || v.is(Value::Kind::text);
}

bool compare(CodeOp op, auto&& x, auto&& y) {
    switch (op) {
    case CodeOp::less: return x < y;
    case CodeOp::less_equal: return x <= y;
    case CodeOp::greater: return x > y;
    default: return x >= y;
    }
}

bool is_order(CodeOp op) {
    return op >= CodeOp::less && op <= CodeOp::greater_equal;
}

// `target` may be one of the operands
bool joined(Value& target, const Value& a, const Value& b) {
    std::string text;
    if (&target == &a || &target == &b || !target.is(Value::Kind::text)) {
        append_text(text, a);
        append_text(text, b);
        target.set_text(text);
    } else {
        std::string& out = target.as_text();
        out.clear();
        append_text(out, a);
        append_text(out, b);
    }
    return true;
}

bool bitwise(EvalContext& context, CodeOp op, const Value& a, const Value& b, Value& target) {
    const std::optional<std::int64_t> i = truncated(a.number());
    const std::optional<std::int64_t> j = truncated(b.number());
    if (!i || !j) return fail(context, EvalErrorKind::not_integral, a, b);
    const std::int64_t bits = op == CodeOp::bit_and  ? *i & *j
                              : op == CodeOp::bit_or ? *i | *j
                                                     : *i ^ *j;
    target.set_real(static_cast<double>(bits));
    return true;
}

bool binary(EvalContext& context, CodeOp op, const Value& a, const Value& b, Value& target) {
    if (op == CodeOp::concatenate) {
        if (!is_scalar_text(a) || !is_scalar_text(b))
            return fail(context, EvalErrorKind::operands, a, b);
        return joined(target, a, b);
    }
    if (a.is(Value::Kind::text) && b.is(Value::Kind::text)) {
        if (op == CodeOp::add) return joined(target, a, b);
        if (is_order(op)) return target.set_boolean(compare(op, a.as_text(), b.as_text())), true;
    }
    if (!is_number(a) || !is_number(b)) return fail(context, EvalErrorKind::operands, a, b);
    const double x = a.number();
    const double y = b.number();
    switch (op) {
    case CodeOp::add: target.set_real(x + y); return true;
    case CodeOp::subtract: target.set_real(x - y); return true;
    case CodeOp::multiply: target.set_real(x * y); return true;
    case CodeOp::divide: target.set_real(x / y); return true;
    case CodeOp::remainder: target.set_real(std::fmod(x, y)); return true;
    case CodeOp::bit_and:
    case CodeOp::bit_or:
    case CodeOp::bit_xor: return bitwise(context, op, a, b, target);
    default: target.set_boolean(compare(op, x, y)); return true;
    }
}

// as equal, but inside arrays and objects a text never equals a number
bool equal_content(const Value& a, const Value& b) {
    if (is_number(a) && is_number(b)) return a.number() == b.number();
    if (a.kind() != b.kind()) return false;
    switch (a.kind()) {
    case Value::Kind::array: {
        if (a.elements().size() != b.elements().size()) return false;
        for (std::size_t i = 0; i < a.elements().size(); ++i) {
            if (!equal_content(a.element(i), b.element(i))) return false;
        }
        return true;
    }
    case Value::Kind::object: {
        if (a.members().size() != b.members().size()) return false;
        for (const Member& m : a.members()) {
            const Value* other = b.member(m.key);
            if (other == nullptr || !equal_content(m.value, *other)) return false;
        }
        return true;
    }
    default: return a == b;
    }
}

// arrays and objects as JSON, without blanks; members that are undefined do not exist, elements
// that are become null
void append_json(std::string& out, const Value& v) {
    const char* separator = "";
    switch (v.kind()) {
    case Value::Kind::array:
        out += '[';
        for (const Value& element : v.elements()) {
            out += std::exchange(separator, ",");
            append_json(out, element);
        }
        out += ']';
        return;
    case Value::Kind::object:
        out += '{';
        for (const Member& m : v.members()) {
            if (m.value.is(Value::Kind::undefined)) continue;
            out += std::exchange(separator, ",");
            out += print(Value::text(m.key));
            out += ':';
            append_json(out, m.value);
        }
        out += '}';
        return;
    case Value::Kind::undefined: out += "null"; return;
    case Value::Kind::text: out += print(v); return;
    default: append_text(out, v); return;
    }
}

// does `text` spell exactly this number? Blanks around it do not matter.
bool spells(std::string_view text, double number) {
    constexpr std::string_view blanks = " \t\n\r\v\f";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return false;
    text = text.substr(first, text.find_last_not_of(blanks) + 1 - first);
    const ParsedNumber parsed = parse_whole_number(text);
    return parsed.length > 0 && parsed.value == number;
}

}  // namespace

bool machine_operation(EvalContext& context, const Instruction& in) {
    const Value& a = value_at(context, in.a);
    Value& target = context.temporaries[in.target];
    switch (in.op) {
    case CodeOp::logical_not: target.set_boolean(machine_condition(a) == Truth::no); return true;
    case CodeOp::negate:
        if (!is_number(a)) return fail(context, EvalErrorKind::operands, a, a);
        target.set_real(-a.number());
        return true;
    case CodeOp::absolute:
        if (!is_number(a)) return fail(context, EvalErrorKind::operands, a, a);
        target.set_real(std::fabs(a.number()));
        return true;
    case CodeOp::complement: {
        const std::optional<std::int64_t> bits =
            is_number(a) ? truncated(a.number()) : std::nullopt;
        if (!is_number(a)) return fail(context, EvalErrorKind::operands, a, a);
        if (!bits) return fail(context, EvalErrorKind::not_integral, a, a);
        target.set_real(static_cast<double>(~*bits));
        return true;
    }
    case CodeOp::equal: target.set_boolean(machine_equal(a, value_at(context, in.b))); return true;
    case CodeOp::not_equal:
        target.set_boolean(!machine_equal(a, value_at(context, in.b)));
        return true;
    default: return binary(context, in.op, a, value_at(context, in.b), target);
    }
}

bool machine_equal(const Value& a, const Value& b) {
    if (a.is(Value::Kind::text) && is_number(b)) return spells(a.as_text(), b.number());
    if (is_number(a) && b.is(Value::Kind::text)) return spells(b.as_text(), a.number());
    return equal_content(a, b);
}

Truth machine_condition(const Value& v) {
    switch (v.kind()) {
    case Value::Kind::undefined:
    case Value::Kind::null: return Truth::no;
    case Value::Kind::boolean:
    case Value::Kind::integer: return v.as_integer() != 0 ? Truth::yes : Truth::no;
    case Value::Kind::real: return v.as_real() != 0 ? Truth::yes : Truth::no;
    case Value::Kind::text: return v.as_text().empty() ? Truth::no : Truth::yes;
    case Value::Kind::array:
    case Value::Kind::object: break;
    }
    return Truth::yes;
}

void append_text(std::string& out, const Value& v) {
    switch (v.kind()) {
    case Value::Kind::text: out += v.as_text(); return;
    case Value::Kind::real: {
        // whole numbers are written without a point, as their authors wrote them
        const double x = v.as_real();
        if (std::floor(x) == x && std::fabs(x) < 1e15) {
            append_integer(out, static_cast<std::int64_t>(x));
        } else {
            append_number(out, x);
        }
        return;
    }
    case Value::Kind::integer: append_integer(out, v.as_integer()); return;
    case Value::Kind::array:
    case Value::Kind::object: append_json(out, v); return;
    case Value::Kind::undefined:
    case Value::Kind::null:
    case Value::Kind::boolean: out += print(v); return;
    }
}

void append_integer(std::string& out, std::int64_t number) {
    std::array<char, 24> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    out.append(digits.data(), end);
}

}  // namespace trellis
