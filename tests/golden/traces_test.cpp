// What every behaviour file does with one seed, recorded: a minute of ticks, of which the rows are
// kept where leaf or bumper change and every ten seconds. Leaf and bumper are compared exactly,
// poses and velocities within 1e-9. script/update-goldens records anew. That the lab's own files
// do what the lab did is in tests/sim/lab_behaviours_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/number.h"
#include "sim/bridge/episode.h"
#include "sim/bridge/leaves.h"
#include "sim/bridge/trace_csv.h"
#include "support/behaviours.h"
#include "support/files.h"
#include "support/goldens.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

namespace fs = std::filesystem;

constexpr int ticks = 3'600;
constexpr int regular = 600;      // ticks from one row to the next where nothing changes
constexpr std::int64_t seed = 7;  // of random.Random
constexpr double tolerance = 1e-9;

/// The run as CSV, compact.
std::string trace_of(const Program& program) {
    Episode run(program, {.world = {}, .dt = lab_dt, .random = Random(seed)});
    std::string text(trace_csv_header);
    EpisodeRow last = run.row();
    append_trace_csv(text, last);
    for (int tick = 1; tick <= ticks; ++tick) {
        const bool went_on = run.tick();
        REQUIRE_MESSAGE(went_on, run.state().fault.message);
        const EpisodeRow row = run.row();
        const bool changed = row.leaf != last.leaf || row.robot.bumper != last.robot.bumper;
        if (changed || tick % regular == 0) append_trace_csv(text, row);
        last = row;
    }
    return text;
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t end = line.find(','); end != line.npos; end = line.find(',')) {
        cells.push_back(line.substr(0, end));
        line.remove_prefix(end + 1);
    }
    cells.push_back(line);
    return cells;
}

/// Whether two rows agree: numbers with a point within the tolerance, everything else exactly.
bool agree(std::string_view ours, std::string_view recorded) {
    const auto a = cells_of(ours), b = cells_of(recorded);
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i]) continue;
        const ParsedNumber x = parse_whole_number(a[i]), y = parse_whole_number(b[i]);
        const bool real = x.length != 0 && y.length != 0 && b[i].find('.') != b[i].npos;
        if (!real || !(std::fabs(x.value - y.value) <= tolerance)) return false;
    }
    return true;
}

void check_trace(const std::string& ours, const std::string& recorded) {
    const auto a = lines_of(ours), b = lines_of(recorded);
    for (std::size_t i = 0; i < a.size() || i < b.size(); ++i) {
        const std::string_view x = i < a.size() ? a[i] : "(end)";
        const std::string_view y = i < b.size() ? b[i] : "(end)";
        if (agree(x, y)) continue;
        FAIL_CHECK("ours     " << x << "\nrecorded " << y);
        return;
    }
}

/// tests/golden/traces/machines/labs/lab05.csv
fs::path trace_file(const fs::path& behaviour) {
    return ("traces" / behaviour).replace_extension(".csv");
}

}  // namespace

TEST_CASE("traces: every behaviour file runs as recorded") {
    Registry registry;
    register_roomba(registry);
    for (const fs::path& file : xml_behaviours()) {
        CAPTURE(file.generic_string());
        const std::string ours = trace_of(program_of(file, registry));
        if (const auto recorded = golden(trace_file(file), ours)) check_trace(ours, *recorded);
    }
}

TEST_CASE("traces: every recorded trace belongs to a behaviour file") {
    std::vector<fs::path> expected;
    for (const fs::path& file : xml_behaviours())
        expected.push_back("tests/golden" / trace_file(file));
    std::sort(expected.begin(), expected.end());
    CHECK(files_below("tests/golden/traces", {".csv"}) == expected);
}

TEST_CASE("traces: rows differ by leaf, bumper, tick or more than the tolerance") {
    CHECK(agree("1,0.5,0,MoveForward", "1,0.5,0,MoveForward"));
    CHECK(agree("1,0.5,0,MoveForward", "1,0.5000000001,0,MoveForward"));
    CHECK_FALSE(agree("1,0.5,0,MoveForward", "1,0.500001,0,MoveForward"));
    CHECK_FALSE(agree("1,0.5,0,MoveForward", "2,0.5,0,MoveForward"));
    CHECK_FALSE(agree("1,0.5,0,MoveForward", "1,0.5,1,MoveForward"));
    CHECK_FALSE(agree("1,0.5,0,MoveForward", "1,0.5,0,GoBack"));
    CHECK_FALSE(agree("1,0.5,0,MoveForward", "1,0.5,0"));
}
