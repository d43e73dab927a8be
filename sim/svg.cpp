// Numbers and text of SVG documents.
// SPDX-License-Identifier: MIT
#include "sim/svg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace trellis::svg {
namespace {

constexpr std::string_view ellipsis = "…";

/// Width of the letter that begins with byte `c`, in font sizes; 0 for a byte inside a letter.
/// The classes are those of DejaVu Sans, the widest font that is common.
double letter_width(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80) return 0.0;
    if (byte >= 0xE0) return 1.0;
    if (std::string_view("MWmw@%").find(c) != std::string_view::npos) return 0.98;
    if (std::string_view("Iijlft .,:;'|!()[]").find(c) != std::string_view::npos) return 0.4;
    return c >= 'A' && c <= 'Z' ? 0.74 : 0.63;
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

double text_width(std::string_view text, double size) {
    double width = 0.0;
    for (const char c : text)
        width += letter_width(c) * size;
    return width;
}

std::string fitted(std::string_view text, double width, double size) {
    if (text_width(text, size) <= width) return std::string(text);
    double room = width - text_width(ellipsis, size);
    std::size_t end = 0;
    for (; end < text.size(); ++end) {
        room -= letter_width(text[end]) * size;
        if (room < 0.0) break;
    }
    return std::string(text.substr(0, end)) + std::string(ellipsis);
}

}  // namespace trellis::svg
