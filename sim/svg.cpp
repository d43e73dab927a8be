// Numbers and text of SVG documents.
// SPDX-License-Identifier: MIT
#include "sim/svg.h"

#include <algorithm>
#include <cmath>

namespace trellis::svg {
namespace {

bool begins_letter(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

}  // namespace

std::int64_t tenths(double value) {
    return std::isnan(value) ? 0 : std::llround(std::clamp(value * 10.0, -1e7, 1e7));
}

std::string number(std::int64_t tenths) {
    const std::int64_t size = tenths < 0 ? -tenths : tenths;
    std::string text = tenths < 0 ? "-" : "";
    text += std::to_string(size / 10);
    if (size % 10 != 0) text += "." + std::to_string(size % 10);
    return text;
}

std::string number(double value) {
    return number(tenths(value));
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        default: result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return result;
}

std::size_t letters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_letter));
}

std::string shortened(std::string_view text, std::size_t most) {
    if (letters(text) <= most) return std::string(text);
    std::size_t end = 0;
    for (std::size_t seen = 0; end < text.size(); ++end)
        if (begins_letter(text[end]) && ++seen == std::max<std::size_t>(most, 1)) break;
    return std::string(text.substr(0, end)) + "…";
}

}  // namespace trellis::svg
