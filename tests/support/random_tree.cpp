// Making trees, by chance or all of them.
// SPDX-License-Identifier: MIT
#include "support/random_tree.h"

#include "core/status.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace trellis::test {

namespace {

/// A kind of node: how many children it takes, and its numbers.
struct Kind {
    const char* node;
    int least, most;  ///< children
    int number = 0;
    int second = 0;
};
constexpr int many = 1000;
constexpr std::array controls = {
    Kind{"Sequence", 1, many},
    Kind{"Fallback", 1, many},
    Kind{"ReactiveSequence", 1, many},
    Kind{"ReactiveFallback", 1, many},
    Kind{"AsyncSequence", 1, many},
    Kind{"AsyncFallback", 1, many},
    Kind{"SequenceWithMemory", 1, many},
    Kind{"Parallel", 1, many, -1, 1},
    Kind{"Parallel", 2, many, 1, -1},
    Kind{"ParallelAll", 1, many, 1},
    Kind{"IfThenElse", 2, 3},
    Kind{"WhileDoElse", 2, 3},
    Kind{"Switch2", 3, 3, 2},
    Kind{"TryCatch", 2, many},
    Kind{"TryCatch", 2, many, 1},
};
constexpr std::array decorators = {
    Kind{"Inverter", 1, 1},
    Kind{"ForceSuccess", 1, 1},
    Kind{"ForceFailure", 1, 1},
    Kind{"Repeat", 1, 1, 2},
    Kind{"RetryUntilSuccessful", 1, 1, 2},
    Kind{"KeepRunningUntilFailure", 1, 1},
    Kind{"Delay", 1, 1, 1},
    Kind{"Timeout", 1, 1, 2},
    Kind{"RunOnce", 1, 1},
    Kind{"RunOnce", 1, 1, 1},
    Kind{"Precondition", 1, 1, static_cast<int>(Status::failure)},
    Kind{"LoopInt", 1, 1, 2},
};
/// Of no use in a tree without a Script.
constexpr std::array watchers = {Kind{"SkipUnlessUpdated", 1, 1}, Kind{"WaitValueUpdate", 1, 1}};

template <class List>
const Kind& any_kind(const List& list, Random& random) {
    return list[static_cast<std::size_t>(
        random.whole(0, static_cast<std::int64_t>(list.size()) - 1))];
}

TreeSpec made(const Kind& kind) {
    TreeSpec tree;
    tree.node = kind.node;
    tree.number = kind.number;
    tree.second = kind.second;
    return tree;
}

bool one_in(Random& random, int n) {
    return random.whole(1, n) == 1;
}

TreeSpec random_leaf(Random& random) {
    TreeSpec leaf;
    if (one_in(random, 8)) {
        leaf.node = "Script";
        return leaf;
    }
    const bool synchronous = one_in(random, 4);
    leaf.node = synchronous ? "SyncLeaf" : "Leaf";
    leaf.coded = one_in(random, 2);
    const std::string_view letters = synchronous ? "SFK" : "SSFFRRRK";
    for (std::int64_t n = random.whole(1, 5); n > 0; --n) {
        leaf.script += letters[static_cast<std::size_t>(
            random.whole(0, static_cast<std::int64_t>(letters.size()) - 1))];
    }
    return leaf;
}

using Visit = std::function<void(TreeSpec&)>;

void visit_shapes(int nodes, const Visit& visit);

/// Visits `parent` with every list of children that has `nodes` nodes added to its own.
void visit_forests(TreeSpec& parent, int nodes, const Visit& visit) {
    if (nodes == 0) { return visit(parent); }
    for (int first = 1; first <= nodes; ++first) {
        visit_shapes(first, [&](TreeSpec& child) {
            parent.children.push_back(child);
            visit_forests(parent, nodes - first, visit);
            parent.children.pop_back();
        });
    }
}

template <class Kinds>
void visit_kinds(const Kinds& kinds, int nodes, const Visit& visit) {
    for (const Kind& kind : kinds) {
        TreeSpec tree = made(kind);
        visit_forests(tree, nodes - 1, [&](TreeSpec& whole) {
            const int count = static_cast<int>(whole.children.size());
            if (count >= kind.least && count <= kind.most) { visit(whole); }
        });
    }
}

void visit_shapes(int nodes, const Visit& visit) {
    if (nodes == 1) {
        TreeSpec leaf;
        leaf.node = "Leaf";
        return visit(leaf);
    }
    visit_kinds(controls, nodes, visit);
    visit_kinds(decorators, nodes, visit);
}

void collect_leaves(TreeSpec& tree, std::vector<TreeSpec*>& out) {
    if (tree.node == "Leaf" || tree.node == "SyncLeaf") { out.push_back(&tree); }
    for (TreeSpec& child : tree.children) {
        collect_leaves(child, out);
    }
}

}  // namespace

TreeSpec random_tree(Random& random, int nodes, bool conditions) {
    TreeSpec tree;
    if (nodes <= 1) {
        tree = random_leaf(random);
    } else if (one_in(random, 3)) {
        tree = made(one_in(random, 6) ? any_kind(watchers, random) : any_kind(decorators, random));
        if (tree.node.starts_with("Re")) {
            tree.number = static_cast<int>(random.whole(one_in(random, 8) ? -1 : 0, 3));
        }
        if (tree.node == "Delay" || tree.node == "Timeout" || tree.node == "LoopInt") {
            tree.number = static_cast<int>(random.whole(0, 3));
        }
        if (tree.node == "Precondition") { tree.number = static_cast<int>(random.whole(1, 4)); }
        tree.children.push_back(random_tree(random, nodes - 1, conditions));
    } else {
        const Kind& kind = any_kind(controls, random);
        tree = made(kind);
        for (int left = nodes - 1, made_so_far = 0; made_so_far < kind.most; ++made_so_far) {
            if (left <= 0 && made_so_far >= kind.least) { break; }
            const bool last = made_so_far + 1 == kind.most;
            const int size = last ? left : static_cast<int>(random.whole(1, std::max(left, 1)));
            tree.children.push_back(random_tree(random, std::max(size, 1), conditions));
            left -= size;
        }
        if (tree.node == "Switch2") { tree.number = static_cast<int>(random.whole(1, 3)); }
        if (tree.node.starts_with("Parallel")) {
            const auto most = static_cast<std::int64_t>(tree.children.size());
            tree.number = static_cast<int>(random.whole(-2, most));
            tree.second = static_cast<int>(random.whole(-2, most));
            if (tree.node == "ParallelAll") { tree.second = 0; }
        }
    }
    if (conditions && one_in(random, 5)) {
        tree.before = std::string(1, "fskw"[static_cast<std::size_t>(random.whole(0, 3))]);
    }
    return tree;
}

void for_each_shape(int nodes, const std::function<void(TreeSpec&)>& visit) {
    visit_shapes(nodes, visit);
}

std::vector<TreeSpec*> leaves_of(TreeSpec& tree) {
    std::vector<TreeSpec*> out;
    collect_leaves(tree, out);
    return out;
}

}  // namespace trellis::test
