// From the rows and transitions of a program back to the elements that they were compiled from.
// Covered by tests/runner/places_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "load/document.h"

#include <cstdint>
#include <vector>

namespace trellis {

/// Of a program and the document of one of its files: Program::files[file]. Both must outlive it.
class Places {
public:
    Places(const Program& program, const Document& document, std::uint32_t file = 0);

    /// None for a row of another file, and for one that no element spells.
    ElementId of(RowId row) const { return elements_[row.index]; }
    /// None if that of its state is not known, and for an <initial>.
    ElementId of(TransitionId transition) const;

private:
    const Program* program_;
    const Document* document_;
    std::vector<ElementId> elements_;  // by row
};

}  // namespace trellis
