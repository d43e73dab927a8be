// With MPI. Only the thread that made the Ranks calls it.
// SPDX-License-Identifier: MIT
#include "runner/sweep/ranks.h"

#include <algorithm>
#include <cstddef>
#include <mpi.h>

namespace trellis {
namespace {

/// A message has at most so many bytes; MPI counts them in an int.
constexpr std::size_t most_bytes = std::size_t{1} << 26;

void send_text(const std::string& text) {
    // a message that is not full is the last
    for (std::size_t at = 0; at <= text.size(); at += most_bytes) {
        const std::size_t size = std::min(most_bytes, text.size() - at);
        MPI_Send(text.data() + at, static_cast<int>(size), MPI_CHAR, 0, 0, MPI_COMM_WORLD);
    }
}

std::string received_from(int rank) {
    std::string text;
    for (std::size_t size = most_bytes; size == most_bytes;) {
        MPI_Status status;
        int count = 0;
        MPI_Probe(rank, 0, MPI_COMM_WORLD, &status);
        MPI_Get_count(&status, MPI_CHAR, &count);
        size = static_cast<std::size_t>(count);
        text.resize(text.size() + size);
        MPI_Recv(text.data() + text.size() - size, count, MPI_CHAR, rank, 0, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
    }
    return text;
}

}  // namespace

Ranks::Ranks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks() {
    MPI_Finalize();
}

std::vector<std::string> Ranks::gathered(const std::string& text) const {
    if (!is_first()) {
        send_text(text);
        return {};
    }
    std::vector<std::string> all{text};
    for (int rank = 1; rank < count_; ++rank)
        all.push_back(received_from(rank));
    return all;
}

int Ranks::largest(int value) const {
    int all = value;
    MPI_Allreduce(&value, &all, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return all;
}

}  // namespace trellis
