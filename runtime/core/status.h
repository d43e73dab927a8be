// What a row of a program reports and stores. Covered by tests/core/program_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace trellis {

/// The five statuses of BehaviorTree.CPP. `idle` is stored, never returned: not ticked since its
/// parent was entered, or halted. `skipped` is returned, never stored (TREES §1).
enum class Status : std::uint8_t { idle, running, success, failure, skipped };

/// "IDLE", "RUNNING", "SUCCESS", "FAILURE", "SKIPPED".
std::string_view name_of(Status status);

/// Whether a tick has ended with a result.
constexpr bool is_done(Status status) {
    return status == Status::success || status == Status::failure;
}

}  // namespace trellis
