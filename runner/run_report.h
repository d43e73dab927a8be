// What a run was, said to people and to programs. Covered by tests/runner/run_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/coverage_report.h"
#include "runner/labels.h"
#include "runner/profile_report.h"
#include "runner/tally.h"
#include "sim/bridge/episode.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// Everything a report says; the objects must outlive it.
struct RunReport {
    std::string_view file;
    std::string random;  ///< "seed 7", "draws angles.txt"
    const Episode& episode;
    const Labels& labels;
    const Tally& tally;
    std::vector<std::string> log = {};       ///< lines of <log>, for json only
    const ProfileReport* profile = nullptr;  ///< --stats; null: not asked for
    std::optional<CoverageReport> coverage = {};
};

/// How the run ended: "time is up", "final: ID" or "fault".
std::string ending(const Episode& episode);

/// A paragraph of facts and a table of leaves or states.
std::string report_text(const RunReport& report);

/// The same as one JSON object; numbers in full.
std::string report_json(const RunReport& report);

}  // namespace trellis
