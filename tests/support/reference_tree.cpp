// What all nodes of a reference tree do, its leaves, and the tree. Controls are in
// reference_controls.cpp, decorators in reference_decorators.cpp.
// SPDX-License-Identifier: MIT
#include "support/reference_tree.h"

#include "support/reference_nodes.h"
#include "support/script_leaves.h"

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
        const bool reports = spec_.node == "Leaf" && !spec_.coded;
        if (stored == running && reports) { world_.events += ' ' + id_ + ":HALT"; }
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

/// A leaf that is built in: Script, which writes the entry that is watched.
class WriteNode final : public ReferenceNode {
public:
    using ReferenceNode::ReferenceNode;
    void halt() override { stored = idle; }

private:
    Status tick() override {
        ++world_.writes;
        return success;
    }
};

std::unique_ptr<ReferenceNode> node_of(const TreeSpec& spec, ReferenceWorld& world,
                                       std::size_t& leaves) {
    std::unique_ptr<ReferenceNode> node = reference_control(spec, world);
    if (node == nullptr) { node = reference_decorator(spec, world); }
    if (node == nullptr && spec.node == "Script") {
        node = std::make_unique<WriteNode>(spec, world);
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
    try {
        Status status = root_->execute();
        // what has not come to rest by then never does: its own ticks wake it
        int passes = 1000;
        while (while_woken && status == running && world.woken) {
            if (--passes == 0) { throw ReferenceStop(); }
            world.woken = false;
            status = root_->execute();
        }
        if (is_done(status)) { root_->stored = idle; }
        ++world.tick;
        return status;
    } catch (const ReferenceStop&) {
        world.fault = true;
        return idle;
    }
}

void ReferenceTree::halt() {
    try {
        root_->halt();
        for_each(*root_, [](ReferenceNode& node) { node.halt(); });
    } catch (const ReferenceStop&) { world.fault = true; }
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
