// The loop of ticks, and what is written down in some of them.
// SPDX-License-Identifier: MIT
#include "sim/bridge/measured_run.h"

#include "core/number.h"
#include "sim/bridge/fast_forward.h"
#include "sim/bridge/repetition.h"

#include <utility>

namespace trellis {
namespace {

/// A run on its way.
class Measurement {
public:
    Measurement(const Program& program, EpisodeSetup setup, const Floor& floor,
                const Measuring& measuring)
        : episode_(program, std::move(setup)), coverage_(floor), watch_(episode_),
          watches_(measuring.ends_early && watch_.is_of_use()), forward_(program),
          leaps_(measuring.leaps) {
        coverage_.add(episode_.robot().x, episode_.robot().y, 0);
    }

    void run_to(std::uint64_t stop) {
        while (ending_ == Ending::time && tick_ < stop) {
            if (!leaps_ || !leap(stop - tick_)) tick();
        }
    }

    Measures measures(std::uint64_t stop) const {
        Odometer driven = driven_;
        driven.turning = false;  // not part of a result
        return {.tick = stop,
                .covered = coverage_.covered_count(),
                .largest_gap = coverage_.largest_gap_count(),
                .driven = driven,
                .dirt = dirt(),
                .ending = ending_,
                .ended = tick_};
    }

    const Coverage& coverage() const { return coverage_; }

    /// The final state's id, or the fault.
    std::string message() const {
        const State& state = episode_.state();
        if (ending_ == Ending::fault) return describe_fault(episode_.program(), state);
        if (repetition_)
            return "every " +
                   print_number(static_cast<double>(repetition_->period) * episode_.setup().dt) +
                   " s";
        if (ending_ == Ending::final) return std::string(leaf_label(episode_.program(), state));
        return {};
    }

private:
    void tick() {
        if (!episode_.tick()) {
            ending_ = Ending::fault;
            return;
        }
        const Roomba& robot = episode_.robot();
        driven_.add(robot, episode_.setup().dt);
        coverage_.add(robot.x, robot.y, ++tick_);
        if (episode_.is_over()) ending_ = Ending::final;
        if (!watches_) return;
        repetition_ = watch_.look(episode_, coverage_);
        if (repetition_) ending_ = repetition_->moves ? Ending::orbit : Ending::stuck;
    }

    /// Lets ticks pass; false if the next one has to be ticked.
    bool leap(std::uint64_t most) {
        places_.clear();
        const std::uint64_t ticks = forward_.leap(episode_, most, &places_);
        if (ticks == 0) return false;
        driven_.add(episode_.robot(), episode_.setup().dt, ticks);
        for (std::size_t i = 0; i < places_.size(); ++i)
            coverage_.add(places_[i].x, places_[i].y, tick_ + i + 1);
        tick_ += ticks;
        return true;
    }

    double dirt() const {
        double collected = 0.0;
        for (const double left : episode_.surroundings().dirt)
            collected += 1.0 - left;
        return collected;
    }

    Episode episode_;
    Coverage coverage_;
    Odometer driven_;
    RepetitionWatch watch_;
    bool watches_;
    std::optional<Repetition> repetition_;
    FastForward forward_;
    bool leaps_;
    std::vector<Point> places_;  // of the last leap
    std::uint64_t tick_ = 0;
    Ending ending_ = Ending::time;
};

}  // namespace

std::string_view name_of(Ending ending) {
    switch (ending) {
    case Ending::time: return "time";
    case Ending::final: return "final";
    case Ending::fault: return "fault";
    case Ending::stuck: return "stuck";
    case Ending::orbit: return "orbit";
    }
    return "";
}

MeasuredRun measured_run(const Program& program, EpisodeSetup setup, const Floor& floor,
                         const Measuring& measuring) {
    Measurement measurement(program, std::move(setup), floor, measuring);
    MeasuredRun run;
    for (const std::uint64_t stop : measuring.stops) {
        measurement.run_to(stop);
        run.stops.push_back(measurement.measures(stop));
    }
    for (const std::uint64_t tick : measuring.curve)
        run.curve.push_back(measurement.coverage().count_at(tick));
    for (std::size_t i = 0; i < milestones.size(); ++i)
        run.reached[i] = measurement.coverage().tick_of(milestones[i] / 100.0);
    run.message = measurement.message();
    return run;
}

}  // namespace trellis
