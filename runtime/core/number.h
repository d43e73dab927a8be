// Numbers as text and back: the one place that spells doubles, so that traces, messages, documents
// and random-number files agree to the last digit on every platform. Integers are the standard
// library's business. Covered by tests/core/number_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trellis {

/// The shortest decimal that reads back as exactly `value`, as Python's repr() writes it: 0.0, 3.2,
/// 1e-05, 1e+16, -0.0, inf, -inf, nan. There is always a point, an exponent or a letter.
std::string print_number(double value);

/// Appends print_number(value) to `out`; allocates only if `out` has to grow.
void append_number(std::string& out, double value);

/// As C's printf("%.17g") does it: always exact, seldom short.
std::string format_g17(double value);

/// Appends what C's printf("%f") and std::to_string write: six digits after the point.
void append_fixed(std::string& out, double value);

/// What a number parser found: its value and how many characters it read (0: no number, and the
/// value is 0).
struct ParsedNumber {
    double value = 0;
    std::size_t length = 0;
    bool out_of_range =
        false;  ///< too large (value is infinite) or too small (value is 0 or denormal)
};

/// Reads the longest number at the very start of `text`: digits with optional point and exponent,
/// `inf`, `infinity` and `nan` in any case, an optional minus sign; no plus sign, no blanks. The
/// nearest double.
ParsedNumber parse_number(std::string_view text);

/// Reads one number that is the whole of `text`: what parse_number reads, with an optional plus
/// sign, or a hexadecimal float as C and Python write it (-0x1.aa809da4227e9p+0). length is
/// text.size() or 0; nothing is trimmed.
ParsedNumber parse_whole_number(std::string_view text);

/// The seconds of a duration as SCXML and CSS2 write it: a number that is not negative and ms, s,
/// m, h or d (no unit: ms), with blanks around it or not. Nothing for other texts.
std::optional<double> parse_duration(std::string_view text);

}  // namespace trellis
