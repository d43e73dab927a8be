// Reading the recorded runs: plain CSV, and CSV unpacked by the program xz.
// SPDX-License-Identifier: MIT
#include "support/lab_streams.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace trellis::test {
namespace {

namespace fs = std::filesystem;

fs::path lab_folder() {
    return fs::path(TRELLIS_SHARED_DIR) / "lab";
}

/// Hex or decimal; nothing but a number is ever passed.
double number(const std::string& text) {
    return std::strtod(text.c_str(), nullptr);
}

std::string text_of_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

LabStream read_stream(const fs::path& path) {
    static constexpr std::string_view pose_line = "# initial pose x y rot: ";
    LabStream stream{.name = path.stem().string(), .world = {}, .angles = {}};
    std::istringstream lines(text_of_file(path));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(pose_line)) {
            std::istringstream pose(line.substr(pose_line.size()));
            pose >> stream.world.start.x >> stream.world.start.y >> stream.world.start.rotation;
        } else if (!line.starts_with('#')) {
            stream.angles.push_back(number(line));  // stops at the decimal comment
        }
    }
    return stream;
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');)
        cells.push_back(cell);
    return cells;
}

/// The rows of a CSV text, its columns found by their names.
std::vector<LabRow> rows_of(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> columns = cells_of(line);

    std::vector<LabRow> rows;
    while (std::getline(lines, line)) {
        const std::vector<std::string> cells = cells_of(line);
        const auto cell = [&](std::string_view column) -> std::string {
            const auto at = static_cast<std::size_t>(
                std::find(columns.begin(), columns.end(), column) - columns.begin());
            return at < cells.size() ? cells[at] : "";  // status and path are the tree's
        };
        rows.push_back({.tick = std::atoll(cell("tick").c_str()),
                        .x = number(cell("x")),
                        .y = number(cell("y")),
                        .rotation = number(cell("rotation")),
                        .v = number(cell("v")),
                        .w = number(cell("w")),
                        .bumper = cell("bumper") == "1",
                        .leaf = cell("leaf"),
                        .status = cell("status"),
                        .path = cell("path")});
    }
    return rows;
}

/// What `command` prints; empty if it cannot be started.
std::string output_of(const std::string& command) {
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return text;
    std::array<char, 65536> block{};
    while (const std::size_t n = std::fread(block.data(), 1, block.size(), pipe))
        text.append(block.data(), n);
    pclose(pipe);
    return text;
}

fs::path recording(std::string_view kind, std::string_view stream, std::string_view suffix) {
    return lab_folder() / kind / (std::string(stream) + std::string(suffix));
}

}  // namespace

std::vector<LabStream> lab_streams() {
    std::vector<LabStream> streams;
    const fs::path folder = lab_folder() / "angles";
    if (!fs::is_directory(folder)) {
        std::printf("skipped: no recorded lab runs in %s\n", folder.c_str());
        return streams;
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        streams.push_back(read_stream(entry.path()));
    std::sort(streams.begin(), streams.end(),
              [](const LabStream& a, const LabStream& b) { return a.name < b.name; });
    return streams;
}

std::vector<LabRow> lab_events(std::string_view kind, std::string_view stream) {
    return rows_of(text_of_file(recording(kind, stream, ".events.csv")));
}

std::vector<LabRow> lab_whole_run(std::string_view kind, std::string_view stream) {
    const fs::path path = recording(kind, stream, ".csv.xz");
    if (!fs::exists(path)) return {};
    const std::string text = output_of("xz -dc '" + path.string() + "'");
    if (text.empty()) std::printf("skipped: cannot unpack %s\n", path.c_str());
    return rows_of(text);
}

}  // namespace trellis::test
