// One pass over the syntax, children before their parents, temporaries used like a stack. An
// operand is used where it lies (a constant, a variable, a temporary); it is copied first only
// where an assignment to its right could change it. Code only jumps forward. Covered by
// tests/load/expression_test.cpp and tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/emit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace trellis {
namespace {

constexpr std::uint32_t most_temporaries = 0xFFFF;
constexpr std::uint32_t first_temporary = accumulator_operand.index() + 1;
static_assert(stored_temporary == first_temporary);

// what BehaviorTree.CPP computes in doubles anyway: a whole number that a double holds exactly
bool is_exact(const Value& v) {
    constexpr std::int64_t limit = std::int64_t{1} << 53;
    return v.is(Value::Kind::real) ||
           (v.is(Value::Kind::integer) && v.as_integer() >= -limit && v.as_integer() <= limit);
}

std::optional<double> folded(CodeOp op, double a, double b) {
    switch (op) {
    case CodeOp::add: return a + b;
    case CodeOp::subtract: return a - b;
    case CodeOp::multiply: return a * b;
    case CodeOp::divide: return a / b;
    case CodeOp::negate: return -a;
    default: return std::nullopt;
    }
}

// the operators that take their operands as doubles, whatever numbers they are
bool takes_doubles(CodeOp op) {
    return op <= CodeOp::negate || (op >= CodeOp::less && op <= CodeOp::not_equal);
}

CodeOp arithmetic_of(CodeOp assignment) {
    switch (assignment) {
    case CodeOp::assign_add: return CodeOp::add;
    case CodeOp::assign_subtract: return CodeOp::subtract;
    case CodeOp::assign_multiply: return CodeOp::multiply;
    default: return CodeOp::divide;
    }
}

bool is_compound(CodeOp assignment) {
    return assignment != CodeOp::declare && assignment != CodeOp::assign;
}

class Emitter {
public:
    Emitter(const Syntax& syntax, Names& names, CodeTable& code, std::vector<EmitError>& errors)
        : syntax_(syntax), names_(names), code_(code), errors_(errors),
          faults_before_(errors.size()), first_constant_(code.constants.size()),
          begin_(position()) {
        // no_operand
        if (code.constants.empty()) code.constants.emplace_back();
    }

    CodeId whole() {
        const CodeId id{position()};
        const std::uint32_t result = temporary();
        if (node(syntax_.root).kind == SyntaxKind::sequence) {
            sequence(syntax_.root, result);
        } else {
            into(syntax_.root, result, true);
        }
        return finished(id);
    }

    CodeId store() {
        const CodeId id{position()};
        const std::uint32_t value = temporary();
        write(syntax_.root, Operand(Space::temporary, value), value, true);
        return finished(id);
    }

private:
    const SyntaxNode& node(std::uint32_t n) const { return syntax_.nodes[n]; }
    std::uint32_t child(std::uint32_t n, std::uint32_t i) const {
        return syntax_.children[node(n).first + i];
    }
    bool tree() const { return syntax_.dialect == Dialect::tree; }
    std::uint32_t position() const { return static_cast<std::uint32_t>(code_.instructions.size()); }

    CodeId finished(CodeId id) const { return errors_.size() == faults_before_ ? id : CodeId(); }

    void report(std::uint32_t n, std::string message) {
        errors_.push_back({.offset = node(n).offset, .message = std::move(message)});
    }

    std::uint32_t temporary() {
        const std::uint32_t t = next_temporary_++;
        if (t == most_temporaries) {
            report(syntax_.root, "the expression has too many parts");
            next_temporary_ = first_temporary;
            return first_temporary;
        }
        code_.temporaries = std::max(code_.temporaries, t + 1);
        return t;
    }

    // ---- single instructions ----

    std::uint32_t add(std::uint32_t n, Instruction in) {
        in.tree = tree();
        if (reads_number(in) && !read_again_) {
            in.a = accumulated(in.a);
            in.b = accumulated(in.b);
        }
        code_.instructions.push_back(in);
        code_.offsets.push_back(node(n).offset);
        return position() - 1;
    }

    // the operations that take numbers, or at least compute with them where they get them
    static bool reads_number(const Instruction& in) {
        return in.op <= CodeOp::absolute || (in.op >= CodeOp::less && in.op <= CodeOp::not_equal) ||
               in.op == CodeOp::assign || in.op == CodeOp::store;
    }

