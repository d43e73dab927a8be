// What a leaf will do, where that leads, and what changes in the state of the behaviour.
// SPDX-License-Identifier: MIT
#include "sim/bridge/fast_forward.h"

#include "exec/forms.h"
#include "sim/bridge/leaves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace trellis {
namespace {

/// Nearer to a wall than this, ticks are ticked, m: rounding must not decide whether it is met.
constexpr double shy = 1e-6;
/// A way of more ticks is not made.
constexpr std::uint64_t most_places = 20'000;

/// The room for the robot's centre.
bool is_clear(const LabWorld& world, double x, double y, double around) {
    const double apart = world.radius + around + shy;
    return x - apart > 0.0 && x + apart < world.width && y - apart > 0.0 &&
           y + apart < world.height;
}

template <class Leaf>
Leaf leaf_of(const State& state, const LeafCall& call) {
    Leaf leaf;
    std::memcpy(&leaf, state.leaves.data() + call.offset, sizeof leaf);
    return leaf;
}

template <class Leaf>
void count(State& state, const LeafCall& call, std::uint64_t ticks) {
    Leaf leaf = leaf_of<Leaf>(state, call);
    leaf.ticks += static_cast<int>(ticks);
    std::memcpy(state.leaves.data() + call.offset, &leaf, sizeof leaf);
}

/// How many more ticks go by before `ticks` times dt is more than a duration.
std::uint64_t ticks_left(int ticks, double duration, double dt) {
    const double all = std::min(duration / dt, 1e9);
    auto last = static_cast<std::int64_t>(all) + 2;
    while (last > 0 && static_cast<double>(last) * dt > duration)
        --last;
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, last - ticks));
}

/// The ticks that a straight way goes on along one axis before it comes near a wall.
double straight_ticks(double from, double step, double least, double most) {
    if (step == 0.0) return std::numeric_limits<double>::infinity();
    return ((step > 0.0 ? most : least) - from) / step;
}

}  // namespace

void TimedWay::enclose() {
    const auto around = [&](std::uint32_t length, std::vector<Circle>& circles) {
        for (std::size_t begin = 0; begin + 1 < places.size(); begin += length) {
            const std::size_t end = std::min(begin + length, places.size() - 1);
            Circle circle;
            for (std::size_t i = begin; i <= end; ++i) {
                circle.x += places[i].x / static_cast<double>(end - begin + 1);
                circle.y += places[i].y / static_cast<double>(end - begin + 1);
            }
            for (std::size_t i = begin; i <= end; ++i)
                circle.radius = std::max(
                    circle.radius, std::hypot(places[i].x - circle.x, places[i].y - circle.y));
            circles.push_back(circle);
        }
    };
    around(part, parts);
    around(large_part, large_parts);
}

std::uint64_t FastForward::leap(Episode& run, std::uint64_t most, std::vector<Point>* places) {
    const LabWorld& world = run.setup_.world;
    const Roomba& robot = run.robot_;
    if (run.setup_.walled != nullptr || run.state_.fault || !is_clear(world, robot.x, robot.y, 0.0))
        return 0;
    const Course course = course_of(run);
    most = std::min(most, course.ticks);
    if (most < 2) return 0;
    Roomba moved = robot;
    const std::uint64_t ticks = course.way == nullptr
                                    ? drive(run, course, most, moved, places)
                                    : drive_timed(run, course, most, moved, places);
    if (ticks == 0) return 0;
    moved.release_bumper();
    run.robot_ = moved;
    pass(run, course, ticks);
    return ticks;
}

FastForward::Course FastForward::course_of(const Episode& run) {
    return program_->is_machine() ? machine_course(run) : tree_course(run);
}

FastForward::Course FastForward::machine_course(const Episode& run) {
    const State& state = run.state_;
    if (state.quiet.cycles == 0 || state.quiet.dt != run.setup_.dt ||
        !state.session.external.empty())
        return {};
    const QuietState& quiet = program_->quiet_states[state.quiet.id.index];
    const LeafCall& call = program_->calls[quiet.call];
    if (call.type->name != "SetVelocity") return {};
    const SetVelocity leaf = leaf_of<SetVelocity>(state, call);
    if (!leaf.hold) return {};
    Course course{.ticks = state.quiet.cycles, .linear = leaf.linear, .angular = leaf.angular};
    if (quiet.first_input == quiet.input_end) return course;
    // one input that follows from the time since the state was entered
    const QuietInput& input = program_->quiet_inputs[quiet.first_input];
    const RowId atom = state.session.atom;
    if (quiet.input_end - quiet.first_input != 1 ||
        input.offset != offsetof(SetVelocity, angular) ||
        input.formula.source != Formula::Source::elapsed_since || input.formula.at != atom.index)
        return {};
    course.begun = state.session.clock - state.memory[atom.index];
    course.way = formula_way(run, course);
    return course.way == nullptr ? Course{} : course;
}

