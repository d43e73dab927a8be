// A slow and obvious interpreter of trees: one object per node, written from the rules of
// BehaviorTree.CPP (TREES §1), not from the interpreter, which it judges. It knows control nodes,
// decorators, scripted leaves and pre-conditions on one boolean; no blackboard, no scripts.
// Covered by, and used in, tests/exec/tree_reference_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/status.h"
#include "support/tree_table.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace trellis::test {

/// What all nodes of a reference tree share.
struct ReferenceWorld {
    std::string events;   ///< as ScriptHost::events
    bool bumper = false;  ///< what pre-conditions see
    bool woken = false;   ///< a node has asked to be ticked again
    bool fault = false;   ///< a node could not go on
    int tick = 0;         ///< ticks completed, 1 s each
    int writes = 0;       ///< of the entry that is watched
};

/// A node: what it stores, its children and its rules.
class ReferenceNode {
public:
    ReferenceNode(const TreeSpec& spec, ReferenceWorld& world) : spec_(spec), world_(world) {}
    virtual ~ReferenceNode() = default;
    ReferenceNode(const ReferenceNode&) = delete;
    ReferenceNode& operator=(const ReferenceNode&) = delete;

    /// One tick with pre-conditions; stores the result unless it is skipped.
    virtual Status execute();
    /// Halts what runs below, then this.
    virtual void halt() = 0;
    /// What a parent does with a child it is done with: halt it if it runs, then make it idle.
    void reset();

    Status stored = Status::idle;
    std::vector<std::unique_ptr<ReferenceNode>> children;

protected:
    virtual Status tick() = 0;
    void reset_children();
    bool has(char before) const { return spec_.before.find(before) != std::string::npos; }

    const TreeSpec& spec_;
    ReferenceWorld& world_;
};

class ReferenceTree {
public:
    /// `spec` must outlive it.
    explicit ReferenceTree(const TreeSpec& spec);

    /// BehaviorTree.CPP's tickExactlyOnce; with `while_woken`, its tickOnce. Idle after a fault.
    Status step(bool while_woken = false);
    /// BehaviorTree.CPP's haltTree.
    void halt();
    /// Stored statuses in document order, as ScriptRun::statuses without the row of the tree.
    std::string statuses() const;
    std::string take_events();

    ReferenceWorld world;

private:
    std::unique_ptr<ReferenceNode> root_;
};

}  // namespace trellis::test
