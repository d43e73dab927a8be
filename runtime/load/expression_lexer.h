// Tokens of the expression language, one at a time. Internal to load/expression.cpp; what the
// characters mean together is the parser's business. Covered by tests/load/expression_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/code.h"
#include "core/value.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace trellis {

enum class TokenKind : std::uint8_t { end, number, text, name, symbol, invalid };

/// The symbols of both settings, as their characters read as a base-256 number: symbol(":=").
constexpr std::uint16_t symbol(std::string_view characters) {
    std::uint16_t code = 0;
    for (char c : characters)
        code = static_cast<std::uint16_t>(code << 8 | static_cast<unsigned char>(c));
    return code;
}

struct Token {
    TokenKind kind = TokenKind::end;
    std::uint16_t symbol = 0;  ///< of a symbol
    std::uint32_t offset = 0;  ///< of its first byte
    std::uint32_t length = 0;  ///< in bytes
    Value value;               ///< of a number or text
    std::string message;       ///< of an invalid token

    bool is(std::uint16_t wanted) const { return kind == TokenKind::symbol && symbol == wanted; }
};

/// Reads the token that begins at or after `offset`, behind blanks. Its end is offset + length.
Token next_token(std::string_view text, std::uint32_t offset, Dialect dialect);

}  // namespace trellis
