// Values into the members of leaf structs and back: the conversions of BehaviorTree.CPP's ports
// (TREES §2.1, §2.2). Covered by tests/core/ports_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/code.h"
#include "core/leaf.h"
#include "core/value.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace trellis {

/// Writes `value` into the member of `port` in the leaf struct at `leaf`; false, and nothing
/// written, if it does not convert without loss: texts are read as numbers, numbers are written as
/// texts, a real is an integer only if it is whole. Text and any-typed members point to `value`,
/// which is made a text for a text member.
bool store_input(const Port& port, Value& value, std::byte* leaf);

/// The whole number that `value` is, or that its text spells; false if it is none.
bool to_integer(const Value& value, std::int64_t& result);

/// The truth value that `value` is, or that its text spells; false if it is none.
bool to_boolean(const Value& value, bool& result);

/// What the output or in/out member of `port` holds, as a value.
Value load_output(const Port& port, const std::byte* leaf);

/// Stores `value`, written by a port of type `type`, into a variable of a tree. One that does not
/// exist gets the type; one that does keeps its own. False, with the reason in `why`, if the value
/// does not convert to it without loss.
bool write_entry(PortType type, const Value& value, Value& slot, EntryType& entry,
                 std::string& why);

/// Stores what the output or in/out member of `port` holds into a variable, as write_entry() does;
/// a text reuses the variable's buffer.
bool store_output(const Port& port, const std::byte* leaf, Value& slot, EntryType& entry,
                  std::string& why);

/// The entry type that a port of that type gives a variable it creates.
EntryType entry_type(PortType type);

}  // namespace trellis
