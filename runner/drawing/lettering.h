// The words of a drawing: how large they are without a font library, and which characters may be
// shown. Knows nothing of documents. Covered by tests/drawing/lettering_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/geometry.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::drawing {

/// What a line of text is for; decides its size, weight and colour.
enum class Lettering : std::uint8_t {
    heading,  ///< over a whole tree or machine
    title,    ///< the name of a node or state
    symbol,   ///< → ? ⇒ of a node
    kind,     ///< the type below a name
    detail,   ///< a port, an action of a state
    tag,      ///< a condition around a node, a note
    label,    ///< beside an arrow
};

struct TextLine {
    std::string text;  ///< made visible() before
    Lettering lettering = Lettering::detail;
    double indent = 0;  ///< units from the left
};

/// Size of the letters, in units.
double letter_size(Lettering lettering);
/// Distance from one line to the next, in units.
double line_height(Lettering lettering);
/// Width of UTF-8 `text`, in units, in DejaVu Sans: the widest of the fonts that the drawing asks
/// for, so that nothing overflows in the others.
double text_width(std::string_view text, Lettering lettering);
/// What the lines take below each other.
Size size_of(const std::vector<TextLine>& lines);

/// `text` with everything shown that would not be: control characters as their pictures (␊), those
/// that change the direction of text or have no width as ⟨U+202E⟩, bytes that are not UTF-8 as �.
std::string visible(std::string_view text);
/// visible(), with every run of blanks as one space and none at the ends: for code in one line.
std::string visible_line(std::string_view text);
/// UTF-8 `text` with every character beyond ASCII as \u{e9}.
std::string ascii_only(std::string_view text);
/// UTF-8 `text` cut to at most `most` letters (code points), at least one; a cut ends in "…", which
/// counts.
std::string shortened(std::string_view text, std::size_t most);
/// `text` in lines of at most `most` letters, broken at spaces where there are some; at most
/// `lines` of them, the last one ending in "…" if something is missing.
std::vector<std::string> wrapped(std::string_view text, std::size_t most, std::size_t lines);

}  // namespace trellis::drawing
