// Text of the expression language → syntax. One language, two settings (core/code.h, Dialect):
// SPDX-License-Identifier: MIT

//   script      trees:    expression { [";"...] expression }
//               machines: [ expression { ";" expression } ]
//   expression  ternary [ (":=" "=" "+=" "-=" "*=" "/=") expression ]
//   ternary     binary [ "?" expression ":" ternary ]
//   binary      trees, loosest first:    || && == != < <= > >= (chained) | ^ & + - .. * /
//               machines, loosest first: || && | ^ & == != < <= > >= + - .. * / %
//   unary       { "-" "~" "!" } postfix
//   postfix     primary { "." name | "[" expression "]" | "(" arguments ")" }
//
// In trees texts are '...' without escapes, and a call is the name of a known function directly
// before "(" (what BehaviorTree.CPP reads there is two expressions). Machines add "..." texts with
// escapes, `.5` and `5.`, null, undefined, [1, 2], {key: 1}; their numbers are all real. Nothing is
// resolved or checked here: that is load/emit.h. Covered by tests/load/expression_test.cpp and
// tests/exec/scripts_test.cpp.
#pragma once

#include "core/code.h"
#include "core/value.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// What a text is to be. location: a variable or a place below one (x, x.y[2]).
enum class SyntaxMode : std::uint8_t { script, single_expression, location };

enum class SyntaxKind : std::uint8_t {
    literal,      ///< Syntax::literals[index]
    name,         ///< Syntax::names[index]
    path,         ///< child 0 is the base, the others are keys: x.y[2] has the keys 'y' and 2
    unary,        ///< op: negate, complement, logical_not
    binary,       ///< op: add … concatenate, less … not_equal, logical_and, logical_or
    comparisons,  ///< trees: a < b == c; op i between children i and i + 1 is
                  ///< Syntax::operators[index + i]
    conditional,  ///< condition, then, else
    assignment,   ///< place, value; op: declare (:=), assign (=), assign_add …
    call,         ///< Syntax::names[index] of the children
    array,        ///< children are the elements
    object,       ///< children are key literals and values by turns
    sequence      ///< children are the expressions of a script
};

struct SyntaxNode {
    SyntaxKind kind = SyntaxKind::literal;
    CodeOp op = CodeOp::copy;  ///< of unary, binary and assignment
    bool assigns = false;      ///< it or something below it is an assignment
    std::uint16_t height = 1;  ///< nodes on the longest way down
    std::uint32_t offset = 0;  ///< byte of the text: of the operator, or where it begins
    std::uint32_t first = 0;   ///< its children are Syntax::children[first, first + count)
    std::uint32_t count = 0;
    std::uint32_t index = 0;
};

/// A whole text; flat, without pointers.
struct Syntax {
    Dialect dialect = Dialect::tree;
    std::uint32_t root = 0;  ///< in nodes
    std::vector<SyntaxNode> nodes;
    std::vector<std::uint32_t> children;
    std::vector<Value> literals;
    std::vector<std::string> names;
    std::vector<CodeOp> operators;

    std::span<const std::uint32_t> children_of(const SyntaxNode& node) const {
        return std::span(children).subspan(node.first, node.count);
    }
};

/// Where a text stops making sense and why, for example `expected an operand, found ")"`.
struct ParseError {
    std::uint32_t offset = 0;
    std::string message;
};

/// Expressions nest at most this deep.
inline constexpr std::uint16_t max_syntax_height = 250;

/// Reads `text`. Empty, and `error`, if it does not follow the grammar or nests too deeply. Linear
/// in its length.
std::optional<Syntax> parse_expression(std::string_view text, Dialect dialect, SyntaxMode mode,
                                       ParseError& error);

/// Whether `name(...)` is a call: one of functions() or abs, elapsed, In, isDefined.
bool is_function(std::string_view name);

/// All names for which is_function() holds, sorted, for suggestions and the manual.
std::vector<std::string_view> function_names();

}  // namespace trellis
