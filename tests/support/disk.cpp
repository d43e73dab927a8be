// Reading files.
// SPDX-License-Identifier: MIT
#include "support/disk.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace trellis::test {

std::optional<Source> Disk::read(std::string_view path, std::string_view from, std::string_view) {
    const std::filesystem::path file =
        (std::filesystem::path(from).parent_path() / path).lexically_normal();
    std::ifstream in(file, std::ios::binary);
    if (!in) { return {}; }
    return Source{file.string(), std::string(std::istreambuf_iterator<char>(in), {})};
}

}  // namespace trellis::test
