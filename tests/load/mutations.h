// Behaviour files with one structural change: mostly a fault, always readable. They find where the
// checks and the schemas differ. Used by faults_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/random_document.h"

#include <string>
#include <string_view>

namespace trellis::test {

/// The document with a name, a value, a child or a text changed, added or dropped. `text` is XML
/// that can be read.
std::string mutated_xml(std::string_view text, Random& random);

/// The same for the members and values of JSON that can be read.
std::string mutated_json(std::string_view text, Random& random);

}  // namespace trellis::test
