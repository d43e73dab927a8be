// Which part of a sweep's runs is done here: --shard i/n, a task of a Slurm job array, or a rank of
// an MPI job. Covered by tests/runner/sweep_shard_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trellis {

/// Every `count`-th run, beginning with the `number`-th; numbers count from 1.
struct Shard {
    std::uint64_t number = 1;
    std::uint64_t count = 1;

    bool is_whole() const { return count == 1; }
    bool has(std::uint64_t run) const { return run % count == number - 1; }
    friend bool operator==(const Shard&, const Shard&) = default;
};

/// "2/3"; none if it is not that.
std::optional<Shard> parse_shard(std::string_view text);

/// The task of a Slurm job array, by SLURM_ARRAY_TASK_ID, …_COUNT, …_MIN and …_STEP; the whole
/// outside of one. `environment` as in Streams. None if the variables make no sense.
std::optional<Shard> slurm_shard(const char* (*environment)(const char*));

/// Where the runs of a part of the sweep whose rows go to `out` are kept: "out.csv.runs",
/// "out.csv.2-of-3.runs".
std::string journal_name(const std::string& out, const Shard& shard);

}  // namespace trellis
