// Writing and reading plain values as little-endian bytes, with checks when reading: what save()
// and restore() are made of. Covered by tests/core/state_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/value.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace trellis {

static_assert(std::endian::native == std::endian::little, "saved states are little-endian");

class ByteWriter {
public:
    /// What put(Value) writes: all of it, or only its hash, which is equal for equal values.
    enum class Values : std::uint8_t { whole, hashed };
    explicit ByteWriter(Values values = Values::whole) : values_(values) {}

    void put_bytes(const void* from, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(from);
        bytes_.insert(bytes_.end(), bytes, bytes + size);
    }
    template <class T>
    void put(T value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        put_bytes(&value, sizeof value);
    }
    void put(const Value& value);

    std::vector<std::byte> bytes() && { return std::move(bytes_); }

private:
    void put_whole(const Value& value);

    std::vector<std::byte> bytes_;
    Values values_;
};

/// After the first failure every get() leaves its target alone and ok() is false.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    bool ok() const { return ok_; }
    bool at_end() const { return bytes_.empty(); }

    void get_bytes(void* to, std::size_t size) {
        if (!ok_ || bytes_.size() < size) {
            ok_ = false;
            return;
        }
        std::memcpy(to, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
    }
    template <class T>
    void get(T& value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        if constexpr (std::is_same_v<T, bool>) {
            std::uint8_t byte = 0;
            get_bytes(&byte, 1);
            value = byte != 0;
        } else {
            get_bytes(&value, sizeof value);
        }
    }
    /// Fails on kinds that do not exist, and on values that nest too deeply.
    void get(Value& value);

private:
    void get(std::string& text);
    void get(Value& value, std::uint32_t depth);

    std::span<const std::byte> bytes_;
    bool ok_ = true;
};

}  // namespace trellis
