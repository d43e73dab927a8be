// See reference_expressions.h. Every rule of the machine setting, one after the other, with no
// thought of speed.
// SPDX-License-Identifier: MIT
#include "support/reference_expressions.h"

#include "core/number.h"

#include <cmath>
#include <vector>

namespace trellis {
namespace {

using Kind = Value::Kind;

bool truth(const Value& v) {
    switch (v.kind()) {
    case Kind::undefined:
    case Kind::null: return false;
    case Kind::boolean: return v.as_boolean();
    case Kind::integer: return v.as_integer() != 0;
    case Kind::real: return v.as_real() != 0;
    case Kind::text: return !v.as_text().empty();
    default: return true;
    }
}

bool numeric(const Value& v) {
    return v.is(Kind::boolean) || v.is_number();
}

std::string text_of(const Value& v);

// inside arrays and objects: JSON without blanks, where undefined members do not exist
std::string json_of(const Value& v) {
    if (v.is(Kind::text)) return print(v);
    if (v.is(Kind::undefined)) return "null";
    return text_of(v);
}

std::string text_of(const Value& v) {
    std::string list;
    const auto separator = [&] { return list.size() > 1 ? "," : ""; };
    if (v.is(Kind::array)) {
        list += '[';
        for (const Value& e : v.elements())
            list.append(separator()).append(json_of(e));
        return list.append("]");
    }
    if (v.is(Kind::object)) {
        list += '{';
        for (const Member& m : v.members()) {
            if (m.value.is(Kind::undefined)) continue;
            list.append(separator())
                .append(print(Value::text(m.key)))
                .append(":")
                .append(json_of(m.value));
        }
        return list.append("}");
    }
    if (v.is(Kind::text)) return v.as_text();
    if (v.is(Kind::real)) {
        const double x = v.as_real();
        if (std::isfinite(x) && std::trunc(x) == x && std::fabs(x) < 1e15) {
            return std::to_string(static_cast<long long>(x));
        }
        return print_number(x);
    }
    return print(v);
}

bool equal(const Value& a, const Value& b, bool outermost) {
    if (numeric(a) && numeric(b)) return a.number() == b.number();
    if (outermost && numeric(a) && b.is(Kind::text)) return equal(b, a, true);
    if (outermost && a.is(Kind::text) && numeric(b)) {
        std::string t = a.as_text();
        while (!t.empty() && std::isspace(static_cast<unsigned char>(t.front())) != 0)
            t.erase(0, 1);
        while (!t.empty() && std::isspace(static_cast<unsigned char>(t.back())) != 0)
            t.pop_back();
        const ParsedNumber parsed = parse_whole_number(t);
        return parsed.length > 0 && parsed.value == b.number();
    }
    if (a.kind() != b.kind()) return false;
    if (a.is(Kind::array)) {
        bool same = a.elements().size() == b.elements().size();
        for (std::size_t i = 0; same && i < a.elements().size(); ++i)
            same = equal(a.element(i), b.element(i), false);
        return same;
    }
    if (a.is(Kind::object)) {
        bool same = a.members().size() == b.members().size();
        for (const Member& m : a.members()) {
            const Value* other = b.member(m.key);
            same = same && other != nullptr && equal(m.value, *other, false);
        }
        return same;
    }
    return a == b;
}

std::optional<double> whole_64(double x) {
    if (!(x >= -0x1p63 && x < 0x1p63)) return std::nullopt;
    return std::trunc(x);
}

std::optional<Value> arithmetic(CodeOp op, const Value& a, const Value& b) {
    if (op == CodeOp::concatenate) {
        for (const Value* v : {&a, &b}) {
            if (!numeric(*v) && !v->is(Kind::text)) return std::nullopt;
        }
        return Value::text(text_of(a) + text_of(b));
    }
    if (a.is(Kind::text) && b.is(Kind::text)) {
        const std::string& s = a.as_text();
        const std::string& t = b.as_text();
        if (op == CodeOp::add) return Value::text(s + t);
        if (op == CodeOp::less) return Value::boolean(s < t);
        if (op == CodeOp::less_equal) return Value::boolean(s <= t);
        if (op == CodeOp::greater) return Value::boolean(s > t);
        if (op == CodeOp::greater_equal) return Value::boolean(s >= t);
    }
    if (!numeric(a) || !numeric(b)) return std::nullopt;
    const double x = a.number();
    const double y = b.number();
    switch (op) {
    case CodeOp::add: return Value::real(x + y);
    case CodeOp::subtract: return Value::real(x - y);
    case CodeOp::multiply: return Value::real(x * y);
    case CodeOp::divide: return Value::real(x / y);
    case CodeOp::remainder: return Value::real(std::fmod(x, y));
    case CodeOp::less: return Value::boolean(x < y);
    case CodeOp::less_equal: return Value::boolean(x <= y);
    case CodeOp::greater: return Value::boolean(x > y);
    case CodeOp::greater_equal: return Value::boolean(x >= y);
    default: break;
    }
    if (!whole_64(x) || !whole_64(y)) return std::nullopt;
    const auto i = static_cast<std::int64_t>(*whole_64(x));
    const auto j = static_cast<std::int64_t>(*whole_64(y));
    const std::int64_t bits = op == CodeOp::bit_and ? i & j : op == CodeOp::bit_or ? i | j : i ^ j;
    return Value::real(static_cast<double>(bits));
}

// what is below a value that is not undefined; undefined if nothing
Value below(const Value& v, const Value& key) {
    if (v.is(Kind::object)) {
        const Value* member = v.member(text_of(key));
        return member != nullptr ? *member : Value();
    }
    if (v.is(Kind::array) && key.is_number()) {
        for (std::size_t i = 0; i < v.elements().size(); ++i) {
            if (static_cast<double>(i) == key.number()) return v.element(i);
        }
    }
    return Value();
}

}  // namespace

ReferenceEvaluator::Result ReferenceEvaluator::value(const Syntax& s, std::uint32_t n) {
    const SyntaxNode& node = s.nodes[n];
    const auto child = [&](std::uint32_t i) { return s.children[node.first + i]; };
    switch (node.kind) {
    case SyntaxKind::literal: return s.literals[node.index];
    case SyntaxKind::name: {
        const auto found = variables.find(s.names[node.index]);
        return found != variables.end() ? Result(found->second) : std::nullopt;
    }
    case SyntaxKind::path: return path(s, node);
    case SyntaxKind::unary: {
        const Result a = value(s, child(0));
        if (!a) return std::nullopt;
        if (node.op == CodeOp::logical_not) return Value::boolean(!truth(*a));
        if (!numeric(*a)) return std::nullopt;
        if (node.op == CodeOp::negate) return Value::real(-a->number());
        if (!whole_64(a->number())) return std::nullopt;
        return Value::real(static_cast<double>(~static_cast<std::int64_t>(a->number())));
    }
    case SyntaxKind::binary: return binary(s, node);
    case SyntaxKind::comparisons: return std::nullopt;  // trees only
    case SyntaxKind::conditional: {
        const Result condition = value(s, child(0));
        if (!condition) return std::nullopt;
        return value(s, child(truth(*condition) ? 1 : 2));
    }
    case SyntaxKind::assignment: return assignment(s, node);
    case SyntaxKind::call: return call(s, node);
    case SyntaxKind::array: {
        Value array = Value::array();
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const Result element = value(s, child(i));
            if (!element || !array.append(*element)) return std::nullopt;
        }
        return array;
    }
    case SyntaxKind::object: {
        Value object = Value::object();
        for (std::uint32_t i = 0; i < node.count; i += 2) {
            const Result member = value(s, child(i + 1));
            if (!member) return std::nullopt;
            if (!object.set_member(s.literals[s.nodes[child(i)].index].as_text(), *member))
                return std::nullopt;
        }
        return object;
    }
    case SyntaxKind::sequence: {
        Result last = Value();
        for (std::uint32_t i = 0; last && i < node.count; ++i)
            last = value(s, child(i));
        return last;
    }
    }
    return std::nullopt;
}

