// A shell session as documents show it: see transcript.h.
// SPDX-License-Identifier: MIT
#include "project/transcript.h"

#include "support/files.h"

#include <span>

namespace trellis::test {
namespace {

constexpr std::string_view ellipsis = "…";

using Lines = std::span<const std::string_view>;

bool line_matches(std::string_view expected, std::string_view actual) {
    if (!expected.ends_with(ellipsis)) return expected == actual;
    expected.remove_suffix(ellipsis.size());
    return actual.starts_with(expected);
}

bool lines_match(Lines expected, Lines actual) {
    if (expected.empty()) return actual.empty();
    if (expected.front() == ellipsis) {
        for (std::size_t skipped = 0; skipped <= actual.size(); ++skipped)
            if (lines_match(expected.subspan(1), actual.subspan(skipped))) return true;
        return false;
    }
    return !actual.empty() && line_matches(expected.front(), actual.front()) &&
           lines_match(expected.subspan(1), actual.subspan(1));
}

std::vector<std::string_view> lines_without_empty_end(std::string_view text) {
    std::vector<std::string_view> lines = lines_of(text);
    while (!lines.empty() && lines.back().empty())
        lines.pop_back();
    return lines;
}

}  // namespace

std::vector<Command> commands_of(std::string_view block) {
    std::vector<Command> commands;
    bool continued = false;
    for (const std::string_view line : lines_of(block)) {
        if (continued) {
            commands.back().text.append("\n").append(line);
        } else if (line.starts_with("$ ")) {
            commands.push_back({std::string(line.substr(2)), ""});
        } else if (!commands.empty()) {
            commands.back().expected.append(line).append("\n");
            continue;
        }
        continued = !commands.empty() && line.ends_with('\\');
    }
    return commands;
}

bool output_matches(std::string_view expected, std::string_view actual) {
    return lines_match(lines_without_empty_end(expected), lines_without_empty_end(actual));
}

}  // namespace trellis::test
