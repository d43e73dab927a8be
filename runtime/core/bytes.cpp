// Values as bytes: the kind, then the scalar, or a count and the parts.
// SPDX-License-Identifier: MIT
#include "core/bytes.h"

namespace trellis {

void ByteWriter::put(const Value& value) {
    if (values_ == Values::hashed) {
        put(value.hash());
    } else {
        put_whole(value);
    }
}

void ByteWriter::put_whole(const Value& value) {
    put(value.kind());
    switch (value.kind()) {
    case Value::Kind::undefined:
    case Value::Kind::null: break;
    case Value::Kind::boolean: put(value.as_boolean()); break;
    case Value::Kind::integer: put(value.as_integer()); break;
    case Value::Kind::real: put(value.as_real()); break;
    case Value::Kind::text:
        put(static_cast<std::uint32_t>(value.as_text().size()));
        put_bytes(value.as_text().data(), value.as_text().size());
        break;
    case Value::Kind::array:
        put(static_cast<std::uint32_t>(value.elements().size()));
        for (const Value& element : value.elements()) {
            put(element);
        }
        break;
    case Value::Kind::object:
        put(static_cast<std::uint32_t>(value.members().size()));
        for (const Member& member : value.members()) {
            put(Value::text(member.key));
            put(member.value);
        }
        break;
    }
}

void ByteReader::get(Value& value) {
    get(value, 0);
}

void ByteReader::get(Value& value, std::uint32_t depth) {
    auto kind = Value::Kind::undefined;
    get(kind);
    if (!ok_ || kind > Value::Kind::object || depth > Value::max_depth) {
        ok_ = false;
        return;
    }
    std::uint32_t count = 0;
    switch (kind) {
    case Value::Kind::undefined: value.set_undefined(); break;
    case Value::Kind::null: value = Value::null(); break;
    case Value::Kind::boolean: {
        bool boolean = false;
        get(boolean);
        value.set_boolean(boolean);
        break;
    }
    case Value::Kind::integer: {
        std::int64_t integer = 0;
        get(integer);
        value.set_integer(integer);
        break;
    }
    case Value::Kind::real: {
        double real = 0.0;
        get(real);
        value.set_real(real);
        break;
    }
    case Value::Kind::text: {
        std::string text;
        get(text);
        value.set_text(text);
        break;
    }
    case Value::Kind::array:
        get(count);
        value.set_array();
        while (ok_ && count-- != 0) {
            Value element;
            get(element, depth + 1);
            ok_ = ok_ && value.append(std::move(element));
        }
        break;
    case Value::Kind::object:
        get(count);
        value.set_object();
        while (ok_ && count-- != 0) {
            Value key;
            Value member;
            get(key, depth + 1);
            get(member, depth + 1);
            ok_ = ok_ && key.is(Value::Kind::text) &&
                  value.set_member(key.as_text(), std::move(member));
        }
        break;
    }
}

void ByteReader::get(std::string& text) {
    std::uint32_t size = 0;
    get(size);
    if (!ok_ || bytes_.size() < size) {
        ok_ = false;
        return;
    }
    text.resize(size);
    get_bytes(text.data(), size);
}

}  // namespace trellis
