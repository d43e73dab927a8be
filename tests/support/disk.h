// Files that a behaviour refers to, read from the disk. Part of the drivers, which know nothing of
// doctest. Covered by tests/exec/machine_cases_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/load.h"

#include <optional>
#include <string_view>

namespace trellis::test {

/// Texts of files on the disk; packages are not known.
class Disk final : public SourceReader {
public:
    std::optional<Source> read(std::string_view path, std::string_view from,
                               std::string_view package) override;
};

}  // namespace trellis::test
