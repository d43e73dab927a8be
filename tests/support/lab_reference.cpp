// The lab's behaviour tree, object by object, and the loop that runs tree or machine.
// SPDX-License-Identifier: MIT
#include "support/lab_reference.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <utility>

namespace trellis::test {
namespace {

enum class LabStatus : std::uint8_t { running, success, failure };

/// What the leaves of a tree share in one tick.
struct LabTick {
    Roomba& robot;
    Angles& angles;
    std::vector<LabLeaf> path;  // the leaves executed so far
};

class LabNode {
public:
    LabNode() = default;
    LabNode(const LabNode&) = delete;
    LabNode& operator=(const LabNode&) = delete;
    virtual ~LabNode() = default;

    virtual void enter(LabTick& tick) = 0;
    virtual LabStatus execute(LabTick& tick) = 0;
};

/// A Sequence goes on after success, a Selector after failure; both remember the running child.
class LabComposite : public LabNode {
public:
    LabComposite(LabStatus goes_on_after, std::array<std::unique_ptr<LabNode>, 2> children)
        : goes_on_after_(goes_on_after), children_(std::move(children)) {}

    void enter(LabTick&) override { running_child_ = none; }

    LabStatus execute(LabTick& tick) override {
        if (running_child_ == none) {
            running_child_ = 0;
            children_[0]->enter(tick);
        }
        for (;;) {
            const LabStatus status = children_[running_child_]->execute(tick);
            if (status == LabStatus::running) return status;
            if (status != goes_on_after_ || running_child_ + 1 == children_.size()) {
                running_child_ = none;
                return status;
            }
            ++running_child_;
            children_[running_child_]->enter(tick);
        }
    }

private:
    static constexpr std::size_t none = 2;

    LabStatus goes_on_after_;
    std::array<std::unique_ptr<LabNode>, 2> children_;
    std::size_t running_child_ = none;
};

/// Any of the four leaves: `enter` counts from zero and, except in the spiral, sets the velocity.
/// The time is tested before the bumper, after this tick is counted.
class LabLeafNode : public LabNode {
public:
    explicit LabLeafNode(LabLeaf leaf) : leaf_(leaf) {}

    void enter(LabTick& tick) override {
        ticks_ = 0;
        switch (leaf_) {
        case LabLeaf::move_forward: tick.robot.set_velocity(0.5, 0.0); break;
        case LabLeaf::move_in_spiral: break;
        case LabLeaf::go_back: tick.robot.set_velocity(-0.1, 0.0); break;
        case LabLeaf::rotate:
            angle_ = tick.angles.draw();
            tick.robot.set_velocity(0.0, angle_ > 0.0 ? 0.5 : -0.5);
            break;
        }
    }

    LabStatus execute(LabTick& tick) override {
        tick.path.push_back(leaf_);
        ++ticks_;
        const double time = ticks_ * lab_dt;
        if (leaf_ == LabLeaf::move_in_spiral)
            tick.robot.set_velocity(0.5, 0.5 / (0.2 + 0.05 * time));
        if (time > duration()) return LabStatus::success;
        const bool minds_walls = leaf_ == LabLeaf::move_forward || leaf_ == LabLeaf::move_in_spiral;
        return minds_walls && tick.robot.bumper ? LabStatus::failure : LabStatus::running;
    }

private:
    double duration() const {
        switch (leaf_) {
        case LabLeaf::move_forward: return 3.0;
        case LabLeaf::move_in_spiral: return 20.0;
        case LabLeaf::go_back: return 0.5;
        case LabLeaf::rotate: return std::fabs(angle_) / 0.5;
        }
        return 0.0;
    }

    LabLeaf leaf_;
    int ticks_ = 0;
    double angle_ = 0.0;
};

std::unique_ptr<LabNode> sequence(LabLeaf first, LabLeaf second) {
    return std::make_unique<LabComposite>(
        LabStatus::success,
        std::array<std::unique_ptr<LabNode>, 2>{std::make_unique<LabLeafNode>(first),
                                                std::make_unique<LabLeafNode>(second)});
}

LabRow row_of(std::int64_t tick, const Roomba& robot) {
    return {.tick = tick,
            .x = robot.x,
            .y = robot.y,
            .rotation = robot.rotation,
            .v = robot.v,
            .w = robot.w,
            .bumper = robot.bumper,
            .leaf = "-",
            .status = {},
            .path = {}};
}

}  // namespace

std::string text_of(const LabRow& row) {
    std::array<char, 200> numbers{};
    std::snprintf(numbers.data(), numbers.size(), "%lld,%a,%a,%a,%a,%a,%d,",
                  static_cast<long long>(row.tick), row.x, row.y, row.rotation, row.v, row.w,
                  row.bumper ? 1 : 0);
    return numbers.data() + row.leaf + "," + row.status + "," + row.path;
}

std::string_view name_of(LabLeaf leaf) {
    switch (leaf) {
    case LabLeaf::move_forward: return "MoveForward";
    case LabLeaf::move_in_spiral: return "MoveInSpiral";
    case LabLeaf::go_back: return "GoBack";
    case LabLeaf::rotate: return "Rotate";
    }
    return {};
}

std::vector<LabRow> run_lab_machine(const LabWorld& world, std::span<const double> angles,
                                    std::int64_t ticks) {
    Roomba robot = at_start(world);
    HandWrittenFsm machine{Angles(angles)};

    std::vector<LabRow> rows{row_of(0, robot)};
    rows[0].leaf = name_of(machine.leaf());
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
        sense(world, robot);
        machine.tick(robot);
        move(robot, lab_dt);
        rows.push_back(row_of(tick, robot));
        rows.back().leaf = name_of(machine.leaf());
    }
    return rows;
}

std::vector<LabRow> run_lab_tree(const LabWorld& world, std::span<const double> angles,
                                 std::int64_t ticks) {
    static constexpr std::array<const char*, 3> statuses = {"RUNNING", "SUCCESS", "FAILURE"};
    Roomba robot = at_start(world);
    Angles draws(angles);
    LabComposite root(LabStatus::failure, {sequence(LabLeaf::move_forward, LabLeaf::move_in_spiral),
                                           sequence(LabLeaf::go_back, LabLeaf::rotate)});

    std::vector<LabRow> rows{row_of(0, robot)};
    rows[0].status = "-";
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
        sense(world, robot);
        LabTick now{.robot = robot, .angles = draws, .path = {}};
        const LabStatus status = root.execute(now);
        move(robot, lab_dt);

        LabRow row = row_of(tick, robot);
        row.leaf = name_of(now.path.back());
        row.status = statuses[static_cast<std::size_t>(status)];
        for (const LabLeaf leaf : now.path) {
            if (!row.path.empty()) row.path += '>';
            row.path += name_of(leaf);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace trellis::test
