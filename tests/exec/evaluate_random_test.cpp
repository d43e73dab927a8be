// Evaluation against a slow reference over the syntax tree, on 100,000 random expressions; and
// random token soup.
// SPDX-License-Identifier: MIT
#include "exec/evaluate.h"
#include "support/expressions.h"
#include "support/reference_expressions.h"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <string>

namespace trellis {
namespace {

// random texts of the machine setting's grammar
class Generator {
public:
    explicit Generator(std::uint32_t seed) : engine_(seed) {}

    std::string script() {
        std::string text = expression(4);
        for (std::uint32_t i = below(3); i > 0; --i)
            text += "; " + expression(3);
        return text;
    }

    std::string soup() {
        constexpr std::array tokens = {
            "x",   "n",         "s",  "a",       "o",  "(",   ")",        "[",   "]",    "{",
            "}",   ".",         ",",  ";",       ":",  "?",   ":=",       "=",   "+=",   "==",
            "<",   "&&",        "||", "+",       "-",  "..",  "!",        "~",   "*",    "/",
            "%",   "|",         "1",  "2.5",     "0x", "'t'", "\"q\"",    "'",   "true", "null",
            "abs", "isDefined", "In", "elapsed", "_x", "#",   "\xC3\xA9", "1e5", "@k"};
        std::string text;
        for (std::uint32_t i = below(20); i > 0; --i) {
            text += tokens[below(tokens.size())];
            if (below(2) == 0) text += ' ';
        }
        return text;
    }

private:
    std::uint32_t below(std::size_t limit) { return static_cast<std::uint32_t>(engine_() % limit); }

    std::string place() {
        constexpr std::array places = {"x",      "n",    "s",   "u",    "a",    "o",
                                       "nosuch", "a[1]", "o.k", "a[n]", "o[s]", "a[2][0]"};
        return places[below(places.size())];
    }

    // mostly numbers, or nearly every expression would fail
    std::string atom() {
        constexpr std::array numbers = {"0", "1", "2.5", "-3", "0.5", "x", "n", "a[0]", "o.k"};
        if (below(15) > 0) return numbers[below(numbers.size())];
        constexpr std::array atoms = {"0",   "1",      "2.5",  "-3",     "1e300", "'abc'",
                                      "'7'", "''",     "true", "false",  "null",  "undefined",
                                      "[]",  "[1, 2]", "{}",   "{k: 1}", "pi"};
        return below(2) == 0 ? place() : atoms[below(atoms.size())];
    }

    std::string expression(std::uint32_t depth) {
        if (depth == 0) return atom();
        const auto sub = [&] { return expression(depth - 1); };
        constexpr std::array binary = {"+",  "-",  "*", "/",  "%", "..", "&",  "|", "^",
                                       "==", "!=", "<", "<=", ">", ">=", "&&", "||"};
        constexpr std::array unary = {"-", "!", "~"};
        constexpr std::array assign = {":=", "=", "+=", "-=", "*=", "/="};
        constexpr std::array calls = {"abs", "str", "isDefined", "len"};
        // drawn in this order, whatever order a compiler evaluates operands in
        const std::uint32_t kind = below(12);
        const std::string one = sub();
        const std::string two = sub();
        switch (kind) {
        case 0: return std::string(unary[below(unary.size())]) + one;
        case 1: return "(" + one + ") ? (" + two + ") : (" + sub() + ")";
        case 2: {
            const std::string target = place();
            return "(" + target + " " + assign[below(assign.size())] + " " + one + ")";
        }
        case 3: return std::string(calls[below(calls.size())]) + "(" + one + ")";
        case 4: return "[" + one + ", " + two + "]";
        case 5: return "max(" + one + ", " + two + ")";
        case 6: return "{k: " + one + ", v: " + two + "}.k";
        default: return "(" + one + " " + binary[below(binary.size())] + " " + two + ")";
        }
    }

    std::mt19937 engine_;
};

}  // namespace

TEST_CASE("evaluate: 100000 random expressions agree with the reference over the syntax tree") {
    Generator generator(1);
    const ExpressionWorld start = sample_machine();
    int succeeded = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::string text = generator.script();
        CAPTURE(text);
        ParseError error;
        const std::optional<Syntax> syntax =
            parse_expression(text, Dialect::machine, SyntaxMode::script, error);
        REQUIRE_MESSAGE(syntax, error.message);

        ReferenceEvaluator reference;
        for (std::size_t v = 0; v < start.slots.size(); ++v)
            reference.variables[start.slot_names[v]] = start.slots[v];
        reference.variables["pi"] = Value::real(3.141592653589793);
        const std::optional<Value> expected = reference.evaluate(*syntax);

        ExpressionWorld world = start;
        const CodeId id = world.compile(text);
        REQUIRE_MESSAGE(id, world.message);
        EvalContext context = world.context();
        Value result;
        const bool fine = evaluate(world.code, id, context, result);
        REQUIRE(fine == expected.has_value());
        if (fine) {
            ++succeeded;
            REQUIRE(print(result) == print(*expected));
        }
        for (std::size_t v = 0; v < start.slots.size(); ++v) {
            REQUIRE(print(world.slots[v]) == print(reference.variables[start.slot_names[v]]));
        }
    }
    MESSAGE(succeeded, " of them succeed");
    CHECK(succeeded > 10'000);
}

TEST_CASE("evaluate: 50000 random token soups neither crash nor hang") {
    Generator generator(2);
    int compiled = 0;
    for (int i = 0; i < 25'000; ++i) {
        const std::string text = generator.soup();
        CAPTURE(text);
        for (const ExpressionWorld& start : {sample_machine(), ExpressionWorld(Dialect::tree)}) {
            ExpressionWorld world = start;
            compiled += world.run(text).starts_with("parse error") ? 0 : 1;
        }
    }
    MESSAGE(compiled, " of them are expressions");
}

}  // namespace trellis
