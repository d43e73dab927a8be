// The owned payloads of values: texts, arrays, objects. Scalars never come here (core/value.h).
// Covered by tests/core/value_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/value.h"

#include "core/number.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace trellis {
namespace {

// FNV-1a over bytes, finished by a multiplication so that short inputs spread over all 64 bits
std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return hash ^ hash >> 32;
}

std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return hash;
}

const Member* find(const std::vector<Member>& members, std::string_view key) {
    for (const Member& m : members) {
        if (m.key == key) return &m;
    }
    return nullptr;
}

void print_text(std::string& out, std::string_view text) {
    out += '"';
    for (char c : text) {
        switch (c) {
        case '"': out += "\\\""; break;
        case '\\': out += "\\\\"; break;
        case '\n': out += "\\n"; break;
        case '\t': out += "\\t"; break;
        case '\r': out += "\\r"; break;
        default:
            if (static_cast<unsigned char>(c) < 0x20) {
                constexpr std::string_view digits = "0123456789abcdef";
                out += "\\u00";
                out += digits[static_cast<unsigned char>(c) >> 4];
                out += digits[static_cast<unsigned char>(c) & 15];
            } else {
                out += c;
            }
        }
    }
    out += '"';
}

void print_to(std::string& out, const Value& value) {
    switch (value.kind()) {
    case Value::Kind::undefined: out += "undefined"; return;
    case Value::Kind::null: out += "null"; return;
    case Value::Kind::boolean: out += value.as_boolean() ? "true" : "false"; return;
    case Value::Kind::integer: out += std::to_string(value.as_integer()); return;
    case Value::Kind::real: append_number(out, value.as_real()); return;
    case Value::Kind::text: print_text(out, value.as_text()); return;
    case Value::Kind::array: {
        const char* separator = "[";
        for (const Value& v : value.elements()) {
            out += std::exchange(separator, ", ");
            print_to(out, v);
        }
        out += value.elements().empty() ? "[]" : "]";
        return;
    }
    case Value::Kind::object: {
        const char* separator = "{";
        for (const Member& m : value.members()) {
            out += std::exchange(separator, ", ");
            print_text(out, m.key);
            out += ": ";
            print_to(out, m.value);
        }
        out += value.members().empty() ? "{}" : "}";
        return;
    }
    }
}

}  // namespace

Value Value::text(std::string_view value) {
    return Value(Kind::text, Payload{.text = new std::string(value)});
}

Value Value::array() {
    Value value(Kind::array, Payload{.array = new std::vector<Value>});
    value.depth_ = 1;
    return value;
}

Value Value::object() {
    Value value(Kind::object, Payload{.object = new std::vector<Member>});
    value.depth_ = 1;
    return value;
}

void Value::set_text(std::string_view value) {
    if (kind_ == Kind::text) {
        payload_.text->assign(value);
    } else {
        *this = text(value);
    }
}

void Value::set_array() {
    if (kind_ == Kind::array) {
        payload_.array->clear();
        depth_ = 1;
    } else {
        *this = array();
    }
}

void Value::set_object() {
    if (kind_ == Kind::object) {
        payload_.object->clear();
        depth_ = 1;
    } else {
        *this = object();
    }
}

std::span<const Value> Value::elements() const {
    assert(kind_ == Kind::array);
    return *payload_.array;
}

std::span<const Member> Value::members() const {
    assert(kind_ == Kind::object);
    return *payload_.object;
}

const Value* Value::member(std::string_view key) const {
    assert(kind_ == Kind::object);
    const Member* found = find(*payload_.object, key);
    return found != nullptr ? &found->value : nullptr;
}

Value& Value::flat_member(std::string_view key) {
    if (member(key) == nullptr) { static_cast<void>(set_member(key, {})); }
    for (Member& found : *payload_.object) {
        if (found.key == key) { return found.value; }
    }
    return *this;  // not reached: the member is there
}

bool Value::append(Value value) {
    assert(kind_ == Kind::array);
    if (value.depth_ >= max_depth) return false;
    depth_ = std::max(depth_, static_cast<std::uint8_t>(value.depth_ + 1));
    payload_.array->push_back(std::move(value));
    return true;
}

Value Value::take_first() {
    assert(kind_ == Kind::array);
    if (payload_.array->empty()) return {};
    Value first = std::move(payload_.array->front());
    payload_.array->erase(payload_.array->begin());
    return first;
}

bool Value::set_member(std::string_view key, Value value) {
    assert(kind_ == Kind::object);
    if (value.depth_ >= max_depth) return false;
    depth_ = std::max(depth_, static_cast<std::uint8_t>(value.depth_ + 1));
    if (const Member* found = find(*payload_.object, key)) {
        const_cast<Member*>(found)->value = std::move(value);
    } else {
        payload_.object->push_back(Member{.key = std::string(key), .value = std::move(value)});
    }
    return true;
}

