// Two moments of a run are compared. If the behaviour is in the same state at both, has drawn no
// numbers and met no wall between them, and perceives nothing else, then it does the same again:
// the way from the first moment to the second, moved as the robot's pose has moved. That is a turn
// about a point, so that the robot stays in a ring around it.
// SPDX-License-Identifier: MIT
#include "sim/bridge/repetition.h"

#include "core/recurrence.h"
#include "sim/bridge/leaves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace trellis {
namespace {

/// What rounding can add to a way in a run of many hours, and more, m.
constexpr double slack = 1e-6;
/// Poses that differ by less are the same: m, rad.
constexpr double same_pose = 1e-9;
/// What Coverage may miss at a bend, m.
constexpr double rim = 1e-3;

bool is_noisy(const Episode& run) {
    if (run.setup().walled == nullptr) return false;
    return !(run.setup().walled->plan.noise == Noise{});
}

bool is_blind(const Program& program) {
    const auto perceives = [](const LeafCall& call) {
        return call.type->host_tag != nullptr && !feels_only_bumper(*call.type);
    };
    const auto sees = [&](const Program& p) {
        return std::any_of(p.calls.begin(), p.calls.end(), perceives);
    };
    return !sees(program) && std::none_of(program.machines.begin(), program.machines.end(), sees) &&
           !reads_sensor_but(program, bumper_sensors());
}

/// How near a wall comes to a place, m.
double distance_to_wall(const EpisodeSetup& setup, Point place) {
    if (setup.walled == nullptr) {
        const LabWorld& lab = setup.world;
        return std::min({place.x, lab.width - place.x, place.y, lab.height - place.y});
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& wall : setup.walled->walls.segments()) {
        const double x = wall.to.x - wall.from.x;
        const double y = wall.to.y - wall.from.y;
        const double dx = place.x - wall.from.x;
        const double dy = place.y - wall.from.y;
        const double squared = x * x + y * y;
        const double part = squared > 0.0 ? std::clamp((dx * x + dy * y) / squared, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, std::hypot(dx - part * x, dy - part * y));
    }
    return nearest;
}

/// The turn that brings one pose to another.
struct Turn {
    Turn(const Roomba& from, const Roomba& to) {
        const double angle = to.rotation - from.rotation;
        const double dx = to.x - from.x;
        const double dy = to.y - from.y;
        wrapped = std::remainder(angle, 2.0 * std::numbers::pi);
        moved = std::hypot(dx, dy);
        // the centre is off the middle between both places, square to the line between them
        const double off = 0.5 / std::tan(wrapped / 2.0);
        centre = {from.x + dx / 2.0 - off * dy, from.y + dy / 2.0 + off * dx};
    }

    bool is_none() const { return std::fabs(wrapped) < same_pose && moved < same_pose; }
    /// Nearly straight on: its centre is far away, or nowhere.
    bool has_centre() const { return std::fabs(wrapped) > 1e-4; }

    double wrapped = 0.0;  // rad, -pi to pi
    double moved = 0.0;    // m
    Point centre;
};

/// How far from a place a way leads, m.
struct Ring {
    Point centre;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;

    void add(const Roomba& robot) {
        const double distance = std::hypot(robot.x - centre.x, robot.y - centre.y);
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
};

/// Whether a disc that goes round in the ring can cover something more.
bool covers_more(const Ring& ring, const Episode& run, const Coverage& coverage) {
    const Floor& floor = coverage.floor();
    const CellGrid& grid = floor.grid();
    const double outer = ring.most + floor.radius() - rim;
    const double inner = ring.least - floor.radius() + rim;
    for (int row = 0; row < grid.rows; ++row) {
        const double dy = grid.centre_y(row) - ring.centre.y;
        if (std::fabs(dy) > outer) continue;
        for (int column = 0; column < grid.columns; ++column) {
            if (!coverage.open().contains(column, row)) continue;
            const double distance = std::hypot(grid.centre_x(column) - ring.centre.x, dy);
            if (distance > inner && distance < outer) return true;
        }
    }
    const std::vector<double>& left = run.surroundings().dirt;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const Dirt& spot = run.setup().walled->plan.dirt[i];
        const double distance =
            std::hypot(spot.centre.x - ring.centre.x, spot.centre.y - ring.centre.y);
        if (left[i] > 0.0 && distance < ring.most + floor.radius() + spot.radius) return true;
    }
    return false;
}

/// Everything about the world and the robot in it that decides what happens next.
bool same_place(const Episode& a, const Episode& b, bool blind) {
    Roomba robot = a.robot();
    Surroundings around = a.surroundings();
    if (blind) {
        robot.battery = b.robot().battery;
        around.battery = b.surroundings().battery;
    }
    return robot == b.robot() && around == b.surroundings();
}

}  // namespace

RepetitionWatch::RepetitionWatch(const Episode& start)
    : is_of_use_(!is_noisy(start)),
      is_blind_(is_blind(start.program())), anchor_{start,
                                                    std::numeric_limits<std::uint32_t>::max(), 0},
      doing_(std::numeric_limits<std::uint32_t>::max()) {}

void RepetitionWatch::drop_anchor(const Episode& run) {
    anchor_ = {run, doing_, bumps_};
    moments_ = 0;
}

std::optional<Repetition> RepetitionWatch::think(const Episode& run, const Coverage& coverage) {
    if (!(run.state().random == anchor_.run.state().random)) {
        most_moments_ = 1;
        drop_anchor(run);
        return {};
    }
    if (doing_ == anchor_.doing && run.state().tick >= next_comparison_) {
        if (const std::optional<Repetition> found = compare(run, coverage)) return found;
    }
    if (++moments_ >= most_moments_) {
        most_moments_ *= 2;
        drop_anchor(run);
    }
    return {};
}

std::optional<Repetition> RepetitionWatch::compare(const Episode& run, const Coverage& coverage) {
    const Episode& before = anchor_.run;
    if (!recurs(run.program(), before.state(), run.state())) return {};
    // trying out takes a period, and until a ring is covered there are many
    next_comparison_ = run.state().tick + run.state().tick / 16;
    Repetition found{.period = run.state().tick - before.state().tick};
    const bool same = same_place(before, run, is_blind_);
    const Turn turn(before.robot(), run.robot());
    const bool free = is_blind_ && bumps_ == anchor_.bumps && !run.robot().bumper;
    if (!same && (!free || (!turn.is_none() && !turn.has_centre()))) return {};

    const bool is_closed = same || turn.is_none();
    Ring ring{is_closed ? Point{run.robot().x, run.robot().y} : turn.centre};
    ring.add(run.robot());
    const double free_to = distance_to_wall(run.setup(), ring.centre) - coverage.floor().radius();
    if (!is_closed && free_to < ring.most + slack) return {};

    // the next period is tried out, to see where it leads
    Episode trial = run;
    for (std::uint64_t i = 0; i < found.period; ++i) {
        if (!trial.tick() || (!same && trial.robot().bumper)) return {};
        ring.add(trial.robot());
    }
    found.moves = ring.most > same_pose;
    if (is_closed) return found;
    if (free_to < ring.most + slack || covers_more(ring, run, coverage)) return {};
    return found;
}

}  // namespace trellis