    // Gives the previous instruction the accumulator as its target, if that is where `operand`
    // comes from and it can only be a number.
    Operand accumulated(Operand operand) {
        if (operand.space() != Space::temporary || position() == landed_at_ || position() == begin_)
            return operand;
        Instruction& previous = code_.instructions.back();
        if (previous.target != operand.index() || !gives_number(previous)) return operand;
        previous.target = static_cast<std::uint16_t>(accumulator_operand.index());
        return accumulator_operand;
    }

    bool gives_number(const Instruction& in) const {
        switch (in.op) {
        case CodeOp::subtract:
        case CodeOp::multiply:
        case CodeOp::divide:
        case CodeOp::negate:
        case CodeOp::absolute:
        case CodeOp::sensor_integer:
        case CodeOp::sensor_real:
        case CodeOp::elapsed_count:
        case CodeOp::elapsed_since: return true;
        case CodeOp::add: return is_number(in.a) || is_number(in.b);  // else it may join texts
        default: return false;
        }
    }

    bool is_number(Operand operand) const {
        const Value* v = constant_at(operand);
        return operand == accumulator_operand || (v != nullptr && v->is_number());
    }

    struct Parts {
        Operand a = {};
        Operand b = {};
        std::uint32_t extra = 0;
    };

    std::uint32_t add(std::uint32_t n, CodeOp op, std::uint32_t target, bool last, Parts parts) {
        return add(n, {.op = op,
                       .last = last,
                       .tree = false,
                       .target = static_cast<std::uint16_t>(target),
                       .a = parts.a,
                       .b = parts.b,
                       .extra = parts.extra});
    }

    void land(std::uint32_t jump) {
        code_.instructions[jump].extra = position();
        landed_at_ = position();
    }

    void fail(std::uint32_t n, EvalErrorKind kind, std::string_view name) {
        add(n, CodeOp::fail, 0, false,
            {.a = constant(Value::text(name)), .extra = static_cast<std::uint32_t>(kind)});
    }

    Operand constant(Value value) {
        // an expression has few constants; those of others are not searched
        std::vector<Value>& constants = code_.constants;
        const std::size_t nearby = constants.size() > 16 ? constants.size() - 16 : 0;
        for (std::size_t i = std::max(first_constant_, nearby); i < constants.size(); ++i) {
            if (constants[i] == value)
                return Operand(Space::constant, static_cast<std::uint32_t>(i));
        }
        constants.push_back(std::move(value));
        return Operand(Space::constant, static_cast<std::uint32_t>(constants.size() - 1));
    }

    const Value* constant_at(Operand operand) const {
        return operand.space() == Space::constant ? &code_.constants[operand.index()] : nullptr;
    }

    // ---- values ----

    // where the value of `n` lies; code that computes it if it does not lie anywhere yet
    Operand value(std::uint32_t n) {
        const SyntaxNode& it = node(n);
        if (it.kind == SyntaxKind::literal) return constant(syntax_.literals[it.index]);
        if (it.kind == SyntaxKind::name) {
            Meaning meaning = variable(n, Use::read);
            if (meaning.kind == Meaning::Kind::slot ||
                meaning.kind == Meaning::Kind::read_only_slot) {
                return Operand(Space::slot, meaning.index);
            }
            if (meaning.kind == Meaning::Kind::constant) return constant(std::move(meaning.value));
            const std::uint32_t t = temporary();
            read(n, meaning, syntax_.names[it.index], t, false);
            return Operand(Space::temporary, t);
        }
        if (std::optional<double> number = fold(n)) return constant(Value::real(*number));
        const std::uint32_t t = temporary();
        into(n, t, false);
        return Operand(Space::temporary, t);
    }

    // the same, safe from assignments in code that follows
    Operand stable_value(std::uint32_t n, bool assigned_later) {
        const Operand operand = value(n);
        if (!assigned_later || operand.space() != Space::slot) return operand;
        const std::uint32_t t = temporary();
        add(n, CodeOp::copy, t, false, {.a = operand});
        return Operand(Space::temporary, t);
    }

    // a number that the syntax alone determines, exactly as evaluation would compute it
    std::optional<double> fold(std::uint32_t n) const {
        const SyntaxNode& it = node(n);
        if (it.kind == SyntaxKind::literal) {
            const Value& v = syntax_.literals[it.index];
            return is_exact(v) ? std::optional(v.number()) : std::nullopt;
        }
        if (it.kind != SyntaxKind::unary && it.kind != SyntaxKind::binary) return std::nullopt;
        if (!folded(it.op, 1, 1)) return std::nullopt;
        const std::optional<double> a = fold(child(n, 0));
        const std::optional<double> b = it.count > 1 ? fold(child(n, 1)) : 0.0;
        return a && b ? folded(it.op, *a, *b) : std::nullopt;
    }

