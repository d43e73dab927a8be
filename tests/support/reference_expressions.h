// A slow, obvious evaluator of machine expressions, straight over the syntax tree: what the
// compiled code must agree with. It shares only Value and the parser with the product.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/value.h"
#include "load/expression.h"

#include <map>
#include <optional>
#include <string>

namespace trellis {

struct ReferenceEvaluator {
    std::map<std::string, Value> variables;  ///< all that exist

    /// The value of `syntax` (Dialect::machine); nothing if its evaluation fails.
    std::optional<Value> evaluate(const Syntax& syntax) { return value(syntax, syntax.root); }

private:
    using Result = std::optional<Value>;

    Result value(const Syntax& s, std::uint32_t n);
    Result binary(const Syntax& s, const SyntaxNode& node);
    Result path(const Syntax& s, const SyntaxNode& node);
    Result assignment(const Syntax& s, const SyntaxNode& node);
    Result call(const Syntax& s, const SyntaxNode& node);
    bool store(const Syntax& s, std::uint32_t place, const Value& value);
};

}  // namespace trellis
