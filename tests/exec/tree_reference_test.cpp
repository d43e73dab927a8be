// The interpreter of trees against a slow reference: trees of up to five nodes over all controls
// and decorators with scripts of two letters, and random trees over all nodes, with conditions. Of
// the larger ones every so many are compared, all 61.3 million if TRELLIS_EXHAUSTIVE is set (7
// minutes, optimised).
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/random_tree.h"
#include "support/reference_tree.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis::test {
namespace {

constexpr std::string_view letters = "SFRK";
constexpr std::size_t scripts = 16;  // of two letters

std::string script(std::size_t number) {
    return {letters[number / 4], letters[number % 4]};
}

/// A tree whose leaves can be given other scripts without loading it again.
class ScriptedTree {
public:
    /// `coded`: the leaves of `shape` are to be coded ones. `shape` must outlive this.
    ScriptedTree(TreeSpec& shape, bool coded) : leaves_(leaves_of(shape)) {
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            leaves_[i]->coded = coded;
            leaves_[i]->script = coded ? "S" : '@' + std::to_string(i);
        }
        program_ = loaded(xml_of(shape));
        texts_.resize(leaves_.size());
        for (Value& constant : program_.code.constants) {
            const bool is_script =
                constant.is(Value::Kind::text) && constant.as_text().starts_with('@');
            if (is_script) { texts_[std::stoul(constant.as_text().substr(1))] = &constant; }
        }
    }

    const Program& program() const { return program_; }
    std::size_t leaves() const { return leaves_.size(); }
    void set(std::size_t i, std::string script) {
        if (leaves_[i]->coded) {
            const LeafCall& call = program_.calls[i];
            const std::int32_t code = code_of(script);
            std::memcpy(program_.prototypes.data() + call.prototype +
                            call.type->find("script")->offset,
                        &code, sizeof code);
        } else {
            texts_[i]->set_text(script);
        }
        leaves_[i]->script = std::move(script);
    }

private:
    std::vector<TreeSpec*> leaves_;
    Program program_;
    std::vector<Value*> texts_;  // by leaf, if it is not coded
};

/// One line per tick: what was returned, reported and stored. Row 0, the tree itself, is left out.
std::string line(Status status, std::string_view stored, std::string_view events) {
    return std::string(1, "-RSFK"[static_cast<std::size_t>(status)]) + ' ' + std::string(stored) +
           ' ' + std::string(events) + '\n';
}
std::string ticked(ScriptRun& run, bool woken = false) {
    const Status status = run.step({.dt = 1.0, .while_woken = woken});
    const std::string events = run.take_events();
    return run.state.fault ? "fault\n" : line(status, run.statuses().substr(1), events);
}
std::string ticked(ReferenceTree& tree, bool woken = false) {
    const Status status = tree.step(woken);
    const std::string events = tree.take_events();
    return tree.world.fault ? "fault\n" : line(status, tree.statuses(), events);
}
std::string halted(ScriptRun& run) {
    run.halt();
    const std::string events = run.take_events();
    return run.state.fault ? "fault\n" : line(Status::idle, run.statuses().substr(1), events);
}
std::string halted(ReferenceTree& tree) {
    tree.halt();
    const std::string events = tree.take_events();
    return tree.world.fault ? "fault\n" : line(Status::idle, tree.statuses(), events);
}

std::string told(const Program& program, int ticks, bool woken, std::string_view bumper) {
    ScriptRun run(program);
    std::string out;
    for (int i = 0; i < ticks && !run.state.fault; ++i) {
        run.host.bumper = bumper[static_cast<std::size_t>(i) % bumper.size()] == '1';
        out += ticked(run, woken);
    }
    return out;
}

std::string expected(const TreeSpec& spec, int ticks, bool woken, std::string_view bumper) {
    ReferenceTree tree(spec);
    std::string out;
    for (int i = 0; i < ticks && !tree.world.fault; ++i) {
        tree.world.bumper = bumper[static_cast<std::size_t>(i) % bumper.size()] == '1';
        out += ticked(tree, woken);
    }
    return out;
}

struct Comparison {
    std::size_t trees = 0;
    std::size_t differ = 0;

    void add(const TreeSpec& spec, const std::string& here, const std::string& reference) {
        ++trees;
        if (here == reference) { return; }
        if (++differ > 5) { return; }
        const std::string tree = notation(spec);
        CAPTURE(tree);
        CHECK(here == reference);
    }
};

