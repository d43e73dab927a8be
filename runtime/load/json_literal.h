// Literals of ports and subtree parameters that are JSON: `json:{"x": 1}` (TREES §2.1). Only where
// a value of any type is taken; elsewhere the text is what it is, as in BehaviorTree.CPP. Private
// to runtime/load. Covered by tests/load/json_literal_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/value.h"
#include "load/builder.h"

#include <string_view>

namespace trellis {

/// What such a literal begins with.
inline constexpr std::string_view json_prefix = "json:";

inline bool is_json_literal(std::string_view text) {
    return text.starts_with(json_prefix);
}

/// The value behind the prefix: numbers without point and exponent that fit 64 bits are integers.
/// Undefined, and an error at its place inside the text, if it is no JSON.
/// Errors: those of parse_json().
Value json_literal(Builder& builder, const Builder::Text& text);

}  // namespace trellis
