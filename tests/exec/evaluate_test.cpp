// Evaluation: both settings by example, all kinds of failure with their texts, a slow reference
// over the syntax tree on 100,000 random expressions, random token soup, and no allocation in
// steady state.
// SPDX-License-Identifier: MIT
#include "exec/evaluate.h"

#include "support/allocations.h"
#include "support/expressions.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace trellis {
namespace {

ExpressionWorld tree() {
    ExpressionWorld world(Dialect::tree);
    world.add_enum("RED", 1);
    world.run("i := 3; d := 1.5; s := 'abc'");
    return world;
}

std::string in_machine(std::string_view text) {
    return sample_machine().run(text);
}

std::string in_tree(std::string_view text) {
    return tree().run(text);
}

struct Case {
    std::string_view text;
    std::string_view result;
};

}  // namespace

TEST_CASE("evaluate: machines compute with dynamic types") {
    for (const Case& c : {Case{"1 + 2 * 3", "7.0"},
                          {"7 % 4", "3.0"},
                          {"-7 % 4", "-3.0"},
                          {"1 / 0", "inf"},
                          {"6 & 3 == 2", "0.0"},
                          {"(6 & 3) == 2", "true"},
                          {"5 ^ 1 | 8", "12.0"},
                          {"~0", "-1.0"},
                          {"true + true", "2.0"},
                          {"'a' + 'b'", "\"ab\""},
                          {"'a' .. 1.5 .. 2 .. true", "\"a1.52true\""},
                          {"1e20 .. ''", "\"1e+20\""},
                          {"n + 1", "4.0"},
                          {"n == 3", "true"},
                          {"x == '2'", "true"},
                          {"' 2.0 ' == x", "true"},
                          {"'2x' == 2", "false"},
                          {"[1, 2] == [1, 2]", "true"},
                          {"{a: 1, b: 2} == {b: 2, a: true + 1 - 1}", "true"},
                          {"['1'] == [1]", "false"},
                          {"null == undefined", "false"},
                          {"0/0 == 0/0", "false"},
                          {"'b' > 'a'", "true"},
                          {"!''", "true"},
                          {"!!'0'", "true"},
                          {"![]", "false"},
                          {"!undefined", "true"},
                          {"u", "undefined"},
                          {"0 && nosuch", "false"},
                          {"1 || nosuch", "true"},
                          {"2 && 'x'", "true"},
                          {"1 ? 'a' : nosuch", "\"a\""},
                          {"null ? 1 : 2", "2.0"},
                          {"a[0] + a[2][0]", "4.0"},
                          {"a[3]", "undefined"},
                          {"a[0.5]", "undefined"},
                          {"a['0']", "undefined"},
                          {"o.k", "1.0"},
                          {"o['two words'].deep", "5.0"},
                          {"o.nosuch", "undefined"},
                          {"s.length", "undefined"},
                          {"{'1': 2}[1]", "2.0"},
                          {"\"a\\n\\\"b\"", "\"a\\n\\\"b\""},
                          {".5 + 5.", "5.5"},
                          {"0x1F", "31.0"},
                          {"pi", "3.141592653589793"},
                          {"", "undefined"},
                          {"x = 1; x", "1.0"},
                          {"x := 'text'; x", "\"text\""},
                          {"x += 1; x *= x; x", "9.0"},
                          {"o.k -= 2; o.new = [o.k]; o",
                           "{\"k\": -1.0, \"two words\": {\"deep\": 5.0}, \"new\": [-1.0]}"},
                          {"a[2][0] = 'z'; a", "[1.0, \"two\", [\"z\"]]"},
                          {"x = (s = 'q') + s", "\"qq\""},
                          {"x + (x = 5)", "7.0"},
                          {"x < (x = 5)", "true"},
                          {"a[x = 0]", "1.0"},
                          {"x = [x, [x]]; x", "[2.0, [2.0]]"}}) {
        CAPTURE(c.text);
        CHECK(in_machine(c.text) == c.result);
    }
}

