// How the messages of check.cpp spell values, lists and numbers of children; which message is due
// is not known here. Private to runtime/load. Covered by tests/load/check_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// The value in quotes, on one line, cut if it is long.
std::string quoted_short(std::string_view value);

/// "a", "a or b", "a, b or c".
std::string listed(const std::vector<std::string>& words, std::string_view last_joint);

/// "no children", "1 child", "2 or 3 children", "2 to 5 children", "at least 1 child"; `most` may
/// be ElementRule::many.
std::string children_in_words(std::uint32_t least, std::uint32_t most);

}  // namespace trellis
