// The rules of TREES §1, one class per kind of node.
// SPDX-License-Identifier: MIT
#include "support/reference_tree.h"

#include <cstddef>
#include <string_view>

namespace trellis::test {

namespace {

using enum Status;

Status of_letter(char letter) {
    switch (letter) {
    case 'S': return success;
    case 'F': return failure;
    case 'R': return running;
    default: return skipped;
    }
}

class LeafNode final : public ReferenceNode {
public:
    LeafNode(const TreeSpec& spec, ReferenceWorld& world, std::string id)
        : ReferenceNode(spec, world), id_(std::move(id)) {}

    void halt() override {
        if (stored == running && spec_.node == "Leaf") { world_.events += ' ' + id_ + ":HALT"; }
        stored = idle;
    }

private:
    Status tick() override {
        // a leaf that has completed and was not reset repeats what it stored, without a call
        const bool callable = stored == idle || stored == running || spec_.node != "Leaf";
        if (!callable) { return stored; }
        const Status status = of_letter(spec_.script[calls_++ % spec_.script.size()]);
        world_.events += ' ' + id_ + ':' + std::string(name_of(status));
        return status;
    }

    std::string id_;
    std::size_t calls_ = 0;
};

/// Sequence and Fallback: `stop` ends it at once, `go_on` passes to the next child.
class InOrder final : public ReferenceNode {
public:
    InOrder(const TreeSpec& spec, ReferenceWorld& world, Status stop, Status go_on)
        : ReferenceNode(spec, world), stop_(stop), go_on_(go_on) {}

    void halt() override {
        at_ = 0;
        skips_ = 0;
        reset_children();
        stored = idle;
    }

private:
    Status tick() override {
        if (stored == idle) { skips_ = 0; }
        stored = running;
        while (at_ < children.size()) {
            const Status status = children[at_]->execute();
            if (status == running) { return running; }
            if (status == stop_) {
                reset_children();
                at_ = 0;
                return stop_;
            }
            if (status == skipped) { ++skips_; }
            ++at_;
        }
        const bool all_skipped = skips_ == children.size();
        reset_children();
        at_ = 0;
        skips_ = 0;
        return all_skipped ? skipped : go_on_;
    }

    Status stop_, go_on_;
    std::size_t at_ = 0;
    std::size_t skips_ = 0;
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

std::unique_ptr<ReferenceNode> node_of(const TreeSpec& spec, ReferenceWorld& world,
                                       std::size_t& leaves) {
    const std::string_view kind = spec.node;
    std::unique_ptr<ReferenceNode> node;
    if (kind == "Sequence") { node = std::make_unique<InOrder>(spec, world, failure, success); }
    if (kind == "Fallback") { node = std::make_unique<InOrder>(spec, world, success, failure); }
    if (kind == "ReactiveSequence") {
        node = std::make_unique<Reactive>(spec, world, failure, success);
    }
    if (kind == "ReactiveFallback") {
        node = std::make_unique<Reactive>(spec, world, success, failure);
    }
    if (kind == "Inverter") { node = std::make_unique<Mapped>(spec, world, failure, success); }
    if (kind == "ForceSuccess") { node = std::make_unique<Mapped>(spec, world, success, success); }
    if (kind == "ForceFailure") { node = std::make_unique<Mapped>(spec, world, failure, failure); }
    if (kind == "Repeat") { node = std::make_unique<Loop>(spec, world, success, failure); }
    if (kind == "RetryUntilSuccessful") {
        node = std::make_unique<Loop>(spec, world, failure, success);
    }
    if (node == nullptr) { node = std::make_unique<LeafNode>(spec, world, leaf_id(leaves++)); }
    for (const TreeSpec& child : spec.children) {
        node->children.push_back(node_of(child, world, leaves));
    }
    return node;
}

template <class Visit>
void for_each(ReferenceNode& node, const Visit& visit) {
    visit(node);
    for (const auto& child : node.children) {
        for_each(*child, visit);
    }
}

}  // namespace

Status ReferenceNode::execute() {
    // the first three are tested only when idle, _while also when running (TREES §1.5)
    Status status = idle;
    if (stored == idle) {
        if (has('f') && world_.bumper) {
            status = failure;
        } else if (has('s') && world_.bumper) {
            status = success;
        } else if (has('k') && world_.bumper) {
            return skipped;
        }
    }
    if (status == idle && has('w') && !world_.bumper && (stored == idle || stored == running)) {
        if (stored == running) { halt(); }
        return skipped;
    }
    if (status == idle) { status = tick(); }
    if (status != skipped) { stored = status; }
    return status;
}

void ReferenceNode::reset() {
    if (stored == running) { halt(); }
    stored = idle;
}

void ReferenceNode::reset_children() {
    for (const auto& child : children) {
        child->reset();
    }
}

ReferenceTree::ReferenceTree(const TreeSpec& spec) {
    std::size_t leaves = 0;
    root_ = node_of(spec, world, leaves);
}

Status ReferenceTree::step(bool while_woken) {
    Status status = root_->execute();
    while (while_woken && status == running && world.woken) {
        world.woken = false;
        status = root_->execute();
    }
    if (is_done(status)) { root_->stored = idle; }
    return status;
}

void ReferenceTree::halt() {
    root_->halt();
    for_each(*root_, [](ReferenceNode& node) { node.halt(); });
}

std::string ReferenceTree::statuses() const {
    std::string out;
    for_each(*root_, [&](ReferenceNode& n) { out += "-RSFK"[static_cast<std::size_t>(n.stored)]; });
    return out;
}

std::string ReferenceTree::take_events() {
    std::string out = world.events.empty() ? std::string() : world.events.substr(1);
    world.events.clear();
    return out;
}

}  // namespace trellis::test
