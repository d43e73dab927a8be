// The files of the disk. Covered by tests/runner/disk_files_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/streams.h"

namespace trellis {

/// Reads and writes real files. A regular file is written under a temporary name beside its own and
/// renamed when it is committed, so that nobody ever sees half of it; links keep pointing where
/// they do. What exists and is not a regular file (a device, a pipe) is written directly.
class DiskFiles : public Files {
public:
    std::optional<std::string> read(const std::string& path, std::size_t most,
                                    std::string& why) override;
    std::unique_ptr<OutputFile> create(const std::string& path, std::string& why) override;
    std::unique_ptr<GrowingFile> grow(const std::string& path, std::string& why) override;
    void remove(const std::string& path) override;
};

}  // namespace trellis
