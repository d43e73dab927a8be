// Recursive descent, one function per rule of the grammar in expression.h; binary operators by
// precedence climbing. Covered by tests/load/expression_test.cpp and tests/exec/scripts_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/expression.h"

#include "load/expression_lexer.h"

#include <algorithm>
#include <array>
#include <utility>

namespace trellis {
namespace {

// how tightly a binary operator binds in each setting; 0: it is none there
struct BinaryOperator {
    std::uint16_t symbol;
    CodeOp op;
    std::uint8_t tree;
    std::uint8_t machine;
};

constexpr std::uint8_t tree_comparison = 3;

// clang-format off
constexpr std::array binary_operators = {
    BinaryOperator{symbol("||"), CodeOp::logical_or,    1, 1},
    BinaryOperator{symbol("&&"), CodeOp::logical_and,   2, 2},
    BinaryOperator{symbol("=="), CodeOp::equal,         tree_comparison, 6},
    BinaryOperator{symbol("!="), CodeOp::not_equal,     tree_comparison, 6},
    BinaryOperator{symbol("<"),  CodeOp::less,          tree_comparison, 7},
    BinaryOperator{symbol("<="), CodeOp::less_equal,    tree_comparison, 7},
    BinaryOperator{symbol(">"),  CodeOp::greater,       tree_comparison, 7},
    BinaryOperator{symbol(">="), CodeOp::greater_equal, tree_comparison, 7},
    BinaryOperator{symbol("|"),  CodeOp::bit_or,        4, 3},
    BinaryOperator{symbol("^"),  CodeOp::bit_xor,       4, 4},
    BinaryOperator{symbol("&"),  CodeOp::bit_and,       5, 5},
    BinaryOperator{symbol("+"),  CodeOp::add,           6, 8},
    BinaryOperator{symbol("-"),  CodeOp::subtract,      6, 8},
    BinaryOperator{symbol(".."), CodeOp::concatenate,   6, 8},
    BinaryOperator{symbol("*"),  CodeOp::multiply,      7, 9},
    BinaryOperator{symbol("/"),  CodeOp::divide,        7, 9},
    BinaryOperator{symbol("%"),  CodeOp::remainder,     0, 9},
};

constexpr std::array<std::pair<std::uint16_t, CodeOp>, 6> assignments = {{
    {symbol(":="), CodeOp::declare},
    {symbol("="),  CodeOp::assign},
    {symbol("+="), CodeOp::assign_add},
    {symbol("-="), CodeOp::assign_subtract},
    {symbol("*="), CodeOp::assign_multiply},
    {symbol("/="), CodeOp::assign_divide},
}};
// clang-format on

// the functions that functions() does not list (core/functions.def)
constexpr std::array<std::string_view, 4> own_operations = {"In", "abs", "elapsed", "isDefined"};

// Parsing stops at the first fault: `failed_` is set, every rule returns at once, and what they
// return is not used.
class Parser {
public:
    Parser(std::string_view text, Dialect dialect, ParseError& error)
        : text_(text), dialect_(dialect), error_(error) {
        syntax_.dialect = dialect;
        advance();
    }

    std::optional<Syntax> parse(SyntaxMode mode) {
        switch (mode) {
        case SyntaxMode::script: syntax_.root = machine() ? machine_script() : tree_script(); break;
        case SyntaxMode::single_expression: syntax_.root = expression(); break;
        case SyntaxMode::location: syntax_.root = location(); break;
        }
        if (!failed_ && token_.kind != TokenKind::end) fail("expected the end, found " + found());
        if (failed_) return std::nullopt;
        return std::move(syntax_);
    }

private:
    bool machine() const { return dialect_ == Dialect::machine; }

    void advance() {
        const std::uint32_t end = token_.offset + token_.length;
        token_ = next_token(text_, end, dialect_);
        if (token_.kind == TokenKind::invalid) fail(std::move(token_.message));
    }

