// Runs the validators and reads their verdicts. Covered by tests/load/faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "support/judges.h"

#include "support/files.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <string_view>

namespace trellis::test {

namespace fs = std::filesystem;

namespace {

std::string quoted_for_shell(const fs::path& path) {
    return "'" + path.string() + "'";
}

/// Whether `command` ends with 0, its output discarded.
bool succeeds(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// The lines that `command`, given the names of the files on its standard input, one a line,
/// prints on either output.
std::string output_of(const std::string& command, const Paths& files) {
    const ScratchFolder scratch;
    std::string names;
    for (const fs::path& file : files) {
        names += file.string() + "\n";
    }
    const fs::path input = scratch.write("names", names);
    const fs::path output = scratch.path() / "output";
    const std::string line =
        command + " <" + quoted_for_shell(input) + " >" + quoted_for_shell(output) + " 2>&1";
    // a validator's exit status is that of the whole list: the verdicts are in its lines
    static_cast<void>(std::system(line.c_str()));
    return read_file(output);
}

/// The files with a line "FILE `verdict`" in the output.
std::set<fs::path> files_called(std::string_view verdict, const std::string& output) {
    std::set<fs::path> out;
    for (const std::string_view line : lines_of(output)) {
        if (line.ends_with(verdict)) { out.emplace(line.substr(0, line.size() - verdict.size())); }
    }
    return out;
}

}  // namespace

std::optional<std::set<fs::path>> valid_by_xmllint(const fs::path& schema, const Paths& files) {
    if (!succeeds("xmllint --version")) { return std::nullopt; }
    const std::string output =
        output_of("xargs -d '\\n' xmllint --noout --schema " + quoted_for_shell(schema), files);
    CHECK_MESSAGE(output.find("failed to compile") == std::string::npos, output);
    return files_called(" validates", output);
}

std::optional<std::set<fs::path>> valid_by_jsonschema(const fs::path& schema, const Paths& files) {
    // Debian's Python: another one in the path need not have the module
    const std::string python = "/usr/bin/python3";
    if (!succeeds(python + " -c 'import jsonschema'")) { return std::nullopt; }
    const fs::path judge = fs::path(TRELLIS_SOURCE_DIR) / "tests/support/judge_json.py";
    const std::string output =
        output_of(python + " " + quoted_for_shell(judge) + " " + quoted_for_shell(schema), files);
    CHECK_MESSAGE(output.find("Traceback") == std::string::npos, output);
    return files_called(" validates", output);
}

ScratchFolder::ScratchFolder() {
    std::random_device random;
    path_ = fs::temp_directory_path() / ("trellis-" + std::to_string(random()));
    fs::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path ScratchFolder::write(const std::string& name, const std::string& text) const {
    const fs::path file = path_ / name;
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

}  // namespace trellis::test
