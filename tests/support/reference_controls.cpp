// The rules of TREES §1 for the controls of a reference tree, one class per kind of node.
// SPDX-License-Identifier: MIT
#include "support/reference_nodes.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace trellis::test {

namespace {

using enum Status;

/// Sequence, Fallback and their kin: `stop` ends it at once, `go_on` passes to the next child.
class InOrder final : public ReferenceNode {
public:
    struct Kind {
        Status stop, go_on;
        bool yields = false;
        bool keeps_place = false;
    };
    InOrder(const TreeSpec& spec, ReferenceWorld& world, Kind kind)
        : ReferenceNode(spec, world), kind_(kind) {}

    void halt() override {
        if (!kind_.keeps_place) {
            at_ = 0;
            skips_ = 0;
        }
        reset_children();
        stored = idle;
    }

private:
    Status tick() override {
        if (stored == idle) { skips_ = 0; }
        stored = running;
        while (at_ < children.size()) {
            const Status before = children[at_]->stored;
            const Status status = children[at_]->execute();
            if (status == running) { return running; }
            if (status == kind_.stop) {
                for (std::size_t i = kind_.keeps_place ? at_ : 0; i < children.size(); ++i) {
                    children[i]->reset();
                }
                if (!kind_.keeps_place) { at_ = 0; }
                return status;
            }
            ++at_;
            if (status == skipped) {
                ++skips_;
            } else if (kind_.yields && before == idle && at_ < children.size()) {
                world_.woken = true;
                return running;
            }
        }
        const bool all_skipped = skips_ == children.size();
        reset_children();
        at_ = 0;
        skips_ = 0;
        return all_skipped ? skipped : kind_.go_on;
    }

    Kind kind_;
    std::size_t at_ = 0;
    std::size_t skips_ = 0;
};

/// What Parallel and ParallelAll share: which children have ended, and how.
class Together : public ReferenceNode {
public:
    Together(const TreeSpec& spec, ReferenceWorld& world)
        : ReferenceNode(spec, world), ended_(spec.children.size(), false) {}

    void halt() override {
        clear();
        reset_children();
        stored = idle;
    }

protected:
    void clear() {
        ended_.assign(ended_.size(), false);
        succeeded_ = 0;
        failed_ = 0;
    }
    void tick_child(std::size_t i) {
        const Status status = children[i]->execute();
        if (status == skipped) { ++skips_; }
        if (!is_done(status)) { return; }
        ended_[i] = true;
        ++(status == success ? succeeded_ : failed_);
    }
    int all() const { return static_cast<int>(children.size()); }
    int threshold(int asked) const {
        const int result = asked < 0 ? std::max(all() + asked + 1, 0) : asked;
        if (result > all()) { throw ReferenceStop(); }
        return result;
    }

    std::vector<bool> ended_;
    int succeeded_ = 0;
    int failed_ = 0;
    int skips_ = 0;  // in this tick
};

class ParallelNode final : public Together {
public:
    using Together::Together;

private:
    Status tick() override {
        const int need = threshold(spec_.number);
        const int fail = threshold(spec_.second);
        stored = running;
        skips_ = 0;
        for (std::size_t i = 0; i < children.size(); ++i) {
            if (!ended_[i]) { tick_child(i); }
            const bool enough =
                succeeded_ >= need || (spec_.number < 0 && succeeded_ + skips_ >= need);
            if (!enough && all() - failed_ >= need && failed_ != fail) { continue; }
            clear();
            reset_children();
            return enough ? success : failure;
        }
        return skips_ == all() ? skipped : running;
    }
};

class ParallelAllNode final : public Together {
public:
    using Together::Together;

private:
    Status tick() override {
        const int fail = threshold(spec_.number);
        stored = running;
        skips_ = 0;
        for (std::size_t i = 0; i < children.size(); ++i) {
            if (!ended_[i]) { tick_child(i); }
        }
        if (skips_ == all()) { return skipped; }
        if (succeeded_ + failed_ + skips_ < all()) { return running; }
        const Status result = failed_ >= fail ? failure : success;
        reset_children();
        clear();
        return result;
    }
};

/// What IfThenElse and WhileDoElse share: a leaf that has answered is asked anew.
class Choice : public ReferenceNode {
public:
    using ReferenceNode::ReferenceNode;

protected:
    Status ask() {
        ReferenceNode& question = *children[0];
        if (spec_.children[0].node == "Leaf" && is_done(question.stored)) { question.reset(); }
        const Status answer = question.execute();
        if (answer == skipped) { throw ReferenceStop(); }
        return answer;
    }
};

class IfThenElseNode final : public Choice {
public:
    using Choice::Choice;

    void halt() override {
        chosen_ = 0;
        reset_children();
        stored = idle;
    }

private:
    Status tick() override {
        stored = running;
        if (chosen_ == 0) {
            const Status answer = ask();
            if (answer == running) { return running; }
            if (answer == failure && children.size() == 2) { return failure; }
            chosen_ = answer == success ? 1 : 2;
        }
        const Status status = children[chosen_]->execute();
        if (status == running) { return running; }
        reset_children();
        chosen_ = 0;
        return status;
    }

