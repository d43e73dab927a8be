// Parts of a sweep, by hand and by Slurm.
// SPDX-License-Identifier: MIT
#include "runner/sweep/shard.h"

#include <doctest/doctest.h>

#include <cstring>

namespace trellis {
namespace {

TEST_CASE("sweep shard: parts by hand") {
    CHECK(parse_shard("2/3") == Shard{2, 3});
    CHECK(parse_shard("1/1") == Shard{1, 1});
    for (const char* wrong :
         {"", "3", "0/3", "4/3", "1/0", "a/3", "1/b", "1/3/5", "-1/3", " 1/3"}) {
        CAPTURE(wrong);
        CHECK_FALSE(parse_shard(wrong));
    }
    CHECK(Shard{2, 3}.has(1));
    CHECK(Shard{2, 3}.has(4));
    CHECK_FALSE(Shard{2, 3}.has(3));
}

TEST_CASE("sweep shard: a task of a Slurm job array") {
    CHECK(slurm_shard(nullptr) == Shard{});
    CHECK(slurm_shard([](const char*) -> const char* { return nullptr; }) == Shard{});
    CHECK(slurm_shard([](const char* name) -> const char* {
              return std::strcmp(name, "SLURM_ARRAY_TASK_ID") == 0      ? "2"
                     : std::strcmp(name, "SLURM_ARRAY_TASK_COUNT") == 0 ? "3"
                                                                        : nullptr;
          }) == Shard{2, 3});
    // --array=10-30:10
    CHECK(slurm_shard([](const char* name) -> const char* {
              return std::strcmp(name, "SLURM_ARRAY_TASK_ID") == 0      ? "20"
                     : std::strcmp(name, "SLURM_ARRAY_TASK_COUNT") == 0 ? "3"
                                                                        : "10";
          }) == Shard{2, 3});
    // --array=1,5,7
    CHECK_FALSE(slurm_shard([](const char* name) -> const char* {
        return std::strcmp(name, "SLURM_ARRAY_TASK_ID") == 0      ? "7"
               : std::strcmp(name, "SLURM_ARRAY_TASK_COUNT") == 0 ? "3"
                                                                  : "1";
    }));
}

TEST_CASE("sweep shard: where the runs are kept") {
    CHECK(journal_name("rows.csv", {}) == "rows.csv.runs");
    CHECK(journal_name("rows.csv", {2, 3}) == "rows.csv.2-of-3.runs");
}

}  // namespace
}  // namespace trellis
