// The behaviour files that the drawing tests share, and the comparison of pictures with recorded
// ones. Covered by every test in tests/drawing.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"
#include "runner/drawing/drawing.h"

#include <string>
#include <string_view>

namespace trellis::test {

/// The document that `xml` spells; one that is not well-formed fails the test case.
Document document_of(std::string_view xml);

/// tests/drawing/samples/`name` as a document.
Document sample(std::string_view name);

/// A machine of `states` states with about twice as many transitions, some states inside others:
/// the same for the same seed.
std::string random_machine(unsigned seed, unsigned states);

/// Compares the pictures of a sample in all formats with tests/golden/drawings/NAME.svg, .dot and
/// .txt; writes those instead if the environment has TRELLIS_UPDATE_GOLDENS.
void check_pictures(std::string_view name, const DrawingOptions& options = {});

}  // namespace trellis::test
