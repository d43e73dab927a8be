// The processes of an MPI job, which run a sweep together; one process alone unless Trellis was
// built with -DTRELLIS_MPI=ON (ranks_mpi.cpp; else ranks_alone.cpp). Covered by
// tests/runner/sweep_program_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace trellis {

/// This process among those of its job. One at a time.
class Ranks {
public:
    Ranks();
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int rank() const { return rank_; }  ///< from 0; the first one speaks for all
    int count() const { return count_; }
    bool is_first() const { return rank_ == 0; }

    /// The texts of all, by rank, in the first; nothing in the others.
    std::vector<std::string> gathered(const std::string& text) const;
    /// The largest of the values that the ranks give.
    int largest(int value) const;

private:
    int rank_ = 0;
    int count_ = 1;
};

}  // namespace trellis
