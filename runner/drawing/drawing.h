// Pictures of behaviour files: trees and machines as SVG, as Graphviz DOT or as text. Made from the
// Document, so that a file that does not compile yet, or whose leaves are not known here, can be
// drawn too. Opens no files. Covered by tests/drawing/tree_drawing_test.cpp and
// machine_drawing_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace trellis {

class Registry;

enum class DrawingFormat : std::uint8_t {
    svg,   ///< self-contained; light and dark by the viewer's preference
    dot,   ///< Graphviz, with a cluster for each SubTree or compound state
    text,  ///< for a terminal, a line for each node or transition
};

/// What an element is doing, shown as the colour of its picture (SVG, DOT) or a word (text).
enum class DrawingStatus : std::uint8_t {
    none,  ///< drawn as if not mentioned
    idle,
    running,
    success,
    failure,
    skipped,
    active,  ///< of a state
};

/// What a picture adds to one element.
struct Highlight {
    ElementId element;  ///< a node, a state or a transition
    DrawingStatus status = DrawingStatus::none;
    std::string note;  ///< one more line of text; empty for none
};

struct DrawingOptions {
    /// Text only: no character beyond ASCII; those of names are written \u{e9}.
    bool ascii = false;
    /// ID of the tree that is drawn first; empty: what the file says, else its first.
    std::string_view main_tree = {};
    /// Trees, SVG and DOT: grow to the right instead of downwards.
    bool sideways = false;
    /// Tells conditions from actions among the leaves; null: those that the file's palette or its
    /// long form names are conditions, all others actions. Used during the call only.
    const Registry* registry = nullptr;
    /// In any order; of several for one element the last one counts.
    std::span<const Highlight> highlights = {};
};

/// The picture of a tree or machine file, ending in a line feed; the same for the same arguments on
/// every platform. Empty if the document is neither (file_kind() is none). Time is linear in the
/// document for trees and for every text, and bounded for machines: one with too many long ways to
/// draw has its transitions written into its states.
///
/// Each element is drawn once: a SubTree is opened where its tree is first used, later uses refer
/// to it, and trees that the main tree does not reach follow below.
std::string draw(const Document& document, DrawingFormat format,
                 const DrawingOptions& options = {});

}  // namespace trellis