/// Trees of so many nodes with all scripts of two letters: one in `step`, counted over all shapes.
void compare_all(int nodes, std::size_t step, bool coded, bool woken, Comparison& comparison) {
    if (std::getenv("TRELLIS_EXHAUSTIVE") != nullptr) { step = 1; }
    std::size_t skipped = 0;  // until the next one
    for_each_shape(nodes, [&](TreeSpec& shape) {
        std::size_t combinations = 1;
        for (std::size_t i = leaves_of(shape).size(); i != 0; --i) {
            combinations *= scripts;
        }
        if (skipped >= combinations) {
            skipped -= combinations;
            return;
        }
        ScriptedTree tree(shape, coded);
        std::size_t number = skipped;
        for (; number < combinations; number += step) {
            std::size_t rest = number;
            for (std::size_t i = 0; i < tree.leaves(); ++i, rest /= scripts) {
                tree.set(i, script(rest % scripts));
            }
            comparison.add(shape, told(tree.program(), 4, woken, "1101"),
                           expected(shape, 4, woken, "1101"));
        }
        skipped = number - combinations;
    });
}

}  // namespace

TEST_CASE("tree reference: all trees of up to three nodes do the same, tick by tick") {
    Comparison comparison;
    for (int nodes = 1; nodes <= 3; ++nodes) {
        compare_all(nodes, 1, false, false, comparison);
        compare_all(nodes, 1, false, true, comparison);
        compare_all(nodes, 1, true, false, comparison);
    }
    MESSAGE(comparison.trees, " trees compared, ", comparison.differ, " differ");
    CHECK(comparison.differ == 0);
}

TEST_CASE("tree reference: trees of four and five nodes do the same, tick by tick") {
    Comparison comparison;
    compare_all(4, 23, false, false, comparison);
    compare_all(4, 101, false, true, comparison);
    compare_all(4, 23, true, false, comparison);
    compare_all(5, 5003, false, false, comparison);
    compare_all(5, 10007, false, true, comparison);
    compare_all(5, 5003, true, false, comparison);
    MESSAGE(comparison.trees, " trees compared, ", comparison.differ, " differ");
    CHECK(comparison.differ == 0);
}

TEST_CASE("tree reference: a leaf that was skipped while it ran comes back as it was") {
    Comparison comparison;
    for (const char* text :
         {"Repeat[2](Sequence(#SS, LoopInt[2](#KR)))", "Repeat[2](Sequence(LoopInt[2](#KR), #RS))",
          "Repeat[3](Sequence(Switch2[1](#RK, #S, #S), #RS))", "Sequence(#RK, #RRS)",
          "Repeat[3](Sequence(Inverter(#RK), SkipUnlessUpdated(#RK), #RRS))"}) {
        const TreeSpec spec = parse_tree(text);
        const Program program = loaded(xml_of(spec));
        comparison.add(spec, told(program, 12, false, "0"), expected(spec, 12, false, "0"));
    }
    CHECK(comparison.differ == 0);
}

TEST_CASE("tree reference: random trees with conditions do the same") {
    Random random(std::int64_t{20});
    Comparison comparison;
    for (int i = 0; i < 3000; ++i) {
        const TreeSpec spec = random_tree(random, static_cast<int>(random.whole(2, 40)));
        const bool woken = random.whole(0, 1) == 1;
        const Program program = loaded(xml_of(spec));
        // a loop without end would never come back from a tick that waits for it
        if (woken && notation(spec).find("[-1](") != std::string::npos) { continue; }
        comparison.add(spec, told(program, 12, woken, "00100110"),
                       expected(spec, 12, woken, "00100110"));
    }
    MESSAGE(comparison.trees, " trees compared, ", comparison.differ, " differ");
    CHECK(comparison.differ == 0);
}

TEST_CASE("tree reference: random trees are halted alike, at any time") {
    Random random(std::int64_t{21});
    Comparison comparison;
    for (int i = 0; i < 1000; ++i) {
        const TreeSpec spec = random_tree(random, static_cast<int>(random.whole(2, 30)));
        const Program program = loaded(xml_of(spec));
        ScriptRun run(program);
        ReferenceTree tree(spec);
        std::string here;
        std::string reference;
        for (int tick = 0; tick < 10 && !run.state.fault; ++tick) {
            run.host.bumper = tree.world.bumper = random.whole(0, 3) == 0;
            here += ticked(run);
            reference += ticked(tree);
            if (!run.state.fault && random.whole(0, 2) == 0) {
                here += halted(run);
                reference += halted(tree);
            }
        }
        comparison.add(spec, here, reference);
    }
    MESSAGE(comparison.trees, " trees compared, ", comparison.differ, " differ");
    CHECK(comparison.differ == 0);
}

}  // namespace trellis::test
