// Doubles as text and back by std::to_chars and std::from_chars where the standard library has them
// for doubles, else (libc++ before 14, which Debian's emscripten brings) by snprintf and strtod in
// the C locale that such builds run in. Covered by tests/core/number_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace trellis {
namespace {

// "d[.ddd]e[+-]dd": the shortest digits that read back as `value`
std::string_view shortest_scientific(std::array<char, 40>& buffer, double value) {
#ifdef __cpp_lib_to_chars
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::scientific);
    return {buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data())};
#else
    int length = 0;
    for (int digits = 0; digits <= 16; ++digits) {
        length = std::snprintf(buffer.data(), buffer.size(), "%.*e", digits, value);
        if (std::strtod(buffer.data(), nullptr) == value) break;
    }
    return {buffer.data(), static_cast<std::size_t>(length)};
#endif
}

// the length of the decimal number at the start of `text`, 0 if there is none: the grammar of
// from_chars
std::size_t number_length(std::string_view text) {
    const auto digits = [&](std::size_t at) {
        while (at < text.size() && text[at] >= '0' && text[at] <= '9')
            ++at;
        return at;
    };
    const std::size_t start = text.starts_with('-') ? 1 : 0;
    std::size_t end = digits(start);
    std::size_t count = end - start;
    if (end < text.size() && text[end] == '.') {
        const std::size_t fraction = digits(end + 1);
        count += fraction - end - 1;
        if (count > 0) end = fraction;
    }
    if (count == 0) return 0;
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        std::size_t exponent = end + 1;
        if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
        if (digits(exponent) > exponent) end = digits(exponent);
    }
    return end;
}

// does `text` start with the lower-case `word`, in any case?
bool starts_with_word(std::string_view text, std::string_view word) {
    if (text.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if ((text[i] | 0x20) != word[i]) return false;
    }
    return true;
}

ParsedNumber parse_decimal(std::string_view text) {
    ParsedNumber result{.length = text.size()};
#ifdef __cpp_lib_to_chars
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result.value);
    result.out_of_range = error == std::errc::result_out_of_range;
    if (!result.out_of_range) return result;
#endif
    // from_chars leaves the value alone when it is out of range; strtod says infinity or 0
    result.value = std::strtod(std::string(text).c_str(), nullptr);
    result.out_of_range |= std::isinf(result.value);
    return result;
}

// "h.hhhp[+-]dd" after the 0x; the digits of one double fit 64 bits, so that nothing is rounded
// twice
ParsedNumber parse_hexadecimal(std::string_view text) {
    std::uint64_t mantissa = 0;
    int exponent = 0;
    std::size_t at = 0;
    bool fraction = false;
    bool digits = false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '.' && !fraction) {
            fraction = true;
            continue;
        }
        int digit = -1;
        if (c >= '0' && c <= '9') digit = c - '0';
        if ((c | 0x20) >= 'a' && (c | 0x20) <= 'f') digit = (c | 0x20) - 'a' + 10;
        if (digit < 0) break;
        if (mantissa >> 60 != 0) return {};
        mantissa = mantissa * 16 + static_cast<std::uint64_t>(digit);
        if (fraction) exponent -= 4;
        digits = true;
    }
    if (!digits) return {};
    if (at < text.size()) {
        if ((text[at] | 0x20) != 'p') return {};
        ++at;
        if (at < text.size() && text[at] == '+') ++at;
        int power = 0;
        const auto [end, error] =
            std::from_chars(text.data() + at, text.data() + text.size(), power);
        if (error != std::errc() || end != text.data() + text.size()) return {};
        if (power > 100'000 || power < -100'000) return {};
        exponent += power;
    }
    const double value = std::ldexp(static_cast<double>(mantissa), exponent);
    return {.value = value,
            .length = text.size(),
            .out_of_range = std::isinf(value) || (value == 0 && mantissa != 0)};
}

}  // namespace

