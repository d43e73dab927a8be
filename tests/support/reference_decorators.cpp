// The rules of TREES §1 for the decorators of a reference tree, one class per kind of node.
// SPDX-License-Identifier: MIT
#include "support/reference_nodes.h"

#include <string_view>

namespace trellis::test {

namespace {

using enum Status;

/// What decorators share: a child that has completed is idle afterwards.
class Decorator : public ReferenceNode {
public:
    using ReferenceNode::ReferenceNode;

    Status execute() override {
        const Status status = ReferenceNode::execute();
        if (is_done(children[0]->stored)) { children[0]->stored = idle; }
        return status;
    }
    void halt() override {
        children[0]->reset();
        stored = idle;
    }
};

/// Inverter, ForceSuccess, ForceFailure.
class Mapped final : public Decorator {
public:
    Mapped(const TreeSpec& spec, ReferenceWorld& world, Status on_success, Status on_failure)
        : Decorator(spec, world), on_success_(on_success), on_failure_(on_failure) {}

private:
    Status tick() override {
        stored = running;
        const Status status = children[0]->execute();
        if (!is_done(status)) { return status; }
        children[0]->reset();
        return status == success ? on_success_ : on_failure_;
    }

    Status on_success_, on_failure_;
};

/// Repeat and RetryUntilSuccessful.
class Loop final : public Decorator {
public:
    Loop(const TreeSpec& spec, ReferenceWorld& world, Status go_on, Status stop)
        : Decorator(spec, world), go_on_(go_on), stop_(stop) {}

    void halt() override {
        count_ = 0;
        Decorator::halt();
    }

private:
    bool more() const { return spec_.number == -1 || count_ < spec_.number; }

    Status tick() override {
        ReferenceNode& child = *children[0];
        bool again = more();
        stored = running;
        while (again) {
            const Status before = child.stored;
            const Status status = child.execute();
            if (status == running) { return running; }
            child.reset();
            if (status == skipped) { return skipped; }
            if (status == stop_) {
                count_ = 0;
                return stop_;
            }
            ++count_;
            again = more();
            if (before == idle && again) {
                world_.woken = true;
                return running;
            }
        }
        count_ = 0;
        return go_on_;
    }

    Status go_on_, stop_;
    int count_ = 0;
};

class KeepRunning final : public Decorator {
public:
    using Decorator::Decorator;

private:
    Status tick() override {
        stored = running;
        const Status status = children[0]->execute();
        if (is_done(status)) { children[0]->reset(); }
        return status == failure ? failure : running;
    }
};

/// Delay and Timeout.
class Timed final : public Decorator {
public:
    using Decorator::Decorator;

    void halt() override {
        begun_ = false;
        Decorator::halt();
    }

private:
    Status tick() override {
        ReferenceNode& child = *children[0];
        if (!begun_) {
            begun_ = true;
            limited_ = spec_.number > 0;
            end_ = world_.tick + spec_.number;
            stored = running;
        }
        const bool over = world_.tick >= end_;
        if (spec_.node == "Delay" && !over) { return running; }
        if (spec_.node == "Timeout" && over && limited_) {
            limited_ = false;
            if (child.stored == running) {
                begun_ = false;
                child.reset();
                return failure;
            }
        }
        const Status status = child.execute();
        if (is_done(status)) {
            begun_ = false;
            child.reset();
        }
        return status;
    }

    bool begun_ = false;
    bool limited_ = false;
    int end_ = 0;
};

class RunOnceNode final : public Decorator {
public:
    using Decorator::Decorator;

private:
    Status tick() override {
        if (is_done(result_)) { return spec_.number == 0 ? skipped : result_; }
        stored = running;
        const Status status = children[0]->execute();
        if (is_done(status)) {
            result_ = status;
            children[0]->reset();
        }
        return status;
    }

    Status result_ = idle;
};

class PreconditionNode final : public Decorator {
public:
    using Decorator::Decorator;

    void halt() override {
        let_in_ = false;
        Decorator::halt();
    }

private:
    Status tick() override {
        if (!let_in_ && !world_.bumper) { return static_cast<Status>(spec_.number); }
        let_in_ = true;
        const Status status = children[0]->execute();
        if (is_done(status)) {
            let_in_ = false;
            children[0]->reset();
        }
        return status;
    }

    bool let_in_ = false;
};

/// LoopInt with a literal queue of `number` elements.
class QueueNode final : public Decorator {
public:
    using Decorator::Decorator;

private:
    Status tick() override {
        if (stored == idle) {
            child_runs_ = false;
            left_ = spec_.number;
        }
        if (!child_runs_) {
            if (left_ == 0) { return success; }
            --left_;
        }
        if (stored == idle) { stored = running; }
        const Status status = children[0]->execute();
        child_runs_ = status == running;
        if (is_done(status)) { children[0]->reset(); }
        return status == failure ? failure : running;
    }

    bool child_runs_ = false;
    int left_ = 0;
};

/// SkipUnlessUpdated and WaitValueUpdate.
class Watching final : public Decorator {
public:
    using Decorator::Decorator;

    void halt() override {
        child_runs_ = false;
        Decorator::halt();
    }

private:
    Status tick() override {
        if (!child_runs_) {
            const bool written = world_.writes != seen_;
            seen_ = world_.writes;
            if (!written) { return spec_.node == "WaitValueUpdate" ? running : skipped; }
        }
        const Status status = children[0]->execute();
        child_runs_ = status == running;
        return status;
    }

    bool child_runs_ = false;
    int seen_ = 0;
};

}  // namespace

std::unique_ptr<ReferenceNode> reference_decorator(const TreeSpec& spec, ReferenceWorld& world) {
    const std::string_view kind = spec.node;
    const auto mapped = [&](Status on_success, Status on_failure) {
        return std::make_unique<Mapped>(spec, world, on_success, on_failure);
    };
    if (kind == "Inverter") { return mapped(failure, success); }
    if (kind == "ForceSuccess") { return mapped(success, success); }
    if (kind == "ForceFailure") { return mapped(failure, failure); }
    if (kind == "Repeat") { return std::make_unique<Loop>(spec, world, success, failure); }
    if (kind == "RetryUntilSuccessful") {
        return std::make_unique<Loop>(spec, world, failure, success);
    }
    if (kind == "KeepRunningUntilFailure") { return std::make_unique<KeepRunning>(spec, world); }
    if (kind == "Delay" || kind == "Timeout") { return std::make_unique<Timed>(spec, world); }
    if (kind == "RunOnce") { return std::make_unique<RunOnceNode>(spec, world); }
    if (kind == "Precondition") { return std::make_unique<PreconditionNode>(spec, world); }
    if (kind == "LoopInt") { return std::make_unique<QueueNode>(spec, world); }
    if (kind == "SkipUnlessUpdated" || kind == "WaitValueUpdate") {
        return std::make_unique<Watching>(spec, world);
    }
    return nullptr;
}

}  // namespace trellis::test
