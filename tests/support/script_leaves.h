// Leaves whose answers are written in the document, registered as any user would: what the tests of
// the interpreter tick, and what TREES calls "the test driver". They report to a ScriptHost. No
// rule of trees or machines is known here. Covered by tests/exec/leaves_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "core/state.h"
#include "exec/step.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

/// What scripted leaves have reported, and how often each of them was called.
struct ScriptHost {
    std::string events;  ///< " a:RUNNING b:HALT c=5 d>'x'", in order
    bool bumper = false;
    double range = 0.0;  // m
    std::int32_t count = 0;
    bool records = true;  ///< false: events stays as it is
    /// Calls by row; the n-th call gives letter n of the script.
    std::vector<std::uint32_t> calls;
    const RowId* leaf = nullptr;  ///< State::last_leaf of the run that is being stepped

    void report(std::string_view id, char mark, std::string_view what);
    /// The next letter of the script of the leaf that is being ticked.
    Status next(std::string_view script);
};

/// Adds to `registry`, for a ScriptHost:
///   Leaf id script            the n-th call, over the whole run, gives the n-th letter of the
///                             script, cyclically: S F R K; reports id:STATUS, and id:HALT
///   SyncLeaf, Cond id script  the same, synchronous
///   CodedLeaf, CodedSyncLeaf id script
///                             Leaf and SyncLeaf with numbers: leaf_id() is the id, code_of() gives
///                             the script; no report of a halt
///   Echo id in                reports what an untyped port holds, id=value or id=ERR
///   GetInt, GetDouble, GetStr id in            the same for a typed port
///   PutInt, PutDouble, PutStr id value out     writes, and reports id>value
/// the sensors bumper, range and count, and the enumerators RED=1, GREEN=2, BLUE=3.
void register_scripts(Registry& registry);

/// The number that stands for a script of up to 13 letters: base 5, the first letter last, S is 1.
std::int32_t code_of(std::string_view script);
/// The id of leaf number `n` from 0: a, b, …, z, aa, …
std::string leaf_id(std::size_t n);

/// The registry with just these; programs may point into it for ever.
const Registry& script_registry();

/// One run of a program with scripted leaves. Copying it saves the run, assigning restores it.
class ScriptRun {
public:
    /// `program` outlives this.
    explicit ScriptRun(const Program& program);

    Status step(const StepOptions& options = {.dt = 1.0});
    void start(const StepOptions& options = {.dt = 1.0});
    void halt(const StepOptions& options = {.dt = 1.0});
    /// The events since the last call, without the leading blank.
    std::string take_events();
    /// The stored statuses by row, a character each: '-' idle, R, S, F.
    std::string statuses() const;
    const Program& program() const { return *program_; }

    State state;
    ScriptHost host;

private:
    void point_host();

    const Program* program_;
};

}  // namespace trellis::test