const Value* Value::child(const Value& key) const {
    if (kind_ == Kind::object) return key.is(Kind::text) ? member(*key.payload_.text) : nullptr;
    if (kind_ != Kind::array || !key.is_number()) return nullptr;
    // written so that NaN fails too
    const double index = key.number();
    if (!(index >= 0 && index < static_cast<double>(payload_.array->size()))) return nullptr;
    const auto whole = static_cast<std::size_t>(index);
    return static_cast<double>(whole) == index ? &(*payload_.array)[whole] : nullptr;
}

bool Value::set_at(std::span<const Value> keys, const Value& value) {
    if (value.depth_ + keys.size() > max_depth) return false;
    Value* at = this;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        auto* next = const_cast<Value*>(at->child(keys[i]));
        if (next == nullptr) {
            if (i + 1 < keys.size() || !at->is(Kind::object) || !keys[i].is(Kind::text))
                return false;
            next = &at->payload_.object
                        ->emplace_back(Member{.key = keys[i].as_text(), .value = Value()})
                        .value;
        }
        at = next;
    }
    *at = value;
    // the way down is walked a second time, because only now is it certain that the place exists
    at = this;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        at->depth_ =
            std::max(at->depth_, static_cast<std::uint8_t>(value.depth_ + keys.size() - i));
        at = const_cast<Value*>(at->child(keys[i]));
    }
    return true;
}

std::uint64_t Value::hash() const {
    std::uint64_t hash = mix(0x84222325u, static_cast<std::uint64_t>(kind_));
    switch (kind_) {
    case Kind::undefined:
    case Kind::null:
    case Kind::boolean:
    case Kind::integer:
    case Kind::real: return mix(hash, static_cast<std::uint64_t>(payload_.integer));
    case Kind::text: return mix(hash, hash_of(*payload_.text));
    case Kind::array:
        for (const Value& v : *payload_.array)
            hash = mix(hash, v.hash());
        return hash;
    case Kind::object: {
        // a sum, because members compare in any order
        std::uint64_t sum = 0;
        for (const Member& m : *payload_.object)
            sum += mix(hash_of(m.key), m.value.hash());
        return mix(hash, sum);
    }
    }
    return hash;
}

void Value::copy_payload(const Value& other) {
    switch (other.kind_) {
    case Kind::text: payload_.text = new std::string(*other.payload_.text); break;
    case Kind::array: payload_.array = new std::vector<Value>(*other.payload_.array); break;
    case Kind::object: payload_.object = new std::vector<Member>(*other.payload_.object); break;
    case Kind::undefined:
    case Kind::null:
    case Kind::boolean:
    case Kind::integer:
    case Kind::real: break;
    }
}

void Value::assign_payload(const Value& other) {
    if (this == &other) return;
    // `other` may lie inside this value, and then is less deep: it is copied before this value
    // changes
    if (kind_ != other.kind_ || other.depth_ < depth_) {
        *this = Value(other);
        return;
    }
    depth_ = other.depth_;
    switch (kind_) {
    case Kind::text: *payload_.text = *other.payload_.text; break;
    case Kind::array: *payload_.array = *other.payload_.array; break;
    case Kind::object: *payload_.object = *other.payload_.object; break;
    case Kind::undefined:
    case Kind::null:
    case Kind::boolean:
    case Kind::integer:
    case Kind::real: break;
    }
}

void Value::release() noexcept {
    switch (kind_) {
    case Kind::text: delete payload_.text; break;
    case Kind::array: delete payload_.array; break;
    case Kind::object: delete payload_.object; break;
    case Kind::undefined:
    case Kind::null:
    case Kind::boolean:
    case Kind::integer:
    case Kind::real: break;
    }
    kind_ = Kind::undefined;
    depth_ = 0;
}

bool Value::equal_payload(const Value& a, const Value& b) {
    switch (a.kind_) {
    case Kind::text: return *a.payload_.text == *b.payload_.text;
    case Kind::array: return *a.payload_.array == *b.payload_.array;
    case Kind::object: {
        const std::vector<Member>& members = *a.payload_.object;
        const std::vector<Member>& others = *b.payload_.object;
        if (members.size() != others.size()) return false;
        for (std::size_t i = 0; i < members.size(); ++i) {
            // objects made the same way have the same order, so that no search is needed
            const Member* other =
                others[i].key == members[i].key ? &others[i] : find(others, members[i].key);
            if (other == nullptr || !(other->value == members[i].value)) return false;
        }
        return true;
    }
    case Kind::undefined:
    case Kind::null:
    case Kind::boolean:
    case Kind::integer:
    case Kind::real: break;
    }
    return true;
}

std::string_view name_of(Value::Kind kind) {
    switch (kind) {
    case Value::Kind::undefined: return "undefined";
    case Value::Kind::null: return "null";
    case Value::Kind::boolean: return "boolean";
    case Value::Kind::integer: return "integer";
    case Value::Kind::real: return "real";
    case Value::Kind::text: return "text";
    case Value::Kind::array: return "array";
    case Value::Kind::object: return "object";
    }
    return {};
}

std::string print(const Value& value) {
    std::string out;
    print_to(out, value);
    return out;
}

}  // namespace trellis