    // integers among the constants become what the operator makes of them
    Operand as_double(CodeOp op, Operand operand) {
        const Value* v = constant_at(operand);
        if (v == nullptr || !v->is(Value::Kind::integer) || !is_exact(*v) || !takes_doubles(op))
            return operand;
        return constant(Value::real(v->number()));
    }

    // code that puts the value of `n` into temporary `t`; `last`: and ends the expression
    void into(std::uint32_t n, std::uint32_t t, bool last) {
        const std::uint32_t mark = next_temporary_;
        const SyntaxNode& it = node(n);
        switch (it.kind) {
        case SyntaxKind::literal: add(n, CodeOp::copy, t, last, {.a = value(n)}); break;
        case SyntaxKind::name:
            read(n, variable(n, Use::read), syntax_.names[it.index], t, last);
            break;
        case SyntaxKind::path: path(n, t, last); break;
        case SyntaxKind::unary:
        case SyntaxKind::binary: operation(n, t, last); break;
        case SyntaxKind::comparisons: comparisons(n, t, last); break;
        case SyntaxKind::conditional: conditional(n, t, last); break;
        case SyntaxKind::assignment: assignment(n, t, last); break;
        case SyntaxKind::call: call(n, t, last); break;
        case SyntaxKind::array:
        case SyntaxKind::object: {
            const CodeOp op =
                it.kind == SyntaxKind::array ? CodeOp::make_array : CodeOp::make_object;
            add(n, op, t, last, {.a = run(syntax_.children_of(it)), .extra = it.count});
            break;
        }
        case SyntaxKind::sequence: break;  // only at the root: whole()
        }
        next_temporary_ = mark;
    }

    void sequence(std::uint32_t n, std::uint32_t result) {
        const SyntaxNode& it = node(n);
        if (it.count == 0) add(n, CodeOp::copy, result, true, {.a = constant(Value())});
        for (std::uint32_t i = 0; i < it.count; ++i)
            into(child(n, i), result, i + 1 == it.count);
    }

    Meaning variable(std::uint32_t n, Use use) {
        const std::string& name = syntax_.names[node(n).index];
        Meaning meaning = names_.variable(name, use);
        if (meaning.kind == Meaning::Kind::undeclared && use == Use::read && name == "pi") {
            return {.kind = Meaning::Kind::constant, .value = Value::real(std::numbers::pi)};
        }
        return meaning;
    }

    // what `meaning` stands for, into `t`
    void read(std::uint32_t n, const Meaning& meaning, std::string_view name, std::uint32_t t,
              bool last) {
        const auto at_index = [&](CodeOp op) { add(n, op, t, last, {.extra = meaning.index}); };
        switch (meaning.kind) {
        case Meaning::Kind::slot:
        case Meaning::Kind::read_only_slot:
            add(n, CodeOp::copy, t, last, {.a = Operand(Space::slot, meaning.index)});
            break;
        case Meaning::Kind::constant:
            add(n, CodeOp::copy, t, last, {.a = constant(meaning.value)});
            break;
        case Meaning::Kind::sensor_boolean: at_index(CodeOp::sensor_boolean); break;
        case Meaning::Kind::sensor_integer: at_index(CodeOp::sensor_integer); break;
        case Meaning::Kind::sensor_real: at_index(CodeOp::sensor_real); break;
        case Meaning::Kind::elapsed_count: at_index(CodeOp::elapsed_count); break;
        case Meaning::Kind::elapsed_since: at_index(CodeOp::elapsed_since); break;
        case Meaning::Kind::state: at_index(CodeOp::in_state); break;
        case Meaning::Kind::undeclared: fail(n, EvalErrorKind::undeclared, name); break;
        case Meaning::Kind::error: report(n, meaning.message); break;
        }
    }

