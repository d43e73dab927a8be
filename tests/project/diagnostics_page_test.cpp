// docs/diagnostics.md and the table of findings have the same ids, so that the id in brackets
// behind every message leads to a row of the page. Whether the messages are as the page says is not
// tested here: tests/load/faults_test.cpp has their exact texts.
// SPDX-License-Identifier: MIT
#include "support/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace trellis::test;

constexpr std::string_view known[] = {
#define DIAGNOSTIC(id, meaning) id,
#include "load/diagnostic_ids.def"
};

/// The id of a row `| <a id="ID"></a>`ID` | …`; empty if the line is something else.
std::string_view id_of_row(std::string_view line) {
    constexpr std::string_view opening = "| <a id=\"";
    if (!line.starts_with(opening)) return {};
    const std::string_view id =
        line.substr(opening.size(), line.find('"', opening.size()) - opening.size());
    const std::string rest = std::string("\"></a>`").append(id).append("` | ");
    return line.substr(opening.size() + id.size()).starts_with(rest) ? id : std::string_view();
}

}  // namespace

TEST_CASE("diagnostics page: a row for each finding, and a finding for each row") {
    const std::string page = read_file(TRELLIS_SOURCE_DIR "/docs/diagnostics.md");
    std::vector<std::string_view> rows;
    for (const std::string_view line : lines_of(page)) {
        if (const std::string_view id = id_of_row(line); !id.empty()) rows.push_back(id);
    }
    for (const std::string_view id : known)
        CHECK_MESSAGE(std::count(rows.begin(), rows.end(), id) == 1, "rows for [", id, "]");
    for (const std::string_view id : rows)
        CHECK_MESSAGE(std::find(std::begin(known), std::end(known), id) != std::end(known),
                      "the page has [", id, "], which nothing reports");
}
