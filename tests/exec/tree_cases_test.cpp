// What BehaviorTree.CPP 4.10 did on recorded trees, tick for tick: every case must give the same
// text, but for those of tree_deviations.def. The driver is support/tree_driver.h.
// SPDX-License-Identifier: MIT
#include "support/files.h"
#include "support/tree_driver.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {
namespace {

/// Cases that end differently here, each with the reason (TREES, "The claim to reach").
struct Deviation {
    std::string_view name;
    std::string_view reason;
};
constexpr std::array deviations = {
#define DEVIATION(name, reason) Deviation{name, reason},
#include "tree_deviations.def"
};

std::string without_comments(const std::string& text) {
    std::string out;
    for (const std::string_view line : lines_of(text)) {
        if (line.empty() || line.front() == '#') { continue; }
        out += line;
        while (out.ends_with(' ')) {
            out.pop_back();
        }
        out += '\n';
    }
    return out;
}

DriveOptions options_of(std::filesystem::path args) {
    args.replace_extension(".args");
    std::vector<std::string> words;
    if (std::filesystem::exists(args)) {
        std::istringstream in(read_file(args));
        for (std::string word; in >> word;) {
            words.push_back(word);
        }
    }
    return drive_options(words);
}

}  // namespace

TEST_CASE("tree cases: recorded runs of BehaviorTree.CPP are repeated tick for tick") {
    const std::filesystem::path folder = TRELLIS_CONFORMANCE_DIR "/trees";
    if (!std::filesystem::exists(folder)) {
        MESSAGE("no recorded trees in " TRELLIS_CONFORMANCE_DIR);
        return;
    }
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".expected") { paths.push_back(entry.path()); }
    }
    std::sort(paths.begin(), paths.end());
    std::size_t same = 0;
    std::size_t known = 0;
    for (const std::filesystem::path& expected : paths) {
        std::filesystem::path tree = expected;
        tree.replace_extension(".xml");
        const std::string name =
            expected.parent_path().filename().string() + '/' + expected.stem().string();
        const Drive drive = drive_tree(tree.string(), options_of(expected));
        const std::string want = without_comments(read_file(expected));
        const bool equal = without_comments(drive.output) == want;
        const bool deviates = std::any_of(deviations.begin(), deviations.end(),
                                          [&](const Deviation& d) { return d.name == name; });
        if (deviates) {
            ++known;
            CHECK_MESSAGE(!equal, name << " is no deviation any more");
            continue;
        }
        same += equal ? 1 : 0;
        CHECK_MESSAGE(equal, name << "\n--- recorded\n"
                                  << want << "--- here\n"
                                  << drive.output << drive.messages);
    }
    MESSAGE(same, " of ", paths.size(), " recorded trees are the same, ", known,
            " deviate for a reason");
}

}  // namespace trellis::test
