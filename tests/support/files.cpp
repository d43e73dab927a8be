// Reading the repository's own files in tests: see files.h.
// SPDX-License-Identifier: MIT
#include "support/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace trellis::test {

std::string read_file(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    REQUIRE_MESSAGE(in.good(), "cannot read ", path.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

std::vector<std::filesystem::path> files_below(std::string_view folder,
                                               const std::vector<std::string_view>& extensions) {
    const std::filesystem::path source = TRELLIS_SOURCE_DIR;
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::exists(source / folder)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / folder)) {
        const std::string extension = entry.path().extension().string();
        if (entry.is_regular_file() &&
            std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
            files.push_back(entry.path().lexically_relative(source));
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace trellis::test