TEST_CASE("evaluate: functions") {
    for (const Case& c :
         {Case{"abs(-2)", "2.0"},
          {"abs(true)", "1.0"},
          {"min(3, 1, 2)", "1.0"},
          {"max(1, x, 3 - 2)", "2.0"},
          {"sqrt(x * 8)", "4.0"},
          {"sin(0) + cos(0) + tan(0)", "1.0"},
          {"atan2(0, -1) == pi", "true"},
          {"floor(-1.5) .. ceil(-1.5) .. round(-1.5)", "\"-2-1-2\""},
          {"pow(x, 10)", "1024.0"},
          {"log(exp(1))", "1.0"},
          {"len('añb')", "3.0"},
          {"len(a) + len(o)", "5.0"},
          {"has(o, 'k')", "true"},
          {"has(o, 'v')", "false"},
          {"append(a, 4, [5])", "[1.0, \"two\", [3.0], 4.0, [5.0]]"},
          {"len(a)", "3.0"},
          {"startsWith(s, 'ab')", "true"},
          {"str([1, 'x', {a: undefined, b: null}, undefined])",
           "\"[1,\\\"x\\\",{\\\"b\\\":null},null]\""},
          {"type(1) .. type('') .. type(a) .. type(o) .. type(null) .. type(u) .. type(true)",
           "\"numberstringarrayobjectnullundefinedboolean\""},
          {"isDefined(x) && !isDefined(u) && !isDefined(nosuch) && !isDefined(o.a.b) && "
           "isDefined(isDefined(nosuch))",
           "true"},
          {"uniform(1, 3)", "1.2687284882248024"},
          {"In('idle') || !In('active')", "false"},
          {"In(active)", "true"},
          {"In('act' + 'ive')", "true"}}) {
        CAPTURE(c.text);
        CHECK(in_machine(c.text) == c.result);
    }
    CHECK(in_tree("abs(-i) + max(d, 2)") == "5.0");
    CHECK(in_tree("isDefined(nosuch) + isDefined(i)") == "1.0");
    CHECK(in_tree("startsWith(s, 'ab')") == "1.0");
    CHECK(in_tree("In('active')") == "1.0");
    CHECK(in_tree("i * pi > 9") == "1.0");
}

TEST_CASE("evaluate: failures say what was wrong") {
    for (const Case& c : {Case{"nosuch + 1", "error there is no variable \"nosuch\""},
                          {"nosuch = 1", "error there is no variable \"nosuch\""},
                          {"_event.name = 1", "error \"_event\" cannot be assigned to"},
                          {"'a' - 1", "error operator - does not take text and real"},
                          {"-s", "error operator - does not take text"},
                          {"a .. 1", "error operator .. does not take array and real"},
                          {"1 < 'b'", "error operator < does not take real and text"},
                          {"~1e300", "error a whole number of 64 bits is needed here"},
                          {"u.x", "error there is no such place in a value of kind undefined"},
                          {"x.y = 1", "error there is no such place in a value of kind real"},
                          {"a[9] = 1", "error there is no such place in a value of kind array"},
                          {"len(1)", "error function len does not take real"},
                          {"abs('1')", "error function abs does not take text"},
                          {"In(1)", "error In() takes the name of a state, found real"},
                          {"In('nowhere')", "error there is no state \"nowhere\""},
                          {"In(s)", "error there is no such state"}}) {
        CAPTURE(c.text);
        CHECK(in_machine(c.text) == c.result);
    }
    for (const Case& c :
         {Case{"nosuch", "error variable \"nosuch\" does not exist yet"},
          {"nosuch = 1", "error variable \"nosuch\" does not exist yet"},
          {"5 := 1", "error only a variable can be assigned to"},
          {"i = 1.5", "error variable \"i\" holds integer, which this real cannot become"},
          {"s = 1", "error variable \"s\" holds text, which this integer cannot become"},
          {"2 && 1", "error a condition is needed here, found integer"},
          {"1.5 & 1", "error a whole number of 64 bits is needed here"},
          {"9007199254740993 + 1", "error the integer is too large to be computed with exactly"},
          {"s == 1", "error the text is no number and names none"},
          {"s ? 1 : 2", "error a condition is needed here, found text"},
          {"x := (1 .. 2)", "error an operand of  has no value yet"}}) {
        CAPTURE(c.text);
        CHECK(in_tree(c.text) == c.result);
    }
}