    void path(std::uint32_t n, std::uint32_t t, bool last) {
        std::span<const std::uint32_t> parts = syntax_.children_of(node(n));
        Operand base;
        std::optional<Meaning> sensor = sensor_of(n);
        if (sensor && parts.size() == 2) {
            return read(n, *sensor, syntax_.literals[node(parts[1]).index].as_text(), t, last);
        }
        if (sensor) {
            // below a sensor there is nothing, but that is for the evaluation to say
            const std::uint32_t below = temporary();
            read(n, *sensor, syntax_.literals[node(parts[1]).index].as_text(), below, false);
            base = Operand(Space::temporary, below);
            parts = parts.subspan(1);
        } else {
            const bool keys_assign =
                std::any_of(parts.begin() + 1, parts.end(),
                            [&](std::uint32_t key) { return node(key).assigns; });
            base = stable_value(parts[0], keys_assign);
        }
        const auto count = static_cast<std::uint32_t>(parts.size() - 1);
        add(n, CodeOp::read_at, t, last, {.a = base, .b = run(parts.subspan(1)), .extra = count});
    }

    // of _x.NAME and _x['NAME']
    std::optional<Meaning> sensor_of(std::uint32_t n) {
        const SyntaxNode& base = node(child(n, 0));
        const SyntaxNode& key = node(child(n, 1));
        if (base.kind != SyntaxKind::name || syntax_.names[base.index] != "_x") return std::nullopt;
        if (key.kind != SyntaxKind::literal || !syntax_.literals[key.index].is(Value::Kind::text))
            return std::nullopt;
        Meaning meaning = names_.sensor(syntax_.literals[key.index].as_text());
        if (meaning.kind == Meaning::Kind::undeclared) return std::nullopt;
        return meaning;
    }

    // the values of `nodes` beside each other: constants if all of them are, else temporaries; the
    // first one's place
    Operand run(std::span<const std::uint32_t> nodes) {
        if (nodes.empty()) return {};
        if (nodes.size() == 1) return value(nodes[0]);
        const bool literals = std::all_of(nodes.begin(), nodes.end(), [&](std::uint32_t n) {
            return node(n).kind == SyntaxKind::literal;
        });
        if (literals) {
            const Operand first(Space::constant,
                                static_cast<std::uint32_t>(code_.constants.size()));
            for (std::uint32_t n : nodes)
                code_.constants.push_back(syntax_.literals[node(n).index]);
            return first;
        }
        const std::uint32_t first = next_temporary_;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            temporary();
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            const std::uint32_t mark = next_temporary_;
            into_whole(nodes[i], first + i);
            next_temporary_ = mark;
        }
        return Operand(Space::temporary, first);
    }

    // into(), by way of a constant if the value is known
    void into_whole(std::uint32_t n, std::uint32_t t) {
        if (std::optional<double> number = fold(n); number && node(n).kind != SyntaxKind::literal) {
            add(n, CodeOp::copy, t, false, {.a = constant(Value::real(*number))});
        } else {
            into(n, t, false);
        }
    }

    void operation(std::uint32_t n, std::uint32_t t, bool last) {
        const SyntaxNode& it = node(n);
        if (std::optional<double> number = fold(n)) {
            add(n, CodeOp::copy, t, last, {.a = constant(Value::real(*number))});
            return;
        }
        if (it.kind == SyntaxKind::unary) {
            add(n, it.op, t, last, {.a = as_double(it.op, value(child(n, 0)))});
            return;
        }
        if (!tree() && (it.op == CodeOp::logical_and || it.op == CodeOp::logical_or)) {
            // the result is the left operand's truth unless that leaves the question open
            boolean_into(child(n, 0), t, false);
            const CodeOp jump =
                it.op == CodeOp::logical_and ? CodeOp::jump_unless : CodeOp::jump_if;
            const std::uint32_t decided =
                add(n, jump, t, last, {.a = Operand(Space::temporary, t)});
            boolean_into(child(n, 1), t, last);
            if (!last) land(decided);
            return;
        }
        const Operand left = stable_value(child(n, 0), node(child(n, 1)).assigns);
        const Operand right = value(child(n, 1));
        add(n, it.op, t, last, {.a = as_double(it.op, left), .b = as_double(it.op, right)});
    }

    // machines: the truth of `n`
    void boolean_into(std::uint32_t n, std::uint32_t t, bool last) {
        const SyntaxNode& it = node(n);
        const bool is_boolean =
            (it.kind == SyntaxKind::unary && it.op == CodeOp::logical_not) ||
            (it.kind == SyntaxKind::binary && it.op >= CodeOp::less && it.op <= CodeOp::logical_or);
        if (is_boolean) return into(n, t, last);
        add(n, CodeOp::truth, t, last, {.a = value(n)});
    }

