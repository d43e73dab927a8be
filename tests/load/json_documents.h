// Documents from texts, for the tests of the JSON mappings, and what a reader says of a wrong one.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <string>
#include <string_view>

namespace trellis::test {

/// The document of a text that must be right.
Document from_xml(std::string_view text);
Document from_json(std::string_view text, FileKind kind);

/// All findings about a JSON text, each without its line and caret.
std::string json_faults(std::string_view text, FileKind kind);

}  // namespace trellis::test
