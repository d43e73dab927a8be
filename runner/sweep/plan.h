// A sweep that is ready to be run: every behaviour loaded with every combination of its parameters,
// every world with its floor, and the runs numbered. Never changes once it is loaded, so that
// threads share it. Covered by tests/runner/sweep_plan_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/behaviour.h"
#include "runner/streams.h"
#include "runner/sweep/spec.h"
#include "sim/bridge/measured_run.h"
#include "sim/walled_world.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace trellis {

/// The curve of coverage over time has so many steps: the first of Measuring::curve.
inline constexpr std::uint64_t curve_steps = 60;

/// One combination of behaviour, parameters and world.
struct SweepCase {
    std::size_t behaviour = 0;        ///< SweepSpec::behaviours
    std::size_t world = 0;            ///< SweepSpec::worlds
    std::size_t program = 0;          ///< SweepPlan::program
    std::vector<std::string> values;  ///< by SweepSpec::parameters; empty: not its own
};

class SweepPlan {
public:
    /// The plan of a sweep file; null after messages, with what to return in `exit`.
    static std::unique_ptr<SweepPlan> load(const std::string& file, Streams& streams, Exit& exit);

    const SweepSpec& spec() const { return spec_; }
    /// By behaviour, then its parameters, the last changing fastest, then world.
    const std::vector<SweepCase>& cases() const { return cases_; }
    const Measuring& measuring() const { return measuring_; }
    const Floor& floor(const SweepCase& of) const { return *floors_[of.world]; }
    /// Null: the lab's room.
    const WalledWorld* world(const SweepCase& of) const { return worlds_[of.world].get(); }
    const Program& program(const SweepCase& of) const { return *programs_[of.program].program; }
    /// The files, as a command finds them from where the sweep was started; "lab" for its room.
    const std::string& behaviour_file(const SweepCase& of) const {
        return programs_[of.program].name;
    }
    const std::string& world_file(const SweepCase& of) const { return world_files_[of.world]; }

    /// Runs are numbered from 0: all seeds of the first case, then those of the next.
    std::uint64_t run_count() const { return cases_.size() * spec_.seeds; }
    const SweepCase& case_of(std::uint64_t run) const { return cases_[run / spec_.seeds]; }
    std::int64_t seed_of(std::uint64_t run) const {
        return spec_.first_seed + static_cast<std::int64_t>(run % spec_.seeds);
    }
    EpisodeSetup setup_of(std::uint64_t run) const;
    MeasuredRun measure(std::uint64_t run) const;

    /// Of all texts that the results depend on, and of nothing else.
    std::uint64_t fingerprint() const { return fingerprint_; }

private:
    class Loader;
    SweepPlan() = default;

    SweepSpec spec_;
    std::vector<SweepCase> cases_;
    Measuring measuring_;
    RoombaRegistry registry_;
    std::vector<Behaviour> programs_;
    std::vector<std::string> world_files_;
    std::vector<std::unique_ptr<WalledWorld>> worlds_;  // null: the lab's room
    std::vector<std::unique_ptr<Floor>> floors_;
    std::uint64_t fingerprint_ = 0;
};

}  // namespace trellis