    bool accept(std::uint16_t wanted) {
        if (failed_ || !token_.is(wanted)) return false;
        advance();
        return true;
    }

    void expect(std::string_view wanted) {
        if (failed_ || accept(symbol(wanted))) return;
        fail("expected \"" + std::string(wanted) + "\", found " + found());
    }

    std::string found() const {
        if (token_.kind == TokenKind::end) return "the end";
        return '"' + std::string(text_.substr(token_.offset, token_.length)) + '"';
    }

    void fail(std::string message) {
        if (failed_) return;
        failed_ = true;
        error_ = {.offset = token_.offset, .message = std::move(message)};
    }

    std::uint32_t add(SyntaxNode node, std::span<const std::uint32_t> children) {
        if (failed_) return 0;
        node.first = static_cast<std::uint32_t>(syntax_.children.size());
        node.count = static_cast<std::uint32_t>(children.size());
        for (std::uint32_t child : children) {
            const SyntaxNode& below = syntax_.nodes[child];
            node.assigns |= below.assigns;
            node.height = std::max(node.height, static_cast<std::uint16_t>(below.height + 1));
            syntax_.children.push_back(child);
        }
        if (node.height > max_syntax_height) fail("nested too deeply");
        syntax_.nodes.push_back(node);
        return static_cast<std::uint32_t>(syntax_.nodes.size() - 1);
    }

    std::uint32_t add(SyntaxNode node, std::initializer_list<std::uint32_t> children) {
        return add(node, std::span(children.begin(), children.size()));
    }

    std::uint32_t literal(Value value, std::uint32_t offset) {
        syntax_.literals.push_back(std::move(value));
        const auto index = static_cast<std::uint32_t>(syntax_.literals.size() - 1);
        return add({.kind = SyntaxKind::literal, .offset = offset, .index = index}, {});
    }

    std::uint32_t named(SyntaxKind kind, std::string_view name, std::uint32_t offset,
                        std::span<const std::uint32_t> children = {}) {
        syntax_.names.emplace_back(name);
        const auto index = static_cast<std::uint32_t>(syntax_.names.size() - 1);
        return add({.kind = kind, .offset = offset, .index = index}, children);
    }

    // ---- the rules of the grammar ----

    // separators are optional, none leads, and the empty text is no script
    std::uint32_t tree_script() {
        std::vector<std::uint32_t> expressions;
        do {
            expressions.push_back(expression());
            while (accept(symbol(";"))) {}
        } while (!failed_ && token_.kind != TokenKind::end);
        return add({.kind = SyntaxKind::sequence}, expressions);
    }

    std::uint32_t machine_script() {
        std::vector<std::uint32_t> expressions;
        while (!failed_ && token_.kind != TokenKind::end) {
            if (accept(symbol(";"))) continue;
            expressions.push_back(expression());
            if (!failed_ && token_.kind != TokenKind::end) expect(";");
        }
        return add({.kind = SyntaxKind::sequence}, expressions);
    }

    std::uint32_t location() {
        const std::uint32_t place = postfix();
        if (!failed_ && !is_place(place)) {
            fail("expected a variable or a place in one");
            error_.offset = syntax_.nodes[place].offset;
        }
        return place;
    }

    bool is_place(std::uint32_t n) const {
        const SyntaxNode& node = syntax_.nodes[n];
        if (node.kind == SyntaxKind::name) return true;
        if (node.kind != SyntaxKind::path) return false;
        return syntax_.nodes[syntax_.children[node.first]].kind == SyntaxKind::name;
    }

    // every recursion of the grammar passes here or through unary()
    std::uint32_t expression() {
        if (failed_ || depth_ >= max_syntax_height) return too_deep();
        ++depth_;
        std::uint32_t result = ternary();
        for (const auto& [sign, op] : assignments) {
            const std::uint32_t offset = token_.offset;
            if (failed_ || !token_.is(sign)) continue;
            // BehaviorTree.CPP finds out at run time that 5 := 1 makes no sense
            if (machine() && !is_place(result)) {
                fail("only a variable or a place in one can be assigned to");
                break;
            }
            advance();
            const std::uint32_t value = expression();
            result =
                add({.kind = SyntaxKind::assignment, .op = op, .assigns = true, .offset = offset},
                    {result, value});
            break;
        }
        --depth_;
        return result;
    }

