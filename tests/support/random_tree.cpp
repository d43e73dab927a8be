// Making trees, by chance or all of them.
// SPDX-License-Identifier: MIT
#include "support/random_tree.h"

#include <array>

namespace trellis::test {

namespace {

constexpr std::array controls = {"Sequence", "Fallback", "ReactiveSequence", "ReactiveFallback"};
constexpr std::array decorators = {"Inverter", "ForceSuccess", "ForceFailure", "Repeat",
                                   "RetryUntilSuccessful"};

template <class List>
const char* any_of(const List& list, Random& random) {
    return list[static_cast<std::size_t>(
        random.whole(0, static_cast<std::int64_t>(list.size()) - 1))];
}

bool one_in(Random& random, int n) {
    return random.whole(1, n) == 1;
}

TreeSpec random_leaf(Random& random) {
    TreeSpec leaf;
    const bool synchronous = one_in(random, 4);
    leaf.node = synchronous ? "SyncLeaf" : "Leaf";
    const std::string_view letters = synchronous ? "SFK" : "SSFFRRRK";
    for (std::int64_t n = random.whole(1, 5); n > 0; --n) {
        leaf.script += letters[static_cast<std::size_t>(
            random.whole(0, static_cast<std::int64_t>(letters.size()) - 1))];
    }
    return leaf;
}

std::vector<std::vector<TreeSpec>> all_forests(int nodes) {
    std::vector<std::vector<TreeSpec>> out;
    if (nodes == 0) { return {{}}; }
    for (int first = 1; first <= nodes; ++first) {
        const std::vector<std::vector<TreeSpec>> rests = all_forests(nodes - first);
        for (const TreeSpec& tree : all_shapes(first)) {
            for (const std::vector<TreeSpec>& rest : rests) {
                std::vector<TreeSpec>& forest = out.emplace_back();
                forest.push_back(tree);
                forest.insert(forest.end(), rest.begin(), rest.end());
            }
        }
    }
    return out;
}

void collect_leaves(TreeSpec& tree, std::vector<TreeSpec*>& out) {
    if (tree.children.empty()) { out.push_back(&tree); }
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
        tree.node = any_of(decorators, random);
        if (tree.node.starts_with("Re")) {
            tree.number = static_cast<int>(random.whole(one_in(random, 8) ? -1 : 0, 3));
        }
        tree.children.push_back(random_tree(random, nodes - 1, conditions));
    } else {
        tree.node = any_of(controls, random);
        for (int left = nodes - 1; left > 0;) {
            const int size = static_cast<int>(random.whole(1, left));
            tree.children.push_back(random_tree(random, size, conditions));
            left -= size;
        }
    }
    if (conditions && one_in(random, 5)) {
        tree.before = std::string(1, "fskw"[static_cast<std::size_t>(random.whole(0, 3))]);
    }
    return tree;
}

std::vector<TreeSpec> all_shapes(int nodes) {
    std::vector<TreeSpec> out;
    if (nodes == 1) {
        TreeSpec leaf;
        leaf.node = "Leaf";
        out.push_back(leaf);
        return out;
    }
    for (const std::vector<TreeSpec>& forest : all_forests(nodes - 1)) {
        for (const char* node : controls) {
            TreeSpec& tree = out.emplace_back();
            tree.node = node;
            tree.children = forest;
        }
        if (forest.size() != 1) { continue; }
        for (const char* node : decorators) {
            TreeSpec& tree = out.emplace_back();
            tree.node = node;
            tree.number = tree.node.starts_with("Re") ? 2 : 0;
            tree.children = forest;
        }
    }
    return out;
}

std::vector<TreeSpec*> leaves_of(TreeSpec& tree) {
    std::vector<TreeSpec*> out;
    collect_leaves(tree, out);
    return out;
}

}  // namespace trellis::test
