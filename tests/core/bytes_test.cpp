// Values through bytes: every kind comes back as it was, and bytes that are no value are refused.
// SPDX-License-Identifier: MIT
#include "core/bytes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace trellis {
namespace {

std::vector<std::byte> bytes_of(const Value& value) {
    ByteWriter out;
    out.put(value);
    return std::move(out).bytes();
}

/// The value that the bytes spell, if all of them do.
bool read_back(const std::vector<std::byte>& bytes, Value& value) {
    ByteReader in(bytes);
    in.get(value);
    return in.ok() && in.at_end();
}

Value nested(int depth) {
    Value value = Value::integer(1);
    for (int i = 0; i < depth; ++i) {
        Value around = Value::array();
        around.append(std::move(value));
        value = std::move(around);
    }
    return value;
}

}  // namespace

TEST_CASE("bytes: every kind of value comes back bit for bit") {
    Value object = Value::object();
    object.set_member("empty", Value::array());
    object.set_member("", Value::text(std::string("\0text", 5)));
    Value array = Value::array();
    array.append(object);
    array.append(Value::real(std::nan("")));
    const Value all[] = {Value(),
                         Value::null(),
                         Value::boolean(true),
                         Value::integer(std::numeric_limits<std::int64_t>::min()),
                         Value::real(-0.0),
                         Value::real(std::numeric_limits<double>::infinity()),
                         Value::text(""),
                         array,
                         nested(Value::max_depth)};
    for (const Value& value : all) {
        Value back;
        CAPTURE(print(value));
        CHECK(read_back(bytes_of(value), back));
        CHECK(back == value);
    }
}

TEST_CASE("bytes: what is cut off or no value is refused") {
    const std::vector<std::byte> whole = bytes_of(nested(3));
    Value value;
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CHECK_FALSE(
            read_back({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}, value));
    }
    CHECK_FALSE(read_back({std::byte{200}}, value));
    // a text and an array that claim to be huge
    for (const int kind : {5, 6, 7}) {
        const std::vector<std::byte> claim = {static_cast<std::byte>(kind), std::byte{255},
                                              std::byte{255}, std::byte{255}, std::byte{255}};
        CHECK_FALSE(read_back(claim, value));
    }
}

TEST_CASE("bytes: values nested too deeply are refused before they take the stack") {
    std::vector<std::byte> deep;
    for (int i = 0; i < 300'000; ++i) {
        for (const int byte : {6, 1, 0, 0, 0}) {
            deep.push_back(static_cast<std::byte>(byte));
        }
    }
    Value value;
    CHECK_FALSE(read_back(deep, value));
}

TEST_CASE("bytes: after a failure nothing more is read") {
    ByteReader in({});
    std::uint32_t number = 7;
    in.get(number);
    CHECK_FALSE(in.ok());
    CHECK(number == 7);
}

}  // namespace trellis
