// The grammar of both settings, error texts with their places, bounded nesting, and what the
// compiler reports.
// SPDX-License-Identifier: MIT
#include "load/expression.h"

#include "load/emit.h"
#include "support/expressions.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

namespace trellis {
namespace {

// the syntax in prefix form: (add 1 (multiply 2 x))
std::string prefix(const Syntax& s, std::uint32_t n) {
    const SyntaxNode& node = s.nodes[n];
    std::string text;
    switch (node.kind) {
    case SyntaxKind::literal: return print(s.literals[node.index]);
    case SyntaxKind::name: return s.names[node.index];
    case SyntaxKind::path: text = "(at"; break;
    case SyntaxKind::unary:
    case SyntaxKind::binary:
    case SyntaxKind::assignment: text.append("(").append(name_of(node.op)); break;
    case SyntaxKind::comparisons: {
        text = "(";
        for (std::uint32_t i = 0; i + 1 < node.count; ++i)
            text.append(name_of(s.operators[node.index + i])).append(",");
        text.pop_back();
        break;
    }
    case SyntaxKind::conditional: text = "(if"; break;
    case SyntaxKind::call: text = "(call " + s.names[node.index]; break;
    case SyntaxKind::array: text = "(array"; break;
    case SyntaxKind::object: text = "(object"; break;
    case SyntaxKind::sequence: text = "(do"; break;
    }
    for (std::uint32_t child : s.children_of(node))
        text.append(" ").append(prefix(s, child));
    return text + ")";
}

std::string parsed(std::string_view text, Dialect dialect,
                   SyntaxMode mode = SyntaxMode::single_expression) {
    ParseError error;
    const std::optional<Syntax> syntax = parse_expression(text, dialect, mode, error);
    return syntax ? prefix(*syntax, syntax->root)
                  : std::to_string(error.offset) + ": " + error.message;
}

std::string tree(std::string_view text) {
    return parsed(text, Dialect::tree, SyntaxMode::script);
}

std::string machine(std::string_view text) {
    return parsed(text, Dialect::machine);
}

}  // namespace

TEST_CASE("expression: trees bind bitwise operators tighter than comparisons, machines looser") {
    CHECK(tree("6 & 3 == 2") == "(do (equal (bit_and 6 3) 2))");
    CHECK(machine("6 & 3 == 2") == "(bit_and 6.0 (equal 3.0 2.0))");
    CHECK(tree("1 | 2 ^ 3") == "(do (bit_xor (bit_or 1 2) 3))");
    CHECK(machine("1 | 2 ^ 3") == "(bit_or 1.0 (bit_xor 2.0 3.0))");
    CHECK(tree("1 < 2 == 3") == "(do (less,equal 1 2 3))");
    CHECK(machine("1 < 2 == 3") == "(equal (less 1.0 2.0) 3.0)");
    CHECK(machine("a || b && c") == "(logical_or a (logical_and b c))");
    CHECK(machine("-a * b .. c + d") == "(add (concatenate (multiply (negate a) b) c) d)");
}

TEST_CASE("expression: conditionals and assignments group to the right") {
    CHECK(machine("a ? b : c ? d : e") == "(if a b (if c d e))");
    CHECK(machine("a ? b ? 1 : 2 : c") == "(if a (if b 1.0 2.0) c)");
    CHECK(machine("x = y += 2") == "(assign x (assign_add y 2.0))");
    CHECK(tree("i > 2 ? k := 1 : 2") == "(do (if (greater i 2) (declare k 1) 2))");
    CHECK(tree("i + 1 = 4") == "(do (assign (add i 1) 4))");
}

TEST_CASE("expression: scripts separate expressions, optionally in trees, always in machines") {
    CHECK(tree("x := 1 y := 2;; z") == "(do (declare x 1) (declare y 2) z)");
    CHECK(tree("f(1)") == "(do f 1)");
    CHECK(tree("abs(1) abs (1)") == "(do (call abs 1) abs 1)");
    CHECK(parsed("; x = 1;; y", Dialect::machine, SyntaxMode::script) == "(do (assign x 1.0) y)");
    CHECK(parsed("x y", Dialect::machine, SyntaxMode::script) == "2: expected \";\", found \"y\"");
    CHECK(parsed("", Dialect::machine, SyntaxMode::script) == "(do)");
    CHECK(tree("") == "0: expected an operand, found the end");
}

TEST_CASE("expression: places, calls, arrays and objects") {
    CHECK(machine("a.b[c + 1]['d'].e") == "(at a \"b\" (add c 1.0) \"d\" \"e\")");
    CHECK(machine("min(1, x)") == "(call min 1.0 x)");
    CHECK(machine("[1, [], {a: 1, 'b c': 2}]") ==
          "(array 1.0 (array) (object \"a\" 1.0 \"b c\" 2.0))");
    CHECK(parsed("a.b[0]", Dialect::machine, SyntaxMode::location) == "(at a \"b\" 0.0)");
    CHECK(parsed("a + b", Dialect::machine, SyntaxMode::location) ==
          "2: expected the end, found \"+\"");
    CHECK(parsed("7", Dialect::machine, SyntaxMode::location) ==
          "0: expected a variable or a place in one");
    CHECK(tree("_x.bumper") == "(do (at _x \"bumper\"))");
}

TEST_CASE("expression: errors say what was expected and where") {
    CHECK(machine("1 +") == "3: expected an operand, found the end");
    CHECK(machine("(1 + 2") == "6: expected \")\", found the end");
    CHECK(machine("1 )") == "2: expected the end, found \")\"");
    CHECK(machine("a.1") == "1: expected the end, found \".1\"");
    CHECK(machine("a.'b'") == "2: expected the name of a member, found \"'b'\"");
    CHECK(machine("{1: 2}") == "1: expected a key, found \"1\"");
    CHECK(machine("a ? b") == "5: expected \":\", found the end");
    CHECK(machine("5 = x") == "2: only a variable or a place in one can be assigned to");
    CHECK(machine("'abc") == "0: the text has no closing '");
    CHECK(machine("#") == "0: unexpected character \"#\"");
    CHECK(tree("\xC3\xA9tat := 1") == "0: unexpected character \"\xC3\xA9\"");
    CHECK(tree("3foo") == "0: a number cannot be followed by \"f\"");
    CHECK(tree("5.") == "0: a number cannot be followed by \".\"");
    CHECK(tree("1 + 0x") == "4: expected hexadecimal digits after 0x");
    CHECK(tree("1e400") == "0: the number is out of range");
    CHECK(tree("i % 2") == "2: unexpected character \"%\"");
    CHECK(tree("[1]") == "0: expected an operand, found \"[\"");
    CHECK(tree("\"text\"") == "0: unexpected character \"\"\"");
}

TEST_CASE("expression: nesting is bounded, length is not") {
    const auto repeated = [](std::string_view part, int count) {
        std::string text;
        for (int i = 0; i < count; ++i)
            text += part;
        return text;
    };
    for (Dialect dialect : {Dialect::tree, Dialect::machine}) {
        const auto message = [&](const std::string& text) {
            const std::string result = parsed(text, dialect, SyntaxMode::script);
            return result.substr(0, 1) == "(" ? "fine" : result.substr(result.find(' ') + 1);
        };
        CHECK(message(repeated("(", 200) + "1" + repeated(")", 200)) == "fine");
        for (const char* part :
             {"(", "-", "!", "x:=", "1?", "1?1:", "abs(", "x.y[", "1+(", "1||-"}) {
            CAPTURE(part);
            CHECK(message(repeated(part, 100'000)) == "nested too deeply");
        }
        CHECK(message(repeated("1+", 200) + "1") == "fine");
        CHECK(message(repeated("1+", 300) + "1") == "nested too deeply");
        CHECK(message(repeated("x := 1;", 20'000)) == "fine");
    }
}

TEST_CASE("expression: functions are known by name") {
    CHECK(is_function("abs"));
    CHECK(is_function("isDefined"));
    CHECK(is_function("randint"));
    CHECK_FALSE(is_function("nosuch"));
    CHECK(function_names().size() == functions().size() + 4);
}

TEST_CASE("emit: faults are reported all at once, with their places") {
    ExpressionWorld world(Dialect::machine);
    CHECK_FALSE(world.compile("nosuch(1) + elapsed(2) + atan2(1) + min() + locked"));
    CHECK(world.message ==
          "0: unknown function \"nosuch\"; 12: elapsed takes 0 arguments, found 1; "
          "25: atan2 takes 2 arguments, found 1; 36: min takes at least 1 argument, found 0; "
          "44: locked is not for expressions");
    CHECK_FALSE(world.compile("locked = 1"));
    CHECK(world.message == "0: locked is not for expressions");
}

TEST_CASE("emit: code is flat and readable, numbers go through the accumulator") {
    ExpressionWorld world(Dialect::machine);
    world.declare("limit", Value::real(1));
    REQUIRE(world.compile("elapsed() > limit"));
    CHECK(dump(world.code) == "0  elapsed_since t0, undefined, undefined, 0\n"
                              "1  greater t1, t0, s0, 0  last\n");
    ExpressionWorld spiral(Dialect::machine);
    REQUIRE(spiral.compile("0.5 / (0.2 + (0.1 / 2) * elapsed())"));
    CHECK(dump(spiral.code) == "0  elapsed_since t0, undefined, undefined, 0\n"
                               "1  multiply t0, 0.05, t0, 0\n"
                               "2  add t0, 0.2, t0, 0\n"
                               "3  divide t1, 0.5, t0, 0  last\n");
}

TEST_CASE("emit: equal texts give equal code") {
    ExpressionWorld a(Dialect::tree);
    ExpressionWorld b(Dialect::tree);
    a.compile("x := 1 + 2; isDefined(x)");
    b.compile("x := 1 + 2; isDefined(x)");
    CHECK(a.code == b.code);
    b.compile("x");
    CHECK_FALSE(a.code == b.code);
}

}  // namespace trellis