const TimedWay* FastForward::formula_way(const Episode& run, const Course& course) {
    const State& state = run.state_;
    const std::uint32_t row = state.session.atom.index;
    const std::uint64_t length = course.begun + course.ticks;
    for (const TimedWay& way : ways_) {
        if (way.key == row && way.first == course.linear && way.places.size() > length) return &way;
    }
    if (length > most_places) return nullptr;
    const QuietState& quiet = program_->quiet_states[state.quiet.id.index];
    const Formula& formula = program_->quiet_inputs[quiet.first_input].formula;
    TimedWay way;
    way.key = row;
    way.first = way.linear = course.linear;
    Roomba robot{.max_linear = run.robot_.max_linear, .max_angular = run.robot_.max_angular};
    way.places.emplace_back();
    for (std::uint32_t tick = 1; tick <= length; ++tick) {
        const std::uint32_t clock = state.memory[row] + tick;
        const double asked =
            compute(FormView{*program_, state, &run.robot_, clock, run.setup_.dt}, formula);
        robot.set_velocity(course.linear, asked);
        move(robot, run.setup_.dt);
        way.places.push_back({robot.x, robot.y, robot.rotation, asked, robot.angular});
    }
    way.enclose();
    ways_.push_back(std::move(way));
    return &ways_.back();
}

const TimedWay* FastForward::spiral(const Episode& run, std::uint32_t row, double speed,
                                    double radius, double growth, double duration) {
    for (const TimedWay& way : ways_) {
        if (way.key == row && way.linear == speed && way.first == radius && way.second == growth &&
            way.third == duration)
            return &way;
    }
    const double dt = run.setup_.dt;
    const std::uint64_t length = ticks_left(0, duration, dt);
    if (length > most_places) return nullptr;
    TimedWay way;
    way.key = row;
    way.linear = speed;
    way.first = radius;
    way.second = growth;
    way.third = duration;
    Roomba robot{.max_linear = run.robot_.max_linear, .max_angular = run.robot_.max_angular};
    way.places.emplace_back();
    for (std::uint64_t tick = 1; tick <= length; ++tick) {
        const double asked = speed / (radius + growth * (static_cast<double>(tick) * dt));
        robot.set_velocity(speed, asked);
        move(robot, dt);
        way.places.push_back({robot.x, robot.y, robot.rotation, asked, robot.angular});
    }
    way.enclose();
    ways_.push_back(std::move(way));
    return &ways_.back();
}

FastForward::Course FastForward::tree_course(const Episode& run) {
    const State& state = run.state_;
    const RowId n = state.resume;
    if (!n) return {};
    const Row& row = program_->at(n);
    if (row.op != Op::action || row.conditional) return {};
    const LeafCall& call = program_->calls[row.arg];
    if (call.input_count != 0 || call.output_count != 0) return {};
    const std::string& name = call.type->name;
    const double dt = run.setup_.dt;
    if (name == "MoveForward") {
        const MoveForward leaf = leaf_of<MoveForward>(state, call);
        return {.ticks = ticks_left(leaf.ticks, leaf.duration, dt), .linear = leaf.speed};
    }
    if (name == "GoBack") {
        const GoBack leaf = leaf_of<GoBack>(state, call);
        return {.ticks = ticks_left(leaf.ticks, leaf.duration, dt), .linear = -leaf.speed};
    }
    if (name == "Rotate") {
        const Rotate leaf = leaf_of<Rotate>(state, call);
        if (leaf.ticks == 0) return {};  // its angle is not drawn yet
        return {.ticks = ticks_left(leaf.ticks, std::fabs(leaf.angle) / leaf.rate, dt),
                .angular = leaf.angle > 0.0 ? leaf.rate : -leaf.rate};
    }
    if (name == "MoveInSpiral") {
        const MoveInSpiral leaf = leaf_of<MoveInSpiral>(state, call);
        Course course{.ticks = ticks_left(leaf.ticks, leaf.duration, dt), .linear = leaf.speed};
        course.begun = static_cast<std::uint32_t>(leaf.ticks);
        course.way = spiral(run, n.index, leaf.speed, leaf.radius, leaf.growth, leaf.duration);
        return course.way == nullptr ? Course{} : course;
    }
    return {};
}

