// Leaves that answer as they are told, instead of acting on a robot: for trying a behaviour by
// hand, and for leaves that are only declared. Covered by tests/runner/mocks_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "sim/roomba.h"

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// How often each leaf was called: the part of mocks that belongs to the state of a run.
using MockCalls = std::vector<std::uint64_t>;  // by row

/// A program whose leaves can be replaced by mocks. A mock returns its letters one after the other,
/// again and again, counted for each place in the tree; one without letters returns RUNNING, a
/// condition FAILURE.
class Mocks {
public:
    /// Takes over a program whose leaves are those of the Roomba or declared
    /// (declarations.h). Those that are only declared are mocks; with `all`, every leaf is.
    Mocks(Program program, bool all);
    Mocks(const Mocks&) = delete;
    Mocks& operator=(const Mocks&) = delete;

    const Program& program() const { return program_; }
    /// Makes a mock of every leaf with that ID or instance name. Letters are S, F, R and K for
    /// SUCCESS, FAILURE, RUNNING and SKIPPED. What is wrong, in words; empty if nothing is.
    std::string tell(std::string_view name, std::string_view letters);
    /// The names of leaves that are mocks without letters, each once.
    std::vector<std::string> untold() const;

    MockCalls no_calls() const { return MockCalls(program_.rows.size()); }

    /// What leaves act on during one step of `state`: the robot, and the mocks beside it.
    struct Host {
        Roomba robot;  // first, so that leaves of the Roomba find it
        const Mocks* mocks;
        MockCalls* calls;
        const RowId* leaf;  ///< State::last_leaf: the one that is being ticked
    };

private:
    static Status tick(std::byte* self, void* host, const Tick& tick);
    void make_mock(RowId n);

    Program program_;
    std::deque<LeafType> types_;        // a deque: LeafCall points into it
    std::vector<RowId> leaves_;         // all of them
    std::vector<std::string> letters_;  // by row; empty: none
};

}  // namespace trellis