    std::size_t chosen_ = 0;
};

class WhileDoElseNode final : public Choice {
public:
    using Choice::Choice;

    void halt() override {
        reset_children();
        stored = idle;
    }

private:
    Status tick() override {
        stored = running;
        const Status answer = ask();
        if (answer == running) { return running; }
        Status status = failure;
        if (answer == success) {
            if (children.size() == 3) { children[2]->reset(); }
            status = children[1]->execute();
        } else if (children.size() == 3) {
            children[1]->reset();
            status = children[2]->execute();
        }
        if (status != running) { reset_children(); }
        return status;
    }
};

/// A Switch whose variable is a literal: it always chooses the same child.
class SwitchNode final : public ReferenceNode {
public:
    using ReferenceNode::ReferenceNode;

    void halt() override {
        reset_children();
        stored = idle;
    }

private:
    Status tick() override {
        const std::size_t cases = children.size() - 1;
        const auto wanted = static_cast<std::size_t>(spec_.number);
        const bool known = wanted >= 1 && wanted <= cases;
        const Status status = children[known ? wanted - 1 : cases]->execute();
        if (is_done(status)) { reset_children(); }
        return status;
    }
};

class TryCatchNode final : public ReferenceNode {
public:
    using ReferenceNode::ReferenceNode;

    void halt() override {
        if (spec_.number != 0 && !catching_ && stored != idle) {
            reset_all_but_last();
            if (children.back()->execute() == running) { children.back()->reset(); }
        }
        at_ = 0;
        skips_ = 0;
        catching_ = false;
        reset_children();
        stored = idle;
    }

private:
    void reset_all_but_last() {
        for (std::size_t i = 0; i + 1 < children.size(); ++i) {
            children[i]->reset();
        }
    }
    Status tick() override {
        if (stored == idle) {
            skips_ = 0;
            catching_ = false;
        }
        stored = running;
        while (!catching_ && at_ + 1 < children.size()) {
            const Status status = children[at_]->execute();
            if (status == running) { return running; }
            if (status == failure) {
                reset_children();
                catching_ = true;
            }
            if (status == skipped) { ++skips_; }
            ++at_;
        }
        if (catching_) {
            at_ = 0;
            if (children.back()->execute() == running) { return running; }
            reset_children();
            catching_ = false;
            return failure;
        }
        const bool all_skipped = skips_ + 1 == children.size();
        reset_children();
        at_ = 0;
        skips_ = 0;
        return all_skipped ? skipped : success;
    }

    std::size_t at_ = 0;
    std::size_t skips_ = 0;
    bool catching_ = false;
};

/// ReactiveSequence and ReactiveFallback: from the first child in every tick.
class Reactive final : public ReferenceNode {
public:
    Reactive(const TreeSpec& spec, ReferenceWorld& world, Status stop, Status go_on)
        : ReferenceNode(spec, world), stop_(stop), go_on_(go_on) {}

    void halt() override {
        reset_children();
        stored = idle;
    }

private:
    Status tick() override {
        bool all_skipped = true;
        stored = running;
        for (const auto& child : children) {
            const Status status = child->execute();
            if (status != skipped) { all_skipped = false; }
            if (status == running) {
                for (const auto& other : children) {
                    if (other != child) { other->reset(); }
                }
                return running;
            }
            if (status == stop_) {
                reset_children();
                return stop_;
            }
            if (status == skipped) { child->reset(); }
        }
        reset_children();
        return all_skipped ? skipped : go_on_;
    }

    Status stop_, go_on_;
};

}  // namespace

std::unique_ptr<ReferenceNode> reference_control(const TreeSpec& spec, ReferenceWorld& world) {
    const std::string_view kind = spec.node;
    const auto in_order = [&](InOrder::Kind rules) {
        return std::make_unique<InOrder>(spec, world, rules);
    };
    if (kind == "Sequence") { return in_order({failure, success}); }
    if (kind == "Fallback") { return in_order({success, failure}); }
    if (kind == "AsyncSequence") { return in_order({failure, success, true}); }
    if (kind == "AsyncFallback") { return in_order({success, failure, true}); }
    if (kind == "SequenceWithMemory") { return in_order({failure, success, true, true}); }
    if (kind == "ReactiveSequence") {
        return std::make_unique<Reactive>(spec, world, failure, success);
    }
    if (kind == "ReactiveFallback") {
        return std::make_unique<Reactive>(spec, world, success, failure);
    }
    if (kind == "Parallel") { return std::make_unique<ParallelNode>(spec, world); }
    if (kind == "ParallelAll") { return std::make_unique<ParallelAllNode>(spec, world); }
    if (kind == "IfThenElse") { return std::make_unique<IfThenElseNode>(spec, world); }
    if (kind == "WhileDoElse") { return std::make_unique<WhileDoElseNode>(spec, world); }
    if (kind == "TryCatch") { return std::make_unique<TryCatchNode>(spec, world); }
    if (kind.starts_with("Switch")) { return std::make_unique<SwitchNode>(spec, world); }
    return nullptr;
}

}  // namespace trellis::test
