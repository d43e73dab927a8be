// Characters → tokens. Numbers and texts are read by the rules of the setting: BehaviorTree.CPP's
// or a statechart author's. Covered by tests/load/expression_test.cpp and
// tests/exec/scripts_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/expression_lexer.h"

#include "core/number.h"

#include <array>
#include <charconv>

namespace trellis {
namespace {

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool starts_name(char c) {
    return is_letter(c) || c == '@';
}

// longer symbols first
constexpr std::array<std::string_view, 12> pairs = {
    ":=", "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", ".."};
constexpr std::string_view tree_singles = "+-*/=<>!~&|^?:;.,()[]";
constexpr std::string_view machine_only_singles = "%{}";

class Lexer {
public:
    Lexer(std::string_view text, std::uint32_t offset, Dialect dialect)
        : text_(text), at_(offset), dialect_(dialect) {}

    Token next() {
        while (at_ < text_.size() && is_blank(text_[at_]))
            ++at_;
        token_.offset = static_cast<std::uint32_t>(at_);
        if (at_ == text_.size()) return token_;
        const char c = text_[at_];
        if (is_digit(c) || (machine() && c == '.' && is_digit(peek(1)))) {
            read_number();
        } else if (starts_name(c)) {
            token_.kind = TokenKind::name;
            do
                ++at_;
            while (is_letter(peek(0)) || is_digit(peek(0)));
        } else if (c == '\'' || (machine() && c == '"')) {
            read_text(c);
        } else {
            read_symbol(c);
        }
        token_.length = static_cast<std::uint32_t>(at_) - token_.offset;
        return std::move(token_);
    }

private:
    bool machine() const { return dialect_ == Dialect::machine; }
    char peek(std::size_t ahead) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }

    void fail(std::string message) {
        token_.kind = TokenKind::invalid;
        token_.message = std::move(message);
    }

    void read_number() {
        token_.kind = TokenKind::number;
        if (peek(0) == '0' && (peek(1) | 0x20) == 'x') {
            read_hexadecimal();
        } else {
            read_decimal();
        }
        if (token_.kind == TokenKind::invalid) return;
        const char after = peek(0);
        if (is_letter(after) || (after == '.' && peek(1) != '.')) {
            fail(std::string("a number cannot be followed by \"") + after + '"');
        }
    }

    // an integer that does not fit 64 bits is 0 in trees, as in BehaviorTree.CPP
    void read_hexadecimal() {
        at_ += 2;
        std::uint64_t value = 0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value, 16);
        if (end == begin) return fail("expected hexadecimal digits after 0x");
        at_ += static_cast<std::size_t>(end - begin);
        const bool fits = error == std::errc() && value <= 0x7FFFFFFFFFFFFFFF;
        if (!machine()) {
            token_.value = Value::integer(fits ? static_cast<std::int64_t>(value) : 0);
        } else if (error == std::errc()) {
            token_.value = Value::real(static_cast<double>(value));
        } else {
            fail("the number is too large");
        }
    }

    void read_decimal() {
        const std::size_t begin = at_;
        while (is_digit(peek(0)))
            ++at_;
        const bool fraction =
            peek(0) == '.' && (is_digit(peek(1)) || (machine() && peek(1) != '.'));
        if (fraction) {
            do
                ++at_;
            while (is_digit(peek(0)));
        }
        const bool exponent = (peek(0) | 0x20) == 'e' && read_exponent();
        const std::string_view digits = text_.substr(begin, at_ - begin);
        if (!fraction && !exponent && !machine()) {
            std::int64_t value = 0;
            const auto [end, error] =
                std::from_chars(digits.data(), digits.data() + digits.size(), value);
            token_.value = Value::integer(error == std::errc() ? value : 0);
            return;
        }
        const ParsedNumber number = parse_number(digits);
        if (number.out_of_range) return fail("the number is out of range");
        token_.value = Value::real(number.value);
    }

    // at an e: reads e[+-]digits, or nothing if there are no digits
    bool read_exponent() {
        const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
        if (!is_digit(peek(1 + sign))) return false;
        at_ += 1 + sign;
        while (is_digit(peek(0)))
            ++at_;
        return true;
    }

    void read_text(char quote) {
        token_.kind = TokenKind::text;
        std::string value;
        for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
            if (machine() && text_[at_] == '\\' && at_ + 1 < text_.size()) {
                ++at_;
                const char c = text_[at_];
                value += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
            } else {
                value += text_[at_];
            }
        }
        if (at_ >= text_.size()) {
            at_ = text_.size();
            return fail(std::string("the text has no closing ") + quote);
        }
        ++at_;
        token_.value = Value::text(value);
    }

    void read_symbol(char c) {
        token_.kind = TokenKind::symbol;
        for (std::string_view pair : pairs) {
            if (text_.substr(at_).starts_with(pair)) {
                token_.symbol = symbol(pair);
                at_ += 2;
                return;
            }
        }
        token_.symbol = symbol(std::string_view(&c, 1));
        if (tree_singles.find(c) != std::string_view::npos ||
            (machine() && machine_only_singles.find(c) != std::string_view::npos)) {
            ++at_;
            return;
        }
        // a character of several bytes is shown whole
        do
            ++at_;
        while ((static_cast<unsigned char>(peek(0)) & 0xC0) == 0x80);
        fail("unexpected character \"" +
             std::string(text_.substr(token_.offset, at_ - token_.offset)) + '"');
    }

    std::string_view text_;
    std::size_t at_;
    Dialect dialect_;
    Token token_;
};

}  // namespace

Token next_token(std::string_view text, std::uint32_t offset, Dialect dialect) {
    return Lexer(text, offset, dialect).next();
}

}  // namespace trellis
