// Property: whatever the text, both settings of the expression language parse it or say why not,
// and what parses runs to an end: a value or an error with words.
// SPDX-License-Identifier: MIT
#include "exec/evaluate.h"
#include "load/emit.h"
#include "load/expression.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace trellis;

/// Every name is one of eight variables.
class FewNames final : public Names {
public:
    Meaning variable(std::string_view name, Use) override {
        std::uint32_t sum = 0;
        for (const char c : name) {
            sum += static_cast<unsigned char>(c);
        }
        return {.kind = Meaning::Kind::slot, .index = sum % 8, .value = {}, .message = {}};
    }
    Meaning sensor(std::string_view) override {
        return {.kind = Meaning::Kind::error, .value = {}, .message = "no sensors"};
    }
    Meaning elapsed() override {
        return {.kind = Meaning::Kind::elapsed_count, .index = 0, .value = {}, .message = {}};
    }
    Meaning state(std::string_view) override {
        return {.kind = Meaning::Kind::error, .value = {}, .message = "no states"};
    }
};

void run(std::string_view text, Dialect dialect) {
    ParseError wrong;
    const std::optional<Syntax> syntax = parse_expression(text, dialect, SyntaxMode::script, wrong);
    if (!syntax) { return; }
    FewNames names;
    CodeTable code;
    std::vector<EmitError> errors;
    const CodeId id = emit(*syntax, names, code, errors);
    if (!id) { return; }
    std::vector<Value> slots(8);
    slots[1] = Value::integer(3);
    slots[2] = Value::text("text");
    slots[3] = Value::real(1.5);
    std::vector<std::uint8_t> types(8, static_cast<std::uint8_t>(EntryType::any));
    std::vector<Value> scratch(code.temporaries);
    const std::uint32_t memory = 4;
    Random random(std::int64_t{1});
    EvalContext context;
    context.use(code, slots.data(), scratch.data());
    context.entry_types = types.data();
    context.row_memory = &memory;
    context.dt = 0.5;
    context.random = &random;
    Value result;
    if (!evaluate(code, id, context, result)) { static_cast<void>(describe(context.error, code)); }
    static_cast<void>(evaluate_condition(code, id, context));
    static_cast<void>(print(result));
    static_cast<void>(dump(code));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    run(text, Dialect::tree);
    run(text, Dialect::machine);
    return 0;
}
