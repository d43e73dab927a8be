// Trees in one line, and what they did as a table: "ReactiveSequence(SF, RR)". Covered by
// tests/exec/tree_test.cpp.
//
//     tree  = NODE | NODE[NUMBER] , each with (tree, …)   "Repeat[2](SF)"
//           | Parallel[SUCCESSES:FAILURES](tree, …)
//           | SCRIPT                                      a Leaf: the letters S F R K, a tick each
//           | =SCRIPT                                     a SyncLeaf; #SCRIPT, =#SCRIPT: coded ones
//           | Script                                      writes the entry that *Updated watch
//     NUMBER is the port that a node has: a time in s, how many elements a queue has, the variable
//     of a Switch with the cases 1, 2, …; of booleans 0 is the default, 1 the other value; of
//     Precondition (if="_x.bumper") the status `else`.
//     before any of them: f? s? k? w?   _failureIf, _successIf, _skipIf, _while="_x.bumper"
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

/// A tree with scripted leaves. Leaves are called a, b, c, … in order.
struct TreeSpec {
    std::string node;    ///< the element: "Sequence", "Leaf", …
    std::string script;  ///< of a leaf
    /// Its id and script are numbers, so that no tick has to read them, and it reports no halt.
    bool coded = false;
    int number = 0;      ///< its port: see above
    int second = 0;      ///< failure_count
    std::string before;  ///< letters of the pre-conditions it has: f s k w
    std::vector<TreeSpec> children;
};

/// The tree that `text` spells; it must be right.
TreeSpec parse_tree(std::string_view text);
/// The text that spells `tree`.
std::string notation(const TreeSpec& tree);
/// The tree file with that tree.
std::string xml_of(const TreeSpec& tree);

/// What the root returned, a letter per tick, then the stored statuses after each tick of every
/// node from the root on, '-' for idle: table("ReactiveSequence(SF, RR)", 2) == "RF | R- S- R-".
/// `bumper` is what pre-conditions see, '1' or '0' per tick, cyclically.
std::string table(std::string_view text, std::size_t ticks, std::string_view bumper = "0");

/// What the leaves reported, ticks separated by " / ": "a:SUCCESS b:RUNNING / a:FAILURE b:HALT".
std::string events(std::string_view text, std::size_t ticks, std::string_view bumper = "0");

}  // namespace trellis::test
