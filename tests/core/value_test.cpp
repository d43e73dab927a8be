// Values: kinds, deep copies, reuse of buffers, comparison, hashing, printing, bounded nesting.
// SPDX-License-Identifier: MIT
#include "core/value.h"

#include "support/allocations.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace trellis {
namespace {

Value sample() {
    Value inner = Value::array();
    inner.append(Value::integer(1));
    inner.append(Value::text("two"));
    Value object = Value::object();
    object.set_member("list", std::move(inner));
    object.set_member("none", Value::null());
    return object;
}

// one value of every kind
std::vector<Value> all_kinds() {
    return {Value(),         Value::null(),       Value::boolean(true), Value::integer(-7),
            Value::real(.5), Value::text("text"), Value::array(),       sample()};
}

}  // namespace

TEST_CASE("value: is a regular type of 16 bytes for every kind") {
    for (const Value& v : all_kinds()) {
        CAPTURE(print(v));
        Value copy = v;
        CHECK(copy == v);
        CHECK(copy.hash() == v.hash());
        Value moved = std::move(copy);
        CHECK(moved == v);
        CHECK(copy.is(Value::Kind::undefined));
        for (const Value& other : all_kinds()) {
            Value target = other;
            target = v;
            CHECK(target == v);
            CHECK((v == other) == (v.kind() == other.kind()));
            target = Value(other);
            CHECK(target == other);
        }
        Value& alias = moved;
        moved = alias;
        CHECK(moved == v);
    }
}

TEST_CASE("value: copies share nothing") {
    Value a = sample();
    const Value b = a;
    CHECK(a.set_member("none", Value::integer(1)));
    CHECK(print(a) == R"({"list": [1, "two"], "none": 1})");
    CHECK(print(b) == R"({"list": [1, "two"], "none": null})");
}

TEST_CASE("value: can be assigned from inside itself") {
    Value v = sample();
    v = v.members()[0].value;
    CHECK(print(v) == R"([1, "two"])");
    v = v.element(1);
    CHECK(print(v) == R"("two")");
    Value nested = Value::array();
    nested.append(Value::array());
    nested = nested.element(0);
    CHECK(print(nested) == "[]");
    v.set_text(std::string_view(v.as_text()).substr(1));
    CHECK(print(v) == R"("wo")");
}

TEST_CASE(
    "value: NaN equals NaN and 0.0 differs from -0.0, so that copies are equal and only copies") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(Value::real(nan) == Value::real(nan));
    CHECK_FALSE(Value::real(0.0) == Value::real(-0.0));
    CHECK_FALSE(Value::real(1) == Value::integer(1));
}

TEST_CASE("value: members compare in any order") {
    Value a = Value::object();
    a.set_member("x", Value::integer(1));
    a.set_member("y", Value::integer(2));
    Value b = Value::object();
    b.set_member("y", Value::integer(2));
    b.set_member("x", Value::integer(1));
    CHECK(a == b);
    CHECK(a.hash() == b.hash());
    b.set_member("z", Value());
    CHECK_FALSE(a == b);
    a.set_member("w", Value());
    CHECK_FALSE(a == b);
}

TEST_CASE("value: prints as JSON does, with undefined, inf and nan besides") {
    CHECK(print(Value()) == "undefined");
    CHECK(print(Value::boolean(false)) == "false");
    CHECK(print(Value::integer(5)) == "5");
    CHECK(print(Value::real(5)) == "5.0");
    CHECK(print(Value::real(HUGE_VAL)) == "inf");
    CHECK(print(Value::array()) == "[]");
    CHECK(print(Value::object()) == "{}");
    CHECK(print(Value::text("a\"b\\c\n\t\r\x01")) == R"("a\"b\\c\n\t\r\u0001")");
    CHECK(print(sample()) == R"({"list": [1, "two"], "none": null})");
    CHECK(name_of(Value::Kind::object) == "object");
}

TEST_CASE("value: set_at writes elements and members, and new members, and nothing else") {
    Value v = sample();
    const std::array list_0{Value::text("list"), Value::integer(0)};
    CHECK(v.set_at(list_0, Value::text("one")));
    const std::array fresh{Value::text("fresh")};
    CHECK(v.set_at(fresh, Value::array()));
    CHECK(print(v) == R"({"list": ["one", "two"], "none": null, "fresh": []})");

    const std::array outside{Value::text("list"), Value::integer(2)};
    const std::array negative{Value::text("list"), Value::real(-1)};
    const std::array fraction{Value::text("list"), Value::real(0.5)};
    const std::array below_null{Value::text("none"), Value::text("x")};
    const std::array two_new{Value::text("a"), Value::text("b")};
    const Value before = v;
    for (std::span<const Value> keys :
         {std::span<const Value>(outside), std::span<const Value>(negative),
          std::span<const Value>(fraction), std::span<const Value>(below_null),
          std::span<const Value>(two_new)}) {
        CHECK_FALSE(v.set_at(keys, Value::null()));
    }
    CHECK(v == before);
}

TEST_CASE("value: nests max_depth deep and no deeper") {
    Value v = Value::integer(0);
    for (int i = 0; i < Value::max_depth; ++i) {
        Value outer = Value::array();
        REQUIRE(outer.append(v));
        v = outer;
        CHECK(v.depth() == i + 1);
    }
    Value array = Value::array();
    CHECK_FALSE(array.append(v));
    Value object = Value::object();
    CHECK_FALSE(object.set_member("v", v));

    // through set_at, the outer value learns how deep it has become
    CHECK(array.append(Value::null()));
    const std::array keys{Value::integer(0)};
    CHECK_FALSE(array.set_at(keys, v));
    CHECK(array.set_at(keys, v.element(0)));
    CHECK(array.depth() == Value::max_depth);
    CHECK_FALSE(object.set_member("array", array));
}

TEST_CASE("value: writing a variable again allocates nothing") {
    Value v = Value::text("a text that does not fit into a small buffer");
    const Value other = Value::text("another that is about as long as the first");
    Value array = Value::array();
    for (int i = 0; i < 8; ++i)
        array.append(Value::text("an element that does not fit a small buffer"));
    Value same = array;
    const std::size_t before = allocation_count();
    v = other;
    v.set_text("a third one that must live on the heap too");
    same = array;
    Value number = Value::real(1);
    number = Value::integer(2);
    CHECK(allocation_count() == before);
}

}  // namespace trellis
