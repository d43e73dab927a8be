// How the messages of check.cpp spell values, lists and numbers of children. Covered by
// tests/load/check_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/check_wording.h"

#include "load/grammar.h"
#include "load/text.h"

namespace trellis {

std::string quoted_short(std::string_view value) {
    constexpr std::size_t longest = 40;  // bytes
    std::string line;
    for (const char c : trimmed(value)) {
        const bool blank = is_blank(c);
        if (!blank || !line.ends_with(' ')) { line += blank ? ' ' : c; }
    }
    if (line.size() <= longest) { return quoted(is_blank(value) ? value : line); }
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) {
        --end;
    }
    return quoted(line.substr(0, end) + "…");
}

std::string listed(const std::vector<std::string>& words, std::string_view last_joint) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) { out += i + 1 == words.size() ? last_joint : ", "; }
        out += words[i];
    }
    return out;
}

std::string children_in_words(std::uint32_t least, std::uint32_t most) {
    if (most == 0) { return "no children"; }
    std::string out;
    if (most == ElementRule::many) {
        out = "at least " + std::to_string(least);
        return out + (least == 1 ? " child" : " children");
    }
    out = std::to_string(least);
    if (least != most) { out += (least + 1 == most ? " or " : " to ") + std::to_string(most); }
    return out + (most == 1 ? " child" : " children");
}

}  // namespace trellis
