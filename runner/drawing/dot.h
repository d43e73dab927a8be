// The spelling of Graphviz's DOT that both kinds of pictures share. Covered by
// tests/drawing/dot_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/drawing.h"

#include <string>
#include <string_view>
#include <vector>

namespace trellis::drawing {

/// `text` as a DOT string in double quotes, shown as it is: backslashes do not escape. Line feeds
/// break the line.
std::string dot_string(std::string_view text);

/// `lines` below each other as the value of an HTML-like label, with the first `bold` ones bold.
std::string dot_label(const std::vector<std::string>& lines, std::size_t bold);

/// ` fillcolor="…" color="…" penwidth=3`, or nothing for none.
std::string dot_status(DrawingStatus status);

/// The opening line and the settings of a picture, up to the first node.
std::string dot_opening(std::string_view name, std::string_view settings);

}  // namespace trellis::drawing
