// The conversions of ports.h, one function per target type.
// SPDX-License-Identifier: MIT
#include "core/ports.h"

#include "core/number.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace trellis {

namespace {

template <class T>
bool put(T value, std::byte* to) {
    std::memcpy(to, &value, sizeof value);
    return true;
}

template <class T>
T get(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

bool to_real(const Value& value, double& result) {
    if (value.is(Value::Kind::text)) {
        const ParsedNumber parsed = parse_whole_number(value.as_text());
        result = parsed.value;
        return parsed.length != 0 && !parsed.out_of_range;
    }
    if (!value.is_number() && !value.is(Value::Kind::boolean)) { return false; }
    result = value.number();
    return true;
}

// As a string: integers as such, reals with six decimals, as std::to_string writes them.
bool to_text(const Value& value, std::string& result) {
    switch (value.kind()) {
    case Value::Kind::text: result = value.as_text(); return true;
    case Value::Kind::real: append_fixed(result, value.as_real()); return true;
    case Value::Kind::integer: result = std::to_string(value.as_integer()); return true;
    case Value::Kind::boolean: result = value.as_boolean() ? "true" : "false"; return true;
    case Value::Kind::undefined:
    case Value::Kind::null:
    case Value::Kind::array:
    case Value::Kind::object: break;
    }
    return false;
}

}  // namespace

bool to_boolean(const Value& value, bool& result) {
    if (value.is(Value::Kind::text)) {
        const std::string& text = value.as_text();
        const bool yes = text == "1" || text == "true" || text == "True" || text == "TRUE";
        const bool no = text == "0" || text == "false" || text == "False" || text == "FALSE";
        result = yes;
        return yes || no;
    }
    if (!value.is_number() && !value.is(Value::Kind::boolean)) { return false; }
    result = value.number() != 0.0;
    return value.number() == 0.0 || value.number() == 1.0;
}

bool to_integer(const Value& value, std::int64_t& result) {
    if (value.is(Value::Kind::integer) || value.is(Value::Kind::boolean)) {
        result = value.is(Value::Kind::boolean) ? value.as_boolean() : value.as_integer();
        return true;
    }
    if (value.is(Value::Kind::text)) {
        const std::string& text = value.as_text();
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
        if (error == std::errc() && end == text.data() + text.size()) { return true; }
    }
    double real = 0.0;
    constexpr double limit = 9223372036854775808.0;  // 2^63
    if (!to_real(value, real) || real != std::floor(real) || real < -limit || real >= limit) {
        return false;
    }
    result = static_cast<std::int64_t>(real);
    return true;
}

bool store_input(const Port& port, Value& value, std::byte* leaf) {
    std::byte* to = leaf + port.offset;
    std::int64_t integer = 0;
    double real = 0.0;
    bool boolean = false;
    switch (port.type) {
    case PortType::any: return put(static_cast<const Value*>(&value), to);
    case PortType::boolean: return to_boolean(value, boolean) && put(boolean, to);
    case PortType::int32:
        return to_integer(value, integer) && integer >= std::numeric_limits<std::int32_t>::min() &&
               integer <= std::numeric_limits<std::int32_t>::max() &&
               put(static_cast<std::int32_t>(integer), to);
    case PortType::int64: return to_integer(value, integer) && put(integer, to);
    case PortType::real: return to_real(value, real) && put(real, to);
    case PortType::text: {
        if (std::string text; !value.is(Value::Kind::text)) {
            if (!to_text(value, text)) { return false; }
            value.set_text(text);
        }
        return put(std::string_view(value.as_text()), to);
    }
    }
    return false;
}

Value load_output(const Port& port, const std::byte* leaf) {
    const std::byte* from = leaf + port.offset;
    switch (port.type) {
    case PortType::any: {
        const Value* value = get<const Value*>(from);
        return value != nullptr ? *value : Value();
    }
    case PortType::boolean: return Value::boolean(get<bool>(from));
    case PortType::int32: return Value::integer(get<std::int32_t>(from));
    case PortType::int64: return Value::integer(get<std::int64_t>(from));
    case PortType::real: return Value::real(get<double>(from));
    case PortType::text: return Value::text(get<std::string_view>(from));
    }
    return {};
}

EntryType entry_type(PortType type) {
    switch (type) {
    case PortType::any: return EntryType::any;
    case PortType::boolean: return EntryType::boolean;
    case PortType::int32:
    case PortType::int64: return EntryType::integer;
    case PortType::real: return EntryType::real;
    case PortType::text: return EntryType::text;
    }
    return EntryType::any;
}

bool write_entry(PortType type, const Value& value, Value& slot, EntryType& entry,
                 std::string& why) {
    std::int64_t integer = 0;
    double real = 0.0;
    std::string text;
    bool fits = true;
    if (entry == EntryType::missing) { entry = entry_type(type); }
    switch (entry) {
    case EntryType::missing:
    case EntryType::any: slot = value; break;
    case EntryType::boolean:
    case EntryType::integer:
    case EntryType::unsigned_integer:
        fits = to_integer(value, integer);
        if (fits) { slot.set_integer(integer); }
        break;
    case EntryType::real:
        fits = to_real(value, real);
        if (fits) { slot.set_real(real); }
        break;
    case EntryType::text:
        fits = value.is(Value::Kind::text);
        if (fits) { slot.set_text(value.as_text()); }
        break;
    }
    if (!fits) {
        static constexpr std::string_view kinds[] = {"nothing",  "anything", "booleans", "integers",
                                                     "integers", "reals",    "texts"};
        why = print(value) + " does not fit a variable that holds " +
              std::string(kinds[static_cast<std::size_t>(entry)]);
    }
    return fits;
}

bool store_output(const Port& port, const std::byte* leaf, Value& slot, EntryType& entry,
                  std::string& why) {
    const bool takes_text =
        entry == EntryType::missing || entry == EntryType::any || entry == EntryType::text;
    if (port.type != PortType::text || !takes_text) {
        return write_entry(port.type, load_output(port, leaf), slot, entry, why);
    }
    if (entry == EntryType::missing) { entry = EntryType::text; }
    slot.set_text(get<std::string_view>(leaf + port.offset));
    return true;
}

}  // namespace trellis