ReferenceEvaluator::Result ReferenceEvaluator::binary(const Syntax& s, const SyntaxNode& node) {
    const Result a = value(s, s.children[node.first]);
    if (!a) return std::nullopt;
    if (node.op == CodeOp::logical_and && !truth(*a)) return Value::boolean(false);
    if (node.op == CodeOp::logical_or && truth(*a)) return Value::boolean(true);
    const Result b = value(s, s.children[node.first + 1]);
    if (!b) return std::nullopt;
    switch (node.op) {
    case CodeOp::logical_and:
    case CodeOp::logical_or: return Value::boolean(truth(*b));
    case CodeOp::equal: return Value::boolean(equal(*a, *b, true));
    case CodeOp::not_equal: return Value::boolean(!equal(*a, *b, true));
    default: return arithmetic(node.op, *a, *b);
    }
}

ReferenceEvaluator::Result ReferenceEvaluator::path(const Syntax& s, const SyntaxNode& node) {
    Result at = value(s, s.children[node.first]);
    if (!at) return std::nullopt;
    std::vector<Value> keys;
    for (std::uint32_t i = 1; i < node.count; ++i) {
        const Result key = value(s, s.children[node.first + i]);
        if (!key) return std::nullopt;
        keys.push_back(*key);
    }
    for (const Value& key : keys) {
        if (at->is(Kind::undefined)) return std::nullopt;
        at = below(*at, key);
    }
    return at;
}

