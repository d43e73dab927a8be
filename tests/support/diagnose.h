// What the loader says about a text, for tests of its messages and of the schemas.
// Covered by tests/load/faults_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "load/diagnostics.h"
#include "load/document.h"

#include <string>
#include <string_view>

namespace trellis::test {

struct Findings {
    Diagnostics diagnostics;  ///< sorted
    FileKind kind = FileKind::tree;
    bool readable = false;  ///< false: it is not well-formed, or spells no document

    /// What a schema should say of the text.
    bool invalid() const { return !readable || diagnostics.structural(); }
};

/// Reads and checks `text`, which messages call `name`; JSON if the name ends so, else XML.
Findings diagnose(const std::string& name, std::string_view text, const Registry& registry);

}  // namespace trellis::test
