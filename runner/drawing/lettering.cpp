// Widths of letters, characters that cannot be shown, and line breaks.
// SPDX-License-Identifier: MIT
#include "runner/drawing/lettering.h"

#include "load/text.h"

#include <algorithm>
#include <array>

namespace trellis::drawing {
namespace {

// advance widths of U+0020 to U+007E in thousandths of the letter size
constexpr std::array<std::uint16_t, 95> regular_widths{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr std::array<std::uint16_t, 95> bold_widths{
    348,  456, 521, 838, 696, 1002, 872, 306,  457, 457, 523, 838, 380, 415,  380, 365,
    696,  696, 696, 696, 696, 696,  696, 696,  696, 696, 400, 400, 838, 838,  838, 580,
    1000, 774, 762, 734, 830, 683,  683, 821,  837, 372, 372, 775, 637, 995,  837, 850,
    733,  850, 770, 720, 682, 812,  774, 1103, 771, 724, 725, 457, 365, 457,  838, 500,
    500,  675, 716, 593, 716, 678,  435, 716,  712, 343, 343, 665, 343, 1042, 712, 687,
    716,  716, 493, 595, 478, 712,  652, 924,  645, 652, 582, 712, 365, 712,  838};
constexpr std::uint32_t other_width = 850;  // Latin with accents, Greek, Cyrillic, symbols
constexpr std::uint32_t wide_width = 1050;  // from Hangul and CJK on, emoji
constexpr char32_t first_wide = 0x1100;
constexpr char32_t first_symbol = 0x2000;  // these lie between the wide scripts,
constexpr char32_t last_symbol = 0x2BFF;   // and are not wide

bool is_bold(Lettering lettering) {
    return lettering == Lettering::heading || lettering == Lettering::title ||
           lettering == Lettering::symbol;
}

/// Takes the first character off `rest`; U+FFFD and one byte if it is not UTF-8.
char32_t take_character(std::string_view& rest) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(rest[i]); };
    const unsigned char lead = byte(0);
    const std::size_t size = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
    char32_t c = size == 1 ? lead : static_cast<char32_t>(lead & (0x7F >> size));
    bool valid = size != 0 && size <= rest.size();
    for (std::size_t i = 1; valid && i < size; ++i) {
        valid = (byte(i) & 0xC0) == 0x80;
        c = c << 6 | (byte(i) & 0x3F);
    }
    // overlong forms and surrogates
    valid = valid && (c < 0x80 || utf8_size(c) == size) && !(c >= 0xD800 && c <= 0xDFFF) &&
            c <= 0x10FFFF;
    rest.remove_prefix(valid ? size : 1);
    return valid ? c : U'\uFFFD';
}

/// Formatting characters that would rearrange or hide what stands beside them.
bool is_hidden(char32_t c) {
    return (c >= 0x80 && c <= 0x9F) || c == 0xAD || c == 0x61C || (c >= 0x200B && c <= 0x200F) ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
           (c >= 0xFFF9 && c <= 0xFFFB) || (c & 0xFFFE) == 0xFFFE || (c >> 8) == 0xE00;
}

/// Bytes of the first `most` letters of `text`, or of all if there are no more.
std::size_t reach(std::string_view text, std::size_t most) {
    std::size_t end = 0;
    for (std::size_t seen = 0; end < text.size(); ++end) {
        const bool begins_letter = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
        if (begins_letter && seen++ == most) break;
    }
    return end;
}

std::string hexadecimal(char32_t c) {
    std::string digits;
    for (; c != 0; c >>= 4)
        digits.insert(digits.begin(), "0123456789abcdef"[c & 0xF]);
    return digits;
}

}  // namespace

double letter_size(Lettering lettering) {
    switch (lettering) {
    case Lettering::heading: return 17;
    case Lettering::title: return 13;
    case Lettering::symbol: return 17;
    case Lettering::kind: return 11.5;
    case Lettering::detail: return 11.5;
    case Lettering::tag: return 11;
    case Lettering::label: return 11.5;
    }
    return 0;
}

double line_height(Lettering lettering) {
    switch (lettering) {
    case Lettering::heading: return 24;
    case Lettering::title: return 18;
    case Lettering::symbol: return 22;
    case Lettering::kind: return 15;
    case Lettering::detail: return 15.5;
    case Lettering::tag: return 15;
    case Lettering::label: return 14.5;
    }
    return 0;
}

double text_width(std::string_view text, Lettering lettering) {
    const auto& widths = is_bold(lettering) ? bold_widths : regular_widths;
    std::uint64_t thousandths = 0;
    while (!text.empty()) {
        const char32_t c = take_character(text);
        if (c >= 0x20 && c < 0x7F) {
            thousandths += widths[c - 0x20];
        } else {
            const bool wide = c >= first_wide && !(c >= first_symbol && c <= last_symbol);
            thousandths += wide ? wide_width : other_width;
        }
    }
    return static_cast<double>(thousandths) * letter_size(lettering) / 1000;
}

Size size_of(const std::vector<TextLine>& lines) {
    Size size;
    for (const TextLine& line : lines) {
        size.width = std::max(size.width, line.indent + text_width(line.text, line.lettering));
        size.height += line_height(line.lettering);
    }
    return size;
}

std::string visible(std::string_view text) {
    constexpr char32_t first_picture = 0x2400;  // ␀, the picture of U+0000
    constexpr char32_t picture_of_delete = 0x2421;
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const char32_t c = take_character(text);
        if (c < 0x20) {
            append_utf8(result, first_picture + c);
        } else if (c == 0x7F) {
            append_utf8(result, picture_of_delete);
        } else if (is_hidden(c)) {
            result += "⟨" + character_code(c) + "⟩";
        } else {
            append_utf8(result, c);
        }
    }
    return result;
}

std::string visible_line(std::string_view text) {
    std::string line;
    line.reserve(text.size());
    for (const char c : trimmed(text)) {
        if (!is_blank(c))
            line += c;
        else if (line.back() != ' ')
            line += ' ';
    }
    return visible(line);
}

std::string ascii_only(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const char32_t c = take_character(text);
        if (c < 0x80)
            result += static_cast<char>(c);
        else
            result += "\\u{" + hexadecimal(c) + "}";
    }
    return result;
}

std::string shortened(std::string_view text, std::size_t most) {
    const std::size_t all = reach(text, most);
    if (all == text.size()) return std::string(text);
    return std::string(text.substr(0, reach(text, std::max<std::size_t>(most, 1) - 1))) + "…";
}

std::vector<std::string> wrapped(std::string_view text, std::size_t most, std::size_t lines) {
    std::vector<std::string> result;
    for (std::size_t end; result.size() + 1 < lines && (end = reach(text, most)) < text.size();) {
        // the last space in reach, unless the line would be less than half full
        const std::size_t space = text.rfind(' ', end);
        if (space != std::string_view::npos && space > end / 2) end = space;
        result.emplace_back(text.substr(0, end));
        text.remove_prefix(text[end] == ' ' ? end + 1 : end);
    }
    result.push_back(shortened(text, most));
    return result;
}

}  // namespace trellis::drawing