std::uint64_t FastForward::drive(const Episode& run, const Course& course, std::uint64_t most,
                                 Roomba& robot, std::vector<Point>* places) const {
    const double dt = run.setup_.dt;
    const LabWorld& world = run.setup_.world;
    robot.set_velocity(course.linear, course.angular);
    const double v = robot.linear;
    const double w = robot.angular;
    if (!std::isfinite(v) || !std::isfinite(w)) return 0;
    if (v != 0.0 && w != 0.0) return 0;  // an arc
    auto n = static_cast<double>(most);
    if (v != 0.0) {
        // straight on: a rectangle holds the way when it holds its end
        const double step_x = v * dt * std::cos(robot.rotation);
        const double step_y = v * dt * std::sin(robot.rotation);
        const double edge = world.radius + 2.0 * shy;
        n = std::min({n, straight_ticks(robot.x, step_x, edge, world.width - edge),
                      straight_ticks(robot.y, step_y, edge, world.height - edge)});
        n = std::floor(n);
        if (n < 2.0) return 0;
        for (double i = 1.0; places != nullptr && i <= n; ++i)
            places->push_back({robot.x + i * step_x, robot.y + i * step_y});
        robot.x += n * step_x;
        robot.y += n * step_y;
    }
    robot.rotation += n * (w * dt);
    robot.v = v;
    robot.w = w;
    return static_cast<std::uint64_t>(n);
}

std::uint64_t FastForward::drive_timed(const Episode& run, const Course& course, std::uint64_t most,
                                       Roomba& robot, std::vector<Point>* places) const {
    const TimedWay& way = *course.way;
    const LabWorld& world = run.setup_.world;
    const TimedWay::Place& here = way.places[course.begun];
    const double turned = robot.rotation - here.rotation;
    const double c = std::cos(turned);
    const double s = std::sin(turned);
    const double x = robot.x - (c * here.x - s * here.y);
    const double y = robot.y - (s * here.x + c * here.y);
    const auto clear = [&](const TimedWay::Circle& part) {
        return is_clear(world, x + c * part.x - s * part.y, y + s * part.x + c * part.y,
                        part.radius);
    };
    const auto end = static_cast<std::uint32_t>(course.begun + most);
    std::uint32_t at = course.begun;
    while (at < end) {
        if (at % TimedWay::large_part == 0 && clear(way.large_parts[at / TimedWay::large_part])) {
            at += TimedWay::large_part;
        } else if (clear(way.parts[at / TimedWay::part])) {
            at = (at / TimedWay::part + 1) * TimedWay::part;
        } else {
            break;
        }
    }
    at = std::min(at, end);
    if (at < course.begun + 2) return 0;
    for (std::uint32_t i = course.begun + 1; places != nullptr && i <= at; ++i)
        places->push_back({x + c * way.places[i].x - s * way.places[i].y,
                           y + s * way.places[i].x + c * way.places[i].y});
    const TimedWay::Place& there = way.places[at];
    robot.x = x + c * there.x - s * there.y;
    robot.y = y + s * there.x + c * there.y;
    robot.rotation = turned + there.rotation;
    robot.set_velocity(way.linear, there.asked);
    robot.v = robot.linear;
    robot.w = robot.angular;
    return at - course.begun;
}

void FastForward::pass(Episode& run, const Course& course, std::uint64_t ticks) const {
    State& state = run.state_;
    state.tick += ticks;
    run.status_ = Status::running;
    if (program_->is_machine()) {
        const QuietState& quiet = program_->quiet_states[state.quiet.id.index];
        state.quiet.cycles -= static_cast<std::uint32_t>(ticks);
        state.session.clock += static_cast<std::uint32_t>(ticks);
        state.last_leaf = quiet.activity;
        if (course.way == nullptr) return;
        const double asked = course.way->places[course.begun + ticks].asked;
        std::memcpy(state.leaves.data() + program_->calls[quiet.call].offset +
                        offsetof(SetVelocity, angular),
                    &asked, sizeof asked);
        return;
    }
    const Row& row = program_->at(state.resume);
    for (RowId scope = row.scope; scope; scope = program_->at(scope).scope)
        state.memory[scope.index] += static_cast<std::uint32_t>(ticks);
    state.last_leaf = state.resume;
    const LeafCall& call = program_->calls[row.arg];
    const std::string& name = call.type->name;
    if (name == "MoveForward") count<MoveForward>(state, call, ticks);
    if (name == "GoBack") count<GoBack>(state, call, ticks);
    if (name == "Rotate") count<Rotate>(state, call, ticks);
    if (name == "MoveInSpiral") count<MoveInSpiral>(state, call, ticks);
}

}  // namespace trellis
