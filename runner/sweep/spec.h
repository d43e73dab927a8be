// Reading a sweep file: JSON text to what is to be run, with everything that is wrong in it. What
// its members are called is in sweep_grammar.def. It opens no file, so what the behaviours and
// worlds hold is checked later (plan.h). Covered by tests/runner/sweep_spec_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"
#include "sim/bridge/file_grammar.h"
#include "sim/floor.h"
#include "sim/lab_world.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

const FileGrammar& sweep_grammar();

/// A text of the file and where it stands.
struct SpecText {
    std::string text;
    Where where = {};
};

/// A behaviour that is run.
struct SpecBehaviour {
    std::string name;  ///< unique
    SpecText file;     ///< as written
    std::string tree;  ///< empty: what the file says
    struct Setting {
        SpecText name;
        std::string value;  ///< as --set takes it
    };
    std::vector<Setting> set = {};
};

/// A variable whose values are tried.
struct SpecParameter {
    SpecText name;
    std::vector<std::string> values;  ///< as --set takes them
    std::vector<std::string> of;      ///< names of behaviours; none: all

    bool is_of(const SpecBehaviour& behaviour) const;
};

struct SweepSpec {
    std::string name;
    std::vector<SpecBehaviour> behaviours;
    std::vector<SpecText> worlds;  ///< "lab" or as written
    std::vector<SpecParameter> parameters;
    std::int64_t first_seed = 0;
    std::uint64_t seeds = 1;
    std::vector<double> times;   ///< s, ascending
    std::vector<double> marks;   ///< s, ascending
    double cell = default_cell;  ///< m
    bool fast = false;           ///< Measuring::leaps
    double dt = lab_dt;          ///< s
};

/// Runs of one sweep are at most so many.
inline constexpr std::uint64_t most_runs = 100'000'000;

/// The sweep that `text` describes; none after errors. `file` is the text's index in `diagnostics`.
///
/// Errors, besides those of parse_json() and check_file(): "sweep-name" (a name is used twice, or
/// is that of no behaviour), "sweep-size" (more than most_runs).
std::optional<SweepSpec> read_sweep(std::string_view text, std::uint32_t file,
                                    Diagnostics& diagnostics);

}  // namespace trellis
