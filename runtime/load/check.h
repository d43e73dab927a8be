// Holds a document against the grammar of its kind and reports everything that is wrong with its
// elements, attributes, values and numbers of children. It does not know what names refer to: that
// is the compiler's. Covered by tests/load/check_test.cpp, and by tests/load/faults_test.cpp
// against independent validators.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"
#include "load/document.h"
#include "load/grammar.h"

namespace trellis {

/// Adds a diagnostic for every fault of `document`, which is not empty. Errors that the generated
/// schemas find as well are structural. Takes time proportional to the document.
void check(const Document& document, const Grammar& grammar, Diagnostics& diagnostics);

}  // namespace trellis