ReferenceEvaluator::Result ReferenceEvaluator::assignment(const Syntax& s, const SyntaxNode& node) {
    const std::uint32_t place = s.children[node.first];
    Result result = value(s, s.children[node.first + 1]);
    if (!result) return std::nullopt;
    if (node.op != CodeOp::declare && node.op != CodeOp::assign) {
        const Result old = value(s, place);
        if (!old) return std::nullopt;
        const CodeOp op = node.op == CodeOp::assign_add        ? CodeOp::add
                          : node.op == CodeOp::assign_subtract ? CodeOp::subtract
                          : node.op == CodeOp::assign_multiply ? CodeOp::multiply
                                                               : CodeOp::divide;
        result = arithmetic(op, *old, *result);
    }
    if (!result || !store(s, place, *result)) return std::nullopt;
    return result;
}

bool ReferenceEvaluator::store(const Syntax& s, std::uint32_t place, const Value& value_to_store) {
    const SyntaxNode& node = s.nodes[place];
    if (node.kind == SyntaxKind::name) {
        const auto found = variables.find(s.names[node.index]);
        if (found == variables.end()) return false;
        found->second = value_to_store;
        return true;
    }
    std::vector<Value> keys;
    const auto found = variables.find(s.names[s.nodes[s.children[node.first]].index]);
    if (found == variables.end()) return false;
    for (std::uint32_t i = 1; i < node.count; ++i) {
        const Result key = value(s, s.children[node.first + i]);
        if (!key) return false;
        keys.push_back(*key);
    }
    return found->second.set_at(keys, value_to_store);
}

ReferenceEvaluator::Result ReferenceEvaluator::call(const Syntax& s, const SyntaxNode& node) {
    const std::string& name = s.names[node.index];
    std::vector<Value> arguments;
    for (std::uint32_t i = 0; i < node.count; ++i) {
        const Result argument = value(s, s.children[node.first + i]);
        if (!argument && name == "isDefined") return Value::boolean(false);
        if (!argument) return std::nullopt;
        arguments.push_back(*argument);
    }
    const Value& first = arguments[0];
    if (name == "isDefined") return Value::boolean(!first.is(Kind::undefined));
    if (name == "str") return Value::text(text_of(first));
    if (name == "abs")
        return numeric(first) ? Result(Value::real(std::fabs(first.number()))) : std::nullopt;
    if (name == "max") {
        double largest = first.number();
        for (const Value& v : arguments) {
            if (!numeric(v)) return std::nullopt;
            if (v.number() > largest) largest = v.number();
        }
        return Value::real(largest);
    }
    if (name == "len" && first.is(Kind::text))
        return Value::real(static_cast<double>(first.as_text().size()));
    if (name == "len" && first.is(Kind::array))
        return Value::real(static_cast<double>(first.elements().size()));
    if (name == "len" && first.is(Kind::object))
        return Value::real(static_cast<double>(first.members().size()));
    return std::nullopt;
}

}  // namespace trellis