    // trees: operand by operand, until one comparison is false
    void comparisons(std::uint32_t n, std::uint32_t t, bool last) {
        const SyntaxNode& it = node(n);
        const auto operand = [&](std::uint32_t i) {
            const auto later = syntax_.children_of(it).subspan(i + 1);
            const bool assigned = std::any_of(later.begin(), later.end(),
                                              [&](std::uint32_t c) { return node(c).assigns; });
            return stable_value(child(n, i), assigned);
        };
        std::vector<std::uint32_t> decided;
        Operand left = operand(0);
        for (std::uint32_t i = 0; i + 1 < it.count; ++i) {
            const bool final = i + 2 == it.count;
            const CodeOp op = syntax_.operators[it.index + i];
            const Operand right = operand(i + 1);
            read_again_ = !final;
            add(n, op, t, last && final, {.a = as_double(op, left), .b = as_double(op, right)});
            read_again_ = false;
            if (!final)
                decided.push_back(
                    add(n, CodeOp::jump_unless, t, last, {.a = Operand(Space::temporary, t)}));
            left = right;
        }
        for (std::uint32_t jump : decided) {
            if (!last) land(jump);
        }
    }

    void conditional(std::uint32_t n, std::uint32_t t, bool last) {
        const std::uint32_t mark = next_temporary_;
        const std::uint32_t to_else =
            add(n, CodeOp::jump_unless, t, false, {.a = value(child(n, 0))});
        next_temporary_ = mark;
        into(child(n, 1), t, last);
        const std::uint32_t to_end = last ? 0 : add(n, CodeOp::jump, t, false, {});
        land(to_else);
        into(child(n, 2), t, last);
        if (!last) land(to_end);
    }

    // ---- assignments ----

    void assignment(std::uint32_t n, std::uint32_t t, bool last) {
        if (tree()) return tree_assignment(n, t, last);
        // as SCXML users expect, the value is known before the place is looked at
        const std::uint32_t place = child(n, 0);
        const CodeOp op = node(n).op;
        if (!is_compound(op) && node(place).kind == SyntaxKind::name) {
            write(place, value(child(n, 1)), t, last);
            return;
        }
        into(child(n, 1), t, false);
        const Operand right(Space::temporary, t);
        if (is_compound(op)) {
            const CodeOp arithmetic = arithmetic_of(op);
            add(n, arithmetic, t, false, {.a = value(place), .b = right});
        }
        write(place, right, t, last);
    }

    // writes `value` (temporaries[t] below variables) to `place` and leaves it in t
    void write(std::uint32_t place, Operand value, std::uint32_t t, bool last) {
        const bool below = node(place).kind == SyntaxKind::path;
        const std::uint32_t base = below ? child(place, 0) : place;
        const std::string& name = syntax_.names[node(base).index];
        const Meaning meaning = variable(base, Use::write);
        switch (meaning.kind) {
        case Meaning::Kind::slot: break;
        case Meaning::Kind::undeclared: return fail(place, EvalErrorKind::undeclared, name);
        case Meaning::Kind::error: return report(place, meaning.message);
        default: return fail(place, EvalErrorKind::read_only, name);
        }
        const Operand slot(Space::slot, meaning.index);
        if (!below) {
            add(place, CodeOp::store, t, last, {.a = slot, .b = value});
            return;
        }
        const auto keys = syntax_.children_of(node(place)).subspan(1);
        const auto count = static_cast<std::uint32_t>(keys.size());
        add(place, CodeOp::store_at, t, last, {.a = slot, .b = run(keys), .extra = count});
    }

    // BehaviorTree.CPP: := creates the entry before it evaluates the right-hand side, the others
    // ask for it
    void tree_assignment(std::uint32_t n, std::uint32_t t, bool last) {
        const std::uint32_t place = child(n, 0);
        const std::uint32_t right = child(n, 1);
        const bool creates = node(n).op == CodeOp::declare;
        if (node(place).kind != SyntaxKind::name) return fail(n, EvalErrorKind::not_assignable, "");

        const Meaning meaning = variable(place, creates ? Use::create : Use::write);
        const std::string& name = syntax_.names[node(place).index];
        switch (meaning.kind) {
        case Meaning::Kind::slot: break;
        case Meaning::Kind::undeclared: return fail(place, EvalErrorKind::missing, name);
        case Meaning::Kind::error: return report(place, meaning.message);
        default: return fail(place, EvalErrorKind::read_only, name);
        }
        const Operand slot(Space::slot, meaning.index);
        if (creates) {
            add(place, CodeOp::declare, t, false, {.a = slot});
        } else if (node(right).assigns) {
            // otherwise asking after the right-hand side makes no difference
            add(place, CodeOp::require, t, false, {.a = slot});
        }
        const CodeOp op = creates ? CodeOp::assign : node(n).op;
        add(n, op, t, last, {.a = slot, .b = value(right)});
    }

