// What a world file can say: the table world_grammar.def. What the members mean is read by
// world_file.h. Covered by tests/sim/world_file_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/bridge/file_grammar.h"

namespace trellis {

const FileGrammar& world_grammar();

}  // namespace trellis
