// The tree files behind one program: the main file, what it includes, and where each tree and each
// subtree model stands. Private to runtime/load. Covered by tests/load/compile_tree_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/builder.h"

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace trellis {

/// A <BehaviorTree>.
struct TreeSource {
    const ReadFile* file = nullptr;
    ElementId element;  ///< the <BehaviorTree>; its only child is the root node
    std::string id;
};

/// A port of a <SubTree> in a <TreeNodesModel>: what must, or need not, be passed.
struct SubtreePort {
    std::string name;
    std::string initial;
    bool has_initial = false;
    Where where = {};
};

class TreeFiles {
public:
    explicit TreeFiles(Builder& builder) : builder_(builder), left_(builder.options().limits) {}

    /// Reads a file that is already a document, and all it includes. Errors: files that cannot be
    /// read, include cycles, trees without an ID, or with the ID of another.
    void add(ReadFile file);

    /// The tree that runs: the one named, else the one the main file says, else its only one. Null,
    /// and an error, if that is none.
    const TreeSource* main_tree(std::string_view named);
    /// The tree of that ID, or null.
    const TreeSource* find(std::string_view id) const;
    const std::deque<TreeSource>& trees() const { return trees_; }
    std::vector<std::string_view> ids() const;
    /// The declared ports of a subtree; null if it has no model.
    const std::vector<SubtreePort>* model(std::string_view id) const;

private:
    void add_element(const ReadFile& file, ElementId e);
    void add_include(const ReadFile& file, ElementId e);
    /// Counts a file that an <include> at `where` names; false, and an error, beyond the limits.
    bool take_include(const Source& source, Where where);
    void add_tree(const ReadFile& file, ElementId e);
    void add_models(const ReadFile& file, ElementId e);

    Builder& builder_;
    std::deque<ReadFile> files_;  // a deque: trees point into it
    std::deque<TreeSource> trees_;
    std::unordered_map<std::string_view, const TreeSource*> by_id_;
    std::unordered_map<std::string, std::vector<SubtreePort>> models_;
    std::vector<std::string> including_;  // the chain of files being read
    DocumentLimits left_;                 // of the files that are still to be read, together
    std::uint32_t includes_ = 0;          // of all files
    bool includes_end_ = false;           // the limits are reached, which has been said
};

}  // namespace trellis
