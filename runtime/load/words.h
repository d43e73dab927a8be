// Lists in attributes: words between blanks (SCXML's event, target, initial).
// Covered by tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace trellis {

/// The words of `text`, in order; views into it.
inline std::vector<std::string_view> words(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    std::vector<std::string_view> found;
    for (;;) {
        const std::size_t begin = text.find_first_not_of(blanks);
        if (begin == std::string_view::npos) { return found; }
        text.remove_prefix(begin);
        const std::size_t end = text.find_first_of(blanks);
        found.push_back(text.substr(0, end));
        if (end == std::string_view::npos) { return found; }
        text.remove_prefix(end);
    }
}

}  // namespace trellis
