// The grammar as an XML Schema, for editors that complete and check as one types, and for
// validators that are not ours. Generated and checked in as schemas/*.xsd. Covered by
// tests/load/schema_test.cpp, and by tests/load/faults_test.cpp with xmllint.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/grammar.h"

#include <string>

namespace trellis {

/// An XML Schema 1.0 that accepts exactly the documents in which check() finds no structural error,
/// but for attributes that begin with '_': trees may have unknown ones, which it cannot express.
std::string xsd(const Grammar& grammar);

}  // namespace trellis
