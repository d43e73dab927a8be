// What single expressions cost: the guards, ports and scripts that behaviours of robots consist of.
// Goals on the machine of docs' numbers: a guard 5 ns, the spiral's turn rate 9 ns, an assignment
// 12 ns; nothing is allocated.
// SPDX-License-Identifier: MIT
#include "exec/evaluate.h"
#include "load/emit.h"
#include "load/expression.h"

#include <benchmark/benchmark.h>

#include <optional>
#include <string>
#include <vector>

namespace trellis {
namespace {

// variables by name, elapsed() since cycle 0, one sensor
class Bench final : public Names {
public:
    Bench(Dialect dialect, std::string_view text) {
        declare("forward_time", Value::real(1e9));
        declare("angle", Value::real(1.25));
        declare("x", Value::real(0));
        declare("n", Value::integer(0));
        declare("s", Value::text("abcdefghijklmnopqrstuvwxyz"));
        ParseError parse_error;
        std::vector<EmitError> errors;
        const std::optional<Syntax> syntax =
            parse_expression(text, dialect, SyntaxMode::script, parse_error);
        if (syntax) id = emit(*syntax, *this, code, errors);
        scratch.resize(code.temporaries);
        context.use(code, slots.data(), scratch.data());
        context.entry_types = types.data();
        context.row_memory = &start;
        context.dt = 1.0 / 60;
        context.cycle = 100;
        context.random = &random;
        context.host = reinterpret_cast<const std::byte*>(&bumper);
    }

    void declare(std::string_view name, Value value) {
        names.emplace_back(name);
        slots.push_back(std::move(value));
        types.push_back(static_cast<std::uint8_t>(EntryType::any));
    }

    Meaning variable(std::string_view name, Use) override {
        for (std::uint32_t i = 0; i < names.size(); ++i) {
            if (names[i] == name) return {.kind = Meaning::Kind::slot, .index = i};
        }
        return {};
    }
    Meaning sensor(std::string_view) override {
        return {.kind = Meaning::Kind::sensor_boolean, .index = 0};
    }
    Meaning elapsed() override { return {.kind = Meaning::Kind::elapsed_since, .index = 0}; }
    Meaning state(std::string_view) override { return {}; }

    CodeTable code;
    CodeId id;
    EvalContext context;

private:
    std::vector<std::string> names;
    std::vector<Value> slots;
    std::vector<std::uint8_t> types;
    std::vector<Value> scratch;
    Random random{std::int64_t{1}};
    std::uint32_t start = 0;
    bool bumper = false;
};

void condition(benchmark::State& state, Dialect dialect, const char* text) {
    Bench bench(dialect, text);
    for (auto _ : state) {
        ++bench.context.cycle;
        benchmark::DoNotOptimize(evaluate_condition(bench.code, bench.id, bench.context));
    }
}

void real(benchmark::State& state, Dialect dialect, const char* text) {
    Bench bench(dialect, text);
    double result = 0;
    for (auto _ : state) {
        ++bench.context.cycle;
        benchmark::DoNotOptimize(evaluate_real(bench.code, bench.id, bench.context, result));
        benchmark::DoNotOptimize(result);
    }
}

void script(benchmark::State& state, Dialect dialect, const char* text) {
    Bench bench(dialect, text);
    for (auto _ : state)
        benchmark::DoNotOptimize(execute(bench.code, bench.id, bench.context));
}

void parse(benchmark::State& state, Dialect dialect, const char* text) {
    for (auto _ : state)
        benchmark::DoNotOptimize(Bench(dialect, text).id);
}

BENCHMARK_CAPTURE(condition, machine_bumper, Dialect::machine, "_x.bumper");
BENCHMARK_CAPTURE(condition, machine_elapsed, Dialect::machine, "elapsed() > forward_time");
BENCHMARK_CAPTURE(condition, machine_elapsed_angle, Dialect::machine,
                  "elapsed() > abs(angle) / 0.5");
BENCHMARK_CAPTURE(condition, machine_and, Dialect::machine, "x < 1 && angle > 0");
BENCHMARK_CAPTURE(condition, tree_elapsed, Dialect::tree, "elapsed() > forward_time");
BENCHMARK_CAPTURE(condition, tree_text, Dialect::tree, "s == 'abcdefghijklmnopqrstuvwxyz'");
BENCHMARK_CAPTURE(real, constant, Dialect::machine, "0.5");
BENCHMARK_CAPTURE(real, spiral, Dialect::machine, "0.5 / (0.2 + 0.05 * elapsed())");
BENCHMARK_CAPTURE(real, ternary, Dialect::machine, "angle > 0 ? 0.5 : -0.5");
BENCHMARK_CAPTURE(script, machine_count, Dialect::machine, "x = x + 1");
BENCHMARK_CAPTURE(script, machine_uniform, Dialect::machine, "angle = uniform(-pi, pi)");
BENCHMARK_CAPTURE(script, tree_count_real, Dialect::tree, "x := x + 1");
BENCHMARK_CAPTURE(script, tree_count_integer, Dialect::tree, "n := n + 1");
BENCHMARK_CAPTURE(script, tree_add, Dialect::tree, "x += 1");
BENCHMARK_CAPTURE(script, tree_text, Dialect::tree, "s := 'abcdefghijklmnopqrstuvwxyz'");
BENCHMARK_CAPTURE(parse, machine, Dialect::machine, "0.5 / (0.2 + 0.05 * elapsed())");

}  // namespace
}  // namespace trellis
