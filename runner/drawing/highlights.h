// The highlights of a picture by element. Covered by tests/drawing/tree_drawing_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/drawing/drawing.h"

#include <unordered_map>

namespace trellis::drawing {

/// Looks up what the caller wants to see of an element. Refers to the caller's highlights.
class Highlights {
public:
    explicit Highlights(std::span<const Highlight> highlights) {
        for (const Highlight& highlight : highlights)
            rows_[highlight.element.index] = &highlight;
    }

    /// Status none and no note for an element that is not mentioned.
    const Highlight& of(ElementId element) const {
        static const Highlight nothing;
        const auto found = rows_.find(element.index);
        return found == rows_.end() ? nothing : *found->second;
    }

private:
    std::unordered_map<std::uint32_t, const Highlight*> rows_;  // looked up, never walked
};

}  // namespace trellis::drawing