TEST_CASE("evaluate: a failure leaves the assignments before it, and tells its place in the text") {
    ExpressionWorld world = sample_machine();
    const CodeId id = world.compile("x = 7; n = 'a' * 2; x = 8");
    EvalContext context = world.context();
    CHECK_FALSE(execute(world.code, id, context));
    CHECK(world.code.offsets[context.error.instruction] == 15);
    CHECK(print(world.value_of("x")) == "7.0");
    CHECK(print(world.value_of("n")) == "3");
    // but the entry that := was about to fill exists
    ExpressionWorld board = tree();
    CHECK(board.run("fresh := 'a' - 1") == "error operator - does not take text and real");
    CHECK(board.run("fresh = 2") == "2");
}

TEST_CASE(
    "evaluate: variables of trees that a port or constant has typed convert texts by their type") {
    ExpressionWorld world = tree();
    world.declare("count", Value(), EntryType::integer);
    world.declare("size", Value::integer(1), EntryType::unsigned_integer);
    world.declare("flag", Value::integer(0), EntryType::boolean);
    world.declare("name", Value(), EntryType::text);
    world.declare("length", Value(), EntryType::real);
    CHECK(world.run("count = '12x'") == "12");
    CHECK(world.run("count = 'x'") ==
          "error variable \"count\" holds integer, which this text cannot become");
    CHECK(world.run("count += 0.5") ==
          "error variable \"count\" holds integer, which this real cannot become");
    CHECK(world.run("size = 0 - 1") ==
          "error variable \"size\" holds integer, which this real cannot become");
    CHECK(world.run("flag = 'true'") == "1");
    CHECK(world.run("flag = 'yes'") ==
          "error variable \"flag\" holds integer, which this text cannot become");
    CHECK(world.run("length = '2.5'") == "2.5");
    CHECK(world.run("name = 'Ada'") == "\"Ada\"");
    CHECK(world.run("name = 1") ==
          "error variable \"name\" holds text, which this integer cannot become");
}

TEST_CASE("evaluate: conditions follow the setting") {
    const auto condition = [](ExpressionWorld world, const char* text) {
        const CodeId id = world.compile(text);
        EvalContext context = world.context();
        const Truth truth = evaluate_condition(world.code, id, context);
        return truth == Truth::failed ? describe(context.error, world.code)
               : truth == Truth::yes  ? "yes"
                                      : "no";
    };
    CHECK(condition(sample_machine(), "x > 1") == "yes");
    CHECK(condition(sample_machine(), "x > 1 && x < 2") == "no");
    CHECK(condition(sample_machine(), "s") == "yes");
    CHECK(condition(sample_machine(), "u") == "no");
    CHECK(condition(sample_machine(), "-1") == "yes");
    CHECK(condition(sample_machine(), "a - 1") == "operator - does not take array and real");
    CHECK(condition(tree(), "i == 3") == "yes");
    CHECK(condition(tree(), "1 < i < 3") == "no");
    CHECK(condition(tree(), "d") == "yes");
    CHECK(condition(tree(), "i") == "a condition is needed here, found integer");
    CHECK(condition(tree(), "-d") == "a condition is needed here, found real");
    CHECK(condition(tree(), "s") == "a condition is needed here, found text");
}

