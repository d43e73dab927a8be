// The grammar as a JSON Schema of the JSON spelling, for editors that complete and check as one
// types, and for validators that are not ours. Generated and checked in as schemas/*.schema.json.
// Covered by tests/load/schema_test.cpp, and by tests/load/faults_test.cpp with Python's
// jsonschema.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/grammar.h"

#include <string>

namespace trellis {

/// A JSON Schema (draft 7) that accepts exactly the documents in which reading and check() find no
/// structural error. TREES and MACHINES say how elements become objects.
std::string json_schema(const Grammar& grammar);

}  // namespace trellis
