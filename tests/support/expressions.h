// A small world for tests of expressions: a blackboard, enum constants, sensors and states by name,
// and one call that parses, compiles and evaluates a text in it.
// SPDX-License-Identifier: MIT
#pragma once

#include "exec/evaluate.h"
#include "load/emit.h"
#include "load/expression.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

class ExpressionWorld final : public Names {
public:
    /// The host whose members are _x.bumper, _x.count, _x.range.
    struct Host {
        bool bumper = false;
        std::int32_t count = 0;
        double range = 0;
    };

    explicit ExpressionWorld(Dialect dialect) : dialect_(dialect) {}

    Meaning variable(std::string_view name, Use use) override;
    Meaning sensor(std::string_view name) override;
    Meaning elapsed() override;
    Meaning state(std::string_view name) override;

    /// Makes or overwrites a variable.
    void declare(std::string_view name, Value value, EntryType type = EntryType::any);
    const Value& value_of(std::string_view name);

    /// The constant `name`; before any expression.
    void add_enum(std::string_view name, double value);

    /// Compiles `text`. No id: `message` says why, with the offset before it ("4: expected …").
    CodeId compile(std::string_view text, SyntaxMode mode = SyntaxMode::script);

    /// A context that points at everything here; valid until the next compile() or declare().
    EvalContext context();

    /// What `text` comes to as print() writes it, or "parse error …" or "error …" with the message.
    std::string run(std::string_view text, SyntaxMode mode = SyntaxMode::script);

    Host host;
    Random random{std::int64_t{1}};
    std::vector<std::uint32_t> row_memory = {0};
    std::uint32_t cycle = 0;
    double dt = 0.5;
    bool counts_cycles = false;  ///< elapsed() is elapsed_count, else elapsed_since
    CodeTable code;
    std::vector<std::string> slot_names;
    std::vector<Value> slots;
    std::vector<std::uint8_t> entry_types;
    std::vector<std::uint32_t> writes;
    std::string message;

private:
    Meaning slot(std::string_view name, bool create);

    Dialect dialect_;
    std::vector<Value> scratch_;
};

/// A machine with the variables x = 2, n = 3 (integer), s = 'abc', u, the array a and the object o.
ExpressionWorld sample_machine();

}  // namespace trellis
