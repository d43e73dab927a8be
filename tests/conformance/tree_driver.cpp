// tree_driver FILE N [--once] [--halt-at=K,..] [--transitions] [--no-bb] [--main=ID]: runs a tree
// file with scripted leaves and prints what BehaviorTree.CPP's recorded runs print. What it does is
// in support/tree_driver.cpp, covered by tests/exec/tree_cases_test.cpp.
// SPDX-License-Identifier: MIT
#include "support/tree_driver.h"

#include <cstdio>
#include <string>
#include <vector>

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty()) {
        std::fputs(
            "usage: tree_driver FILE [N] [--once] [--halt-at=K,..] [--transitions] [--no-bb] "
            "[--main=ID]\n",
            stderr);
        return 2;
    }
    const trellis::test::Drive drive = trellis::test::drive_tree(
        words[0], trellis::test::drive_options({words.begin() + 1, words.end()}));
    std::fputs(drive.output.c_str(), stdout);
    std::fputs(drive.messages.c_str(), stderr);
    return 0;
}
