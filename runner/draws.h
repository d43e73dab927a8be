// A list of random numbers to replay, as a text file: one number per line. Covered by
// tests/runner/draws_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// The numbers of `text`, in order: decimal or hexadecimal floats as Python writes them, one per
/// line; `#` begins a comment, empty lines do not count. An error "bad-number" for each line that
/// is something else; `name` is how messages call the file.
std::vector<double> read_draws(const std::string& name, std::string_view text,
                               Diagnostics& diagnostics);

}  // namespace trellis
