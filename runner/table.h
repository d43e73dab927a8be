// Columns of text for people, and numbers rounded for them. Covered by tests/runner/table_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace trellis {

/// `value` with so many digits after the point: fixed(2.5, 3) == "2.500". Zero has no sign.
std::string fixed(double value, int digits);

/// The shortest text that is the number, without a ".0": brief(60.0) == "60".
std::string brief(double value);

/// The rows as lines, columns padded to equal width with two spaces between; the first column to
/// the left, the others to the right. Blanks at the end of a line are left out. Widths are in
/// characters of UTF-8.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace trellis
