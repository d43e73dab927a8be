// A value of the expression language: undefined, null, boolean, integer, real, text, array or
// object. A regular type of 16 bytes that owns its payload: copies are deep, moves are cheap,
// nothing is shared. Copying, assigning and destroying a scalar is a few inlined instructions;
// assigning a text to a value that holds a text reuses its buffer, so variables that are written
// again and again allocate nothing. What operators mean is not said here (exec/evaluate.h). Covered
// by tests/core/value_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

struct Member;

class Value {
public:
    /// Kinds from `text` on own a payload on the heap.
    enum class Kind : std::uint8_t { undefined, null, boolean, integer, real, text, array, object };

    /// Arrays and objects nest at most this deep; append() and set_member() refuse to go deeper, so
    /// that every recursion over a value is bounded.
    static constexpr std::uint8_t max_depth = 64;

    Value() = default;  ///< undefined
    Value(const Value& other) : kind_(other.kind_), depth_(other.depth_), payload_(other.payload_) {
        if (owns()) copy_payload(other);
    }
    Value(Value&& other) noexcept
        : kind_(other.kind_), depth_(other.depth_), payload_(other.payload_) {
        other.kind_ = Kind::undefined;
        other.depth_ = 0;
    }
    Value& operator=(const Value& other) {
        if (owns() || other.owns()) {
            assign_payload(other);
        } else {
            kind_ = other.kind_;
            payload_ = other.payload_;
        }
        return *this;
    }
    Value& operator=(Value&& other) noexcept {
        if (this == &other) return *this;
        if (owns()) release();
        kind_ = other.kind_;
        depth_ = other.depth_;
        payload_ = other.payload_;
        other.kind_ = Kind::undefined;
        other.depth_ = 0;
        return *this;
    }
    ~Value() {
        if (owns()) release();
    }

    // makers: static, so that no implicit conversion turns a pointer into a boolean
    static Value null() { return Value(Kind::null, Payload{}); }
    static Value boolean(bool value) { return Value(Kind::boolean, Payload{.integer = value}); }
    static Value integer(std::int64_t value) {
        return Value(Kind::integer, Payload{.integer = value});
    }
    static Value real(double value) { return Value(Kind::real, Payload{.real = value}); }
    static Value text(std::string_view value);
    static Value array();   ///< with no elements
    static Value object();  ///< with no members

    // setters: like assigning a made value, but a payload of the same kind is reused
    void set_undefined() { set_scalar(Kind::undefined, Payload{}); }
    void set_boolean(bool value) { set_scalar(Kind::boolean, Payload{.integer = value}); }
    void set_integer(std::int64_t value) { set_scalar(Kind::integer, Payload{.integer = value}); }
    void set_real(double value) { set_scalar(Kind::real, Payload{.real = value}); }
    void set_text(std::string_view value);  ///< `value` may lie inside this value
    void set_array();                       ///< to an array with no elements
    void set_object();                      ///< to an object with no members

    Kind kind() const { return kind_; }
    bool is(Kind kind) const { return kind_ == kind; }
    bool is_number() const { return kind_ == Kind::integer || kind_ == Kind::real; }

    // readers: the value must be of that kind (asserted)
    bool as_boolean() const { return payload_.integer != 0; }
    std::int64_t as_integer() const { return payload_.integer; }
    double as_real() const { return payload_.real; }
    const std::string& as_text() const { return *payload_.text; }
    std::string& as_text() { return *payload_.text; }
    std::span<const Value> elements() const;  ///< of an array
    std::span<const Member> members() const;  ///< of an object, in the order of their creation

    /// The number as a double: of an integer, a real or a boolean (0 or 1).
    double number() const {
        return kind_ == Kind::real ? payload_.real : static_cast<double>(payload_.integer);
    }

    /// Element `index` of an array; the array must be that long.
    const Value& element(std::size_t index) const { return elements()[index]; }

    /// The member called `key` of an object, nullptr if it has none.
    const Value* member(std::string_view key) const;

    /// What lies directly below this value under `key`: the member that a text names, the element
    /// that a whole number names. nullptr if there is none.
    const Value* child(const Value& key) const;

    /// 0 for scalars and texts, 1 for arrays and objects of those, and so on; never less than the
    /// true depth.
    std::uint8_t depth() const { return depth_; }

    /// Adds an element at the end of an array. False, and no change, if that would nest deeper than
    /// max_depth.
    bool append(Value value);

    /// Takes the first element from an array and returns it; undefined if there is none.
    Value take_first();

    /// Adds or overwrites a member of an object. False, and no change, if that would nest deeper
    /// than max_depth.
    bool set_member(std::string_view key, Value value);

    /// The member called `key` of an object, made undefined if it has none: to be set in place, to
    /// scalars and texts only.
    Value& flat_member(std::string_view key);

    /// Writes `value` to the place below this value that `keys` name: texts for members of objects,
    /// whole numbers for elements of arrays. The last key may name a new member of an object.
    /// False, and no change, if there is no such place or it would nest deeper than max_depth.
    bool set_at(std::span<const Value> keys, const Value& value);

    /// Exact and structural: same kind and same content. Unlike the operators of the expression
    /// language, two NaNs are equal here and 0.0 and -0.0 are not (bit for bit), so that a copied
    /// state always equals its original. Members of objects compare in any order.
    friend bool operator==(const Value& a, const Value& b) {
        if (a.kind_ != b.kind_) return false;
        return a.owns() ? equal_payload(a, b) : a.payload_.integer == b.payload_.integer;
    }

    /// Equal values have equal hashes; the same on every platform.
    std::uint64_t hash() const;

private:
    // every scalar fills the 8 bytes, so that comparing them as integers compares bits
    union Payload {
        std::int64_t integer = 0;
        double real;
        std::string* text;
        std::vector<Value>* array;
        std::vector<Member>* object;
    };

    Value(Kind kind, Payload payload) : kind_(kind), payload_(payload) {}

    bool owns() const { return kind_ >= Kind::text; }
    void set_scalar(Kind kind, Payload payload) {
        if (owns()) release();
        kind_ = kind;
        payload_ = payload;
    }
    void copy_payload(const Value& other);
    void assign_payload(const Value& other);
    void release() noexcept;
    static bool equal_payload(const Value& a, const Value& b);

    Kind kind_ = Kind::undefined;
    std::uint8_t depth_ = 0;
    Payload payload_ = {};
};

static_assert(sizeof(Value) == 16);

/// One member of an object.
struct Member {
    std::string key;
    Value value;

    friend bool operator==(const Member&, const Member&) = default;
};

/// How messages and `type(x)` name a kind: "undefined", "null", "boolean", "integer", "real",
/// "text", "array", "object".
std::string_view name_of(Value::Kind kind);

/// The value as JSON writes it, extended by `undefined`, `inf` and `nan`; integers without, reals
/// with a point or an exponent: [1, 2.5, "a", {"k": null}].
std::string print(const Value& value);

}  // namespace trellis
