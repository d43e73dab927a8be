// Doubles as text and back: Python's spelling, exact round trips, prefixes, hexadecimal floats.
// SPDX-License-Identifier: MIT
#include "core/number.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace trellis {

TEST_CASE("number: prints as Python's repr does") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(print_number(0.0) == "0.0");
    CHECK(print_number(-0.0) == "-0.0");
    CHECK(print_number(3.2) == "3.2");
    CHECK(print_number(-17) == "-17.0");
    CHECK(print_number(1.0 / 60) == "0.016666666666666666");
    CHECK(print_number(0.1 + 0.2) == "0.30000000000000004");
    CHECK(print_number(0.0001) == "0.0001");
    CHECK(print_number(0.00012345) == "0.00012345");
    CHECK(print_number(0.00001) == "1e-05");
    CHECK(print_number(1.5e-7) == "1.5e-07");
    CHECK(print_number(123456.789) == "123456.789");
    CHECK(print_number(1e15) == "1000000000000000.0");
    CHECK(print_number(9007199254740993.0) == "9007199254740992.0");
    CHECK(print_number(1e16) == "1e+16");
    CHECK(print_number(1.2345e22) == "1.2345e+22");
    CHECK(print_number(std::numeric_limits<double>::max()) == "1.7976931348623157e+308");
    CHECK(print_number(std::numeric_limits<double>::denorm_min()) == "5e-324");
    CHECK(print_number(HUGE_VAL) == "inf");
    CHECK(print_number(-HUGE_VAL) == "-inf");
    CHECK(print_number(nan) == "nan");
    CHECK(print_number(-nan) == "nan");
    CHECK(format_g17(0.1) == "0.10000000000000001");
    CHECK(format_g17(-2) == "-2");
    std::string fixed = "a";
    append_fixed(fixed, 1.5);
    append_fixed(fixed, -2.0 / 3);
    CHECK(fixed == "a1.500000-0.666667");
}

TEST_CASE("number: what is printed reads back as the same bits") {
    std::mt19937_64 engine(7);
    for (int i = 0; i < 100'000; ++i) {
        const auto number = std::bit_cast<double>(engine());
        if (std::isnan(number)) continue;
        const std::string text = print_number(number);
        for (const ParsedNumber& parsed :
             {parse_number(text), parse_whole_number(text), parse_number(format_g17(number))}) {
            REQUIRE_MESSAGE(std::bit_cast<std::uint64_t>(parsed.value) ==
                                std::bit_cast<std::uint64_t>(number),
                            text);
        }
        REQUIRE(parse_number(text).length == text.size());
    }
}

TEST_CASE("number: reads the longest number at the start") {
    const auto prefix = [](std::string_view text, double value, std::size_t length) {
        CAPTURE(text);
        const ParsedNumber parsed = parse_number(text);
        CHECK(parsed.value == value);
        CHECK(parsed.length == length);
        CHECK_FALSE(parsed.out_of_range);
    };
    prefix("12x", 12, 2);
    prefix("2abc", 2, 1);
    prefix("-1.5e3;", -1500, 6);
    prefix("1e", 1, 1);
    prefix("1e+", 1, 1);
    prefix("1.e2", 100, 4);
    prefix(".5", 0.5, 2);
    prefix("5.", 5, 2);
    prefix("INF", HUGE_VAL, 3);
    prefix("-infinitive", -HUGE_VAL, 4);
    prefix("Infinity", HUGE_VAL, 8);
    prefix("", 0, 0);
    prefix(".", 0, 0);
    prefix("-", 0, 0);
    prefix("+1", 0, 0);
    prefix(" 1", 0, 0);
    prefix("abc", 0, 0);
    CHECK(std::isnan(parse_number("nan(1)").value));
    CHECK(parse_number("1e400").out_of_range);
    CHECK(parse_number("1e400").value == HUGE_VAL);
    CHECK(parse_number("1e-400").out_of_range);
}

TEST_CASE("number: reads whole texts, hexadecimal floats among them") {
    const auto whole = [](std::string_view text) {
        const ParsedNumber parsed = parse_whole_number(text);
        return parsed.length == text.size() ? parsed.value : -99;
    };
    CHECK(whole("-0x1.aa809da4227e9p+0") == -0x1.aa809da4227e9p+0);
    CHECK(whole("0x1.921fb54442d18p+1") == 3.141592653589793);
    CHECK(whole("0X1P-1074") == std::numeric_limits<double>::denorm_min());
    CHECK(whole("0x.8") == 0.5);
    CHECK(whole("0x10") == 16);
    CHECK(whole("+2.5") == 2.5);
    CHECK(whole("+0x1p3") == 8);
    for (const char* text : {"", "1x", "0x", "0x.", "0xp1", "0x1p", "0x1p+", "0x1.2.3", "+-1",
                             "-+1", "--1", " 1", "1 ", "0x1p999999999", "0x11111111111111111"}) {
        CAPTURE(text);
        CHECK(parse_whole_number(text).length == 0);
    }
    CHECK(parse_whole_number("0x1p1024").out_of_range);
}

}  // namespace trellis
