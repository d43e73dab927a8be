// Values into members of leaves and back: the conversions of ports, and variables that keep the
// type they were made with.
// SPDX-License-Identifier: MIT
#include "core/ports.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace trellis {
namespace {

constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();

Port port_of(PortType type) {
    Port port;
    port.type = type;
    return port;
}

/// Stores `value` into a member of that type; what the member holds then, or "no".
std::string stored(PortType type, Value value) {
    alignas(std::max_align_t) std::byte member[sizeof(std::string_view)] = {};
    const Port port = port_of(type);
    if (!store_input(port, value, member)) { return "no"; }
    return print(load_output(port, member));
}

/// Writes `value` from a port into a variable that holds `held` and has type `entry`.
std::string written(PortType type, const Value& value, Value held, EntryType entry) {
    std::string why;
    return write_entry(type, value, held, entry, why) ? print(held) : why;
}

}  // namespace

TEST_CASE("ports: a boolean takes 0, 1 and their eight spellings") {
    for (const char* text : {"1", "true", "True", "TRUE"}) {
        CHECK(stored(PortType::boolean, Value::text(text)) == "true");
    }
    for (const char* text : {"0", "false", "False", "FALSE"}) {
        CHECK(stored(PortType::boolean, Value::text(text)) == "false");
    }
    CHECK(stored(PortType::boolean, Value::real(1.0)) == "true");
    CHECK(stored(PortType::boolean, Value::text("yes")) == "no");
    CHECK(stored(PortType::boolean, Value::integer(2)) == "no");
    CHECK(stored(PortType::boolean, Value()) == "no");
}

TEST_CASE("ports: an integer takes whole numbers that fit, as numbers or texts") {
    CHECK(stored(PortType::int32, Value::text("12")) == "12");
    CHECK(stored(PortType::int32, Value::real(-3.0)) == "-3");
    CHECK(stored(PortType::int32, Value::real(2.5)) == "no");
    CHECK(stored(PortType::int32, Value::text("2abc")) == "no");
    CHECK(stored(PortType::int32, Value::integer(2147483647)) == "2147483647");
    CHECK(stored(PortType::int32, Value::integer(2147483648)) == "no");
    CHECK(stored(PortType::int32, Value::integer(-2147483649)) == "no");
    CHECK(stored(PortType::int64, Value::integer(largest)) == "9223372036854775807");
    CHECK(stored(PortType::int64, Value::real(9223372036854775808.0)) == "no");
    CHECK(stored(PortType::int64, Value::real(std::numeric_limits<double>::quiet_NaN())) == "no");
}

TEST_CASE("ports: a real takes numbers and texts that are numbers") {
    CHECK(stored(PortType::real, Value::integer(3)) == "3.0");
    CHECK(stored(PortType::real, Value::text("-1.5e2")) == "-150.0");
    CHECK(stored(PortType::real, Value::boolean(true)) == "1.0");
    CHECK(stored(PortType::real, Value::text("1.5m")) == "no");
    CHECK(stored(PortType::real, Value::text("")) == "no");
    CHECK(stored(PortType::real, Value::array()) == "no");
}

TEST_CASE("ports: a text takes scalars, reals have six decimals as in BehaviorTree.CPP") {
    CHECK(stored(PortType::text, Value::text("as it is")) == "\"as it is\"");
    CHECK(stored(PortType::text, Value::integer(-7)) == "\"-7\"");
    CHECK(stored(PortType::text, Value::real(1.5)) == "\"1.500000\"");
    CHECK(stored(PortType::text, Value::boolean(true)) == "\"true\"");
    CHECK(stored(PortType::text, Value::null()) == "no");
    CHECK(stored(PortType::text, Value()) == "no");
}

TEST_CASE("ports: an untyped member takes anything") {
    CHECK(stored(PortType::any, Value::null()) == "null");
    CHECK(stored(PortType::any, Value::text("t")) == "\"t\"");
}

TEST_CASE("ports: a variable that does not exist gets the type of the port that writes it") {
    Value held;
    EntryType entry = EntryType::missing;
    std::string why;
    CHECK(write_entry(PortType::int32, Value::integer(3), held, entry, why));
    CHECK(entry == EntryType::integer);
    CHECK(held == Value::integer(3));
    CHECK(entry_type(PortType::real) == EntryType::real);
    CHECK(entry_type(PortType::any) == EntryType::any);
}

TEST_CASE("ports: a variable keeps its type, and what does not convert says why") {
    CHECK(written(PortType::text, Value::text("12"), {}, EntryType::integer) == "12");
    CHECK(written(PortType::real, Value::real(2.0), {}, EntryType::integer) == "2");
    CHECK(written(PortType::int32, Value::integer(2), {}, EntryType::real) == "2.0");
    CHECK(written(PortType::real, Value::real(2.5), {}, EntryType::integer) ==
          "2.5 does not fit a variable that holds integers");
    CHECK(written(PortType::int32, Value::integer(1), {}, EntryType::text) ==
          "1 does not fit a variable that holds texts");
    CHECK(written(PortType::text, Value::text("far"), {}, EntryType::real) ==
          "\"far\" does not fit a variable that holds reals");
}

}  // namespace trellis