TEST_CASE("evaluate: numbers for ports") {
    const auto number = [](ExpressionWorld world, const char* text) {
        const CodeId id = world.compile(text);
        EvalContext context = world.context();
        double result = -99;
        return evaluate_real(world.code, id, context, result) ? result : -1;
    };
    CHECK(number(sample_machine(), "n") == 3);
    CHECK(number(sample_machine(), "x > 1") == 1);
    CHECK(number(sample_machine(), "s") == -1);
    CHECK(number(tree(), "i") == 3);
    CHECK(number(tree(), "i := 4") == 4);
}

TEST_CASE("evaluate: time and sensors come from the context") {
    for (Dialect dialect : {Dialect::tree, Dialect::machine}) {
        ExpressionWorld world(dialect);
        world.cycle = 3;
        world.row_memory = {0xFFFFFFFF};
        world.host = {.bumper = true, .count = -4, .range = 1.25};
        CHECK(world.run("elapsed()") == "2.0");
        CHECK(world.run("elapsed() * 2 + 1") == "5.0");
        world.row_memory = {7};
        world.counts_cycles = true;
        CHECK(world.run("elapsed()") == "3.5");
        CHECK(world.run("_x.bumper ? _x.count : _x['range']") == "-4.0");
        CHECK(world.run("-_x.range") == "-1.25");
    }
}

TEST_CASE("evaluate: every assignment happens once and is counted once") {
    ExpressionWorld world = tree();
    // a text in the temporary that the fast loop wants for a number
    CHECK(world.run("s .. s; i += 1; i") == "4");
    const std::uint32_t before = world.writes[0];
    world.run("i = 4; i += 1; i = 'x'");
    CHECK(world.writes[0] == before + 2);
    ExpressionWorld other = sample_machine();
    other.run("x = [s .. s][0]; x = 1; x = 'a'; o.k = 2");
    CHECK(other.writes[0] == 3);
}

TEST_CASE("evaluate: emit_store writes a value to a place") {
    ExpressionWorld world = sample_machine();
    for (const char* place : {"x", "o.list", "a[1]"}) {
        const CodeId id = world.compile(place, SyntaxMode::location);
        REQUIRE(id);
        EvalContext context = world.context();
        context.temporaries[stored_temporary] = Value::text("stored");
        CHECK(execute(world.code, id, context));
    }
    CHECK(world.run("[x, o.list, a[1]]") == R"(["stored", "stored", "stored"])");
    CHECK(world.run("x +", SyntaxMode::location) == "parse error 2: expected the end, found \"+\"");
}

TEST_CASE("evaluate: values cannot nest without end") {
    ExpressionWorld world = sample_machine();
    std::string last;
    for (int i = 0; i < 100; ++i)
        last = world.run("x = [x]");
    CHECK(last == "error arrays and objects nest too deeply");
    CHECK(world.value_of("x").depth() == Value::max_depth);
}

TEST_CASE("evaluate: steady state allocates nothing") {
    const auto allocations = [](ExpressionWorld world, const std::string& text) {
        const CodeId id = world.compile(text);
        REQUIRE_MESSAGE(id, world.message);
        EvalContext context = world.context();
        Value result;
        for (int i = 0; i < 3; ++i)
            REQUIRE(evaluate(world.code, id, context, result));
        const std::size_t before = allocation_count();
        for (int i = 0; i < 10; ++i)
            evaluate(world.code, id, context, result);
        return allocation_count() - before;
    };
    for (const char* text :
         {"elapsed() > x", "0.5 / (0.2 + 0.05 * elapsed())", "x = x + 1", "x = uniform(-pi, pi)",
          "s = 'a text that is too long for a small buffer'",
          "s == 'another text that is long enough'", "a[1] .. ' and a tail that makes this long'",
          "u = a; o.k = a[2]", "isDefined(nosuch)"}) {
        CAPTURE(text);
        CHECK(allocations(sample_machine(), text) == 0);
    }
    for (const std::string text :
         {"i := i + 1", "d += 1", "s := 'a text that is too long for a small buffer'",
          "i > 2 && s != 'q'"}) {
        CAPTURE(text);
        CHECK(allocations(tree(), text) == 0);
    }
}

}  // namespace trellis