void append_number(std::string& out, double value) {
    if (std::isnan(value)) {
        out += "nan";
        return;
    }
    if (std::signbit(value)) out += '-';
    if (std::isinf(value)) {
        out += "inf";
        return;
    }
    std::array<char, 40> buffer;
    const std::string_view text = shortest_scientific(buffer, std::fabs(value));
    const std::size_t e = text.find('e');
    int exponent = 0;
    const char* sign = text.data() + e + 1;
    std::from_chars(*sign == '+' ? sign + 1 : sign, text.data() + text.size(), exponent);

    // Python: plain digits for exponents from -4 to 15, else the exponent has at least two digits
    if (exponent < -4 || exponent >= 16) {
        out += text;
        return;
    }
    const char first = text[0];
    const std::string_view rest = e > 1 ? text.substr(2, e - 2) : std::string_view();
    if (exponent < 0) {
        out += "0.";
        out.append(static_cast<std::size_t>(-exponent - 1), '0');
        out += first;
        out += rest;
        return;
    }
    const auto whole = static_cast<std::size_t>(exponent);  // digits of `rest` before the point
    out += first;
    out += rest.substr(0, whole);
    if (rest.size() < whole) out.append(whole - rest.size(), '0');
    out += '.';
    out += rest.size() > whole ? rest.substr(whole) : std::string_view("0");
}

std::string print_number(double value) {
    std::string out;
    append_number(out, value);
    return out;
}

std::string format_g17(double value) {
    std::array<char, 32> buffer;
    const int length = std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
    return {buffer.data(), static_cast<std::size_t>(length)};
}

void append_fixed(std::string& out, double value) {
    // the largest double has 309 digits before the point
    std::array<char, 330> buffer;
    const int length = std::snprintf(buffer.data(), buffer.size(), "%f", value);
    out.append(buffer.data(), static_cast<std::size_t>(length));
}

ParsedNumber parse_number(std::string_view text) {
    const std::size_t length = number_length(text);
    if (length > 0) return parse_decimal(text.substr(0, length));

    const std::size_t start = text.starts_with('-') ? 1 : 0;
    const double sign = start == 1 ? -1 : 1;
    const std::string_view word = text.substr(start);
    if (starts_with_word(word, "infinity")) return {.value = sign * HUGE_VAL, .length = start + 8};
    if (starts_with_word(word, "inf")) return {.value = sign * HUGE_VAL, .length = start + 3};
    if (starts_with_word(word, "nan")) {
        return {.value = std::copysign(std::nan(""), sign), .length = start + 3};
    }
    return {};
}

ParsedNumber parse_whole_number(std::string_view text) {
    const bool negative = text.starts_with('-');
    const std::string_view digits = text.substr(negative || text.starts_with('+') ? 1 : 0);
    if (digits.starts_with('-')) return {};
    const bool hexadecimal = starts_with_word(digits, "0x");
    ParsedNumber result = hexadecimal ? parse_hexadecimal(digits.substr(2)) : parse_number(digits);
    if (result.length == 0 || result.length + (hexadecimal ? 2 : 0) != digits.size()) return {};
    if (negative) result.value = -result.value;
    result.length = text.size();
    return result;
}

std::optional<double> parse_duration(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
    text.remove_prefix(first);
    text = text.substr(0, text.find_last_not_of(blanks) + 1);
    const ParsedNumber number = parse_number(text);
    const std::string_view unit = text.substr(number.length);
    const bool is_digit =
        number.length != 0 && (text[0] == '.' || (text[0] >= '0' && text[0] <= '9'));
    if (!is_digit || number.out_of_range) { return {}; }
    if (unit == "ms" || unit.empty()) { return number.value * 0.001; }
    if (unit == "s") { return number.value; }
    if (unit == "m") { return number.value * 60; }
    if (unit == "h") { return number.value * 3600; }
    if (unit == "d") { return number.value * 86400; }
    return {};
}

}  // namespace trellis