    // ---- calls ----

    void call(std::uint32_t n, std::uint32_t t, bool last) {
        const SyntaxNode& it = node(n);
        const std::string& name = syntax_.names[it.index];
        if (name == "elapsed") {
            if (takes(n, name, 0, 0)) read(n, names_.elapsed(), name, t, last);
        } else if (name == "In") {
            if (takes(n, name, 1, 1)) in_state(n, t, last);
        } else if (name == "abs") {
            if (takes(n, name, 1, 1)) add(n, CodeOp::absolute, t, last, {.a = value(child(n, 0))});
        } else if (name == "isDefined") {
            if (takes(n, name, 1, 1)) is_defined(n, t, last);
        } else {
            for (std::uint32_t f = 0; f < functions().size(); ++f) {
                const FunctionInfo& info = functions()[f];
                if (info.name != name) continue;
                if (!takes(n, name, info.fewest, info.most)) return;
                // the second operand's index is the function
                add(n, CodeOp::call, t, last,
                    {.a = run(syntax_.children_of(it)),
                     .b = Operand(Space::constant, f),
                     .extra = it.count});
                return;
            }
            report(n, "unknown function \"" + name + '"');
        }
    }

    bool takes(std::uint32_t n, std::string_view name, std::uint8_t fewest, std::uint8_t most) {
        const std::uint32_t count = node(n).count;
        if (count >= fewest && (most == FunctionInfo::any_number || count <= most)) return true;
        std::string message = std::string(name) + " takes ";
        if (most == FunctionInfo::any_number) message += "at least ";
        message += std::to_string(fewest);
        message += fewest == 1 ? " argument, found " : " arguments, found ";
        report(n, message + std::to_string(count));
        return false;
    }

    // In('s'), and In(s) where s is no variable (the null data model)
    void in_state(std::uint32_t n, std::uint32_t t, bool last) {
        const std::uint32_t argument = child(n, 0);
        const SyntaxNode& it = node(argument);
        std::optional<std::string_view> name;
        if (it.kind == SyntaxKind::literal && syntax_.literals[it.index].is(Value::Kind::text)) {
            name = syntax_.literals[it.index].as_text();
        } else if (it.kind == SyntaxKind::name) {
            if (variable(argument, Use::read).kind == Meaning::Kind::undeclared)
                name = syntax_.names[it.index];
        }
        if (!name) {
            add(n, CodeOp::in_named, t, last, {.a = value(argument)});
            return;
        }
        const Meaning meaning = names_.state(*name);
        if (meaning.kind == Meaning::Kind::undeclared) {
            fail(n, EvalErrorKind::no_such_state, *name);
        } else {
            read(n, meaning, *name, t, last);
        }
    }

    // whatever fails in the argument makes it undefined
    void is_defined(std::uint32_t n, std::uint32_t t, bool last) {
        const std::uint32_t begin = position();
        add(n, CodeOp::defined, t, last, {.a = value(child(n, 0))});
        const std::uint32_t end = position();
        const std::uint32_t to_end = last ? 0 : add(n, CodeOp::jump, t, false, {});
        landed_at_ = position();
        code_.guards.push_back({.begin = begin, .end = end, .handler = position()});
        add(n, CodeOp::copy, t, last,
            {.a = constant(tree() ? Value::real(0) : Value::boolean(false))});
        if (!last) land(to_end);
    }

    const Syntax& syntax_;
    Names& names_;
    CodeTable& code_;
    std::vector<EmitError>& errors_;
    std::size_t faults_before_;
    std::size_t first_constant_;
    std::uint32_t begin_;      // first instruction of the expression
    bool read_again_ = false;  // the operands of this instruction are not used up
    std::uint32_t landed_at_ = Id<CodeTag>::none;  // where a jump went last
    std::uint32_t next_temporary_ = first_temporary;
};

}  // namespace

CodeId emit(const Syntax& syntax, Names& names, CodeTable& code, std::vector<EmitError>& errors) {
    return Emitter(syntax, names, code, errors).whole();
}

CodeId emit_store(const Syntax& location, Names& names, CodeTable& code,
                  std::vector<EmitError>& errors) {
    return Emitter(location, names, code, errors).store();
}

}  // namespace trellis
