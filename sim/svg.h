// What every drawing needs to write SVG: numbers of one decimal and text of bounded width. No
// document, no shapes. Covered by tests/sim/svg_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trellis::svg {

/// A coordinate in tenths of a unit: integers, so that no digit depends on a library's printing.
/// Values beyond ±10^7 tenths are cut to that, NaN is 0.
std::int64_t tenths(double value);

/// A number of tenths as "12.3", "-0.4" or "7".
std::string number(std::int64_t tenths);

/// A value rounded to one decimal, in the same form.
std::string number(double value);

/// UTF-8 `text` as character data or attribute value; what XML 1.0 cannot hold becomes a space.
std::string escaped(std::string_view text);

/// Width of UTF-8 `text` in a sans-serif font of `size` pixels, in pixels: an estimate that is
/// rather too wide, since the viewer chooses the font.
double text_width(std::string_view text, double size);

/// UTF-8 `text`, cut so that it and the "…" in place of the rest are at most `width` pixels wide.
std::string fitted(std::string_view text, double width, double size);

}  // namespace trellis::svg
