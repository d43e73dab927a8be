// script_driver FILE: runs one script per line of FILE, each on a fresh blackboard, and prints
// "<line number> <result> | <blackboard after it>" for each. What it does is in
// support/script_outcome.cpp, covered by tests/exec/scripts_test.cpp.
// SPDX-License-Identifier: MIT
#include "support/script_outcome.h"

#include <cstdio>
#include <fstream>
#include <string>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: script_driver FILE\n", stderr);
        return 2;
    }
    std::ifstream file(argv[1]);
    if (!file) {
        std::fprintf(stderr, "cannot read %s\n", argv[1]);
        return 3;
    }
    int number = 0;
    for (std::string script; std::getline(file, script);) {
        const trellis::test::ScriptOutcome outcome = trellis::test::outcome_of(script);
        std::printf("%d %s | %s\n", ++number, outcome.result.c_str(), outcome.blackboard.c_str());
    }
    return 0;
}