    std::uint32_t ternary() {
        if (failed_ || depth_ >= max_syntax_height) return too_deep();
        const std::uint32_t condition = binary(1);
        const std::uint32_t offset = token_.offset;
        if (!accept(symbol("?"))) return condition;
        ++depth_;
        const std::uint32_t then = expression();
        expect(":");
        const std::uint32_t otherwise = ternary();
        --depth_;
        return add({.kind = SyntaxKind::conditional, .offset = offset},
                   {condition, then, otherwise});
    }

    // the operator at the current token, nullptr if it is none or binds looser than `loosest`
    const BinaryOperator* binary_operator(std::uint8_t loosest) const {
        if (failed_ || token_.kind != TokenKind::symbol) return nullptr;
        for (const BinaryOperator& o : binary_operators) {
            const std::uint8_t level = machine() ? o.machine : o.tree;
            if (o.symbol == token_.symbol) return level >= loosest ? &o : nullptr;
        }
        return nullptr;
    }

    std::uint32_t binary(std::uint8_t loosest) {
        std::uint32_t left = unary();
        while (const BinaryOperator* o = binary_operator(loosest)) {
            const std::uint8_t level = machine() ? o->machine : o->tree;
            if (!machine() && level == tree_comparison) {
                left = comparisons(left);
                continue;
            }
            const std::uint32_t offset = token_.offset;
            advance();
            const std::uint32_t right = binary(static_cast<std::uint8_t>(level + 1));
            left = add({.kind = SyntaxKind::binary, .op = o->op, .offset = offset}, {left, right});
        }
        return left;
    }

    // trees: a < b == c is one list
    std::uint32_t comparisons(std::uint32_t left) {
        const std::uint32_t offset = token_.offset;
        std::vector<std::uint32_t> operands{left};
        std::vector<CodeOp> operators;
        while (const BinaryOperator* o = binary_operator(tree_comparison)) {
            if (o->tree != tree_comparison) break;
            advance();
            operators.push_back(o->op);
            operands.push_back(binary(tree_comparison + 1));
        }
        const auto index = static_cast<std::uint32_t>(syntax_.operators.size());
        syntax_.operators.insert(syntax_.operators.end(), operators.begin(), operators.end());
        return add({.kind = SyntaxKind::comparisons, .offset = offset, .index = index}, operands);
    }

    std::uint32_t unary() {
        if (failed_ || depth_ >= max_syntax_height) return too_deep();
        const std::uint32_t offset = token_.offset;
        CodeOp op = CodeOp::copy;
        if (accept(symbol("-")))
            op = CodeOp::negate;
        else if (accept(symbol("~")))
            op = CodeOp::complement;
        else if (accept(symbol("!")))
            op = CodeOp::logical_not;
        else
            return postfix();
        ++depth_;
        const std::uint32_t operand = unary();
        --depth_;
        return add({.kind = SyntaxKind::unary, .op = op, .offset = offset}, {operand});
    }

    std::uint32_t postfix() {
        const std::uint32_t base = primary();
        std::vector<std::uint32_t> path{base};
        while (!failed_) {
            if (accept(symbol("."))) {
                if (token_.kind != TokenKind::name) {
                    fail("expected the name of a member, found " + found());
                    break;
                }
                path.push_back(literal(Value::text(name()), token_.offset));
                advance();
            } else if (accept(symbol("["))) {
                path.push_back(expression());
                expect("]");
            } else {
                break;
            }
        }
        if (path.size() == 1) return base;
        return add({.kind = SyntaxKind::path, .offset = syntax_.nodes[base].offset}, path);
    }

