// A document written anew, in either spelling, and checked to say the same. Covered by
// tests/runner/convert_test.cpp and fmt_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <optional>
#include <string>

namespace trellis {

/// The document in that spelling, evenly laid out; none if reading it would not give the same
/// document, which is a defect of this program.
std::optional<std::string> respelled(const Document& document, FileKind kind,
                                     Document::Spelling spelling);

inline constexpr const char* respelling_failed =
    "internal error: the text would not mean the same; nothing was written";

}  // namespace trellis