    std::uint32_t primary() {
        const Token token = token_;
        if (failed_) return 0;
        switch (token.kind) {
        case TokenKind::number:
        case TokenKind::text: advance(); return literal(token.value, token.offset);
        case TokenKind::name: return name_or_call();
        case TokenKind::symbol:
            if (accept(symbol("("))) {
                const std::uint32_t inner = expression();
                expect(")");
                return inner;
            }
            if (machine() && accept(symbol("["))) {
                return add({.kind = SyntaxKind::array, .offset = token.offset}, list("]"));
            }
            if (machine() && accept(symbol("{"))) return object(token.offset);
            break;
        case TokenKind::end:
        case TokenKind::invalid: break;
        }
        fail("expected an operand, found " + found());
        return 0;
    }

    std::string_view name() const { return text_.substr(token_.offset, token_.length); }

    std::uint32_t name_or_call() {
        const std::uint32_t offset = token_.offset;
        const std::string_view word = name();
        const std::uint32_t end = offset + token_.length;
        advance();
        if (word == "true" || word == "false") {
            const bool yes = word == "true";
            return literal(machine() ? Value::boolean(yes) : Value::real(yes ? 1 : 0), offset);
        }
        if (machine() && word == "null") return literal(Value::null(), offset);
        if (machine() && word == "undefined") return literal(Value(), offset);
        const bool call =
            token_.is(symbol("(")) && (machine() || (token_.offset == end && is_function(word)));
        if (call && accept(symbol("("))) return named(SyntaxKind::call, word, offset, list(")"));
        // the blackboard's @key means key at the root of the hierarchy; which entry that is, the
        // compiler knows
        return named(SyntaxKind::name, word, offset);
    }

    // expressions separated by commas up to `closing`, of which the opening sign is read
    std::vector<std::uint32_t> list(std::string_view closing) {
        std::vector<std::uint32_t> items;
        if (accept(symbol(closing))) return items;
        do
            items.push_back(expression());
        while (accept(symbol(",")));
        expect(closing);
        return items;
    }

    std::uint32_t object(std::uint32_t offset) {
        std::vector<std::uint32_t> members;
        if (!accept(symbol("}"))) {
            do {
                const std::uint32_t key = token_.offset;
                if (token_.kind == TokenKind::name) {
                    members.push_back(literal(Value::text(name()), key));
                } else if (token_.kind == TokenKind::text) {
                    members.push_back(literal(token_.value, key));
                } else {
                    fail("expected a key, found " + found());
                    return 0;
                }
                advance();
                expect(":");
                members.push_back(expression());
            } while (accept(symbol(",")));
            expect("}");
        }
        return add({.kind = SyntaxKind::object, .offset = offset}, members);
    }

    std::uint32_t too_deep() {
        fail("nested too deeply");
        return 0;
    }

    std::string_view text_;
    Dialect dialect_;
    ParseError& error_;
    Syntax syntax_;
    Token token_;
    std::uint16_t depth_ = 0;
    bool failed_ = false;
};

}  // namespace

std::optional<Syntax> parse_expression(std::string_view text, Dialect dialect, SyntaxMode mode,
                                       ParseError& error) {
    if (text.size() > 0x3FFFFFFF) {
        error = {.offset = 0, .message = "the expression is too long"};
        return std::nullopt;
    }
    return Parser(text, dialect, error).parse(mode);
}

std::vector<std::string_view> function_names() {
    std::vector<std::string_view> names(own_operations.begin(), own_operations.end());
    for (const FunctionInfo& f : functions())
        names.push_back(f.name);
    std::sort(names.begin(), names.end());
    return names;
}

bool is_function(std::string_view name) {
    const auto& own = own_operations;
    if (std::find(own.begin(), own.end(), name) != own.end()) return true;
    return std::any_of(functions().begin(), functions().end(),
                       [&](const FunctionInfo& f) { return f.name == name; });
}

}  // namespace trellis
