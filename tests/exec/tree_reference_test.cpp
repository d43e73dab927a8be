// The interpreter of trees against a slow reference: every tree of up to four nodes with every
// script of two letters, every shape of five nodes with some, and random trees with conditions.
// SPDX-License-Identifier: MIT
#include "support/loading.h"
#include "support/random_tree.h"
#include "support/reference_tree.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {
namespace {

constexpr std::string_view letters = "SFRK";
constexpr std::size_t scripts = 16;  // of two letters

std::string script(std::size_t number) {
    return {letters[number / 4], letters[number % 4]};
}

/// Texts of a program that stand for the scripts: "@0", "@1", … in the order of the leaves.
std::vector<Value*> placeholders(Program& program, std::size_t count) {
    std::vector<Value*> out(count);
    for (Value& constant : program.code.constants) {
        if (!constant.is(Value::Kind::text) || !constant.as_text().starts_with('@')) { continue; }
        out[std::stoul(constant.as_text().substr(1))] = &constant;
    }
    return out;
}

/// One line per tick: what was returned, reported and stored. Row 0, the tree itself, is left out.
template <class Step, class Statuses, class Events>
void append_tick(std::string& out, Step step, Statuses statuses, Events events) {
    out += "-RSFK"[static_cast<std::size_t>(step())];
    out += ' ';
    out += statuses();
    out += ' ';
    out += events();
    out += '\n';
}

std::string told(const Program& program, int ticks, bool woken, std::string_view bumper) {
    ScriptRun run(program);
    std::string out;
    for (int i = 0; i < ticks; ++i) {
        run.host.bumper = bumper[static_cast<std::size_t>(i) % bumper.size()] == '1';
        append_tick(
            out, [&] { return run.step({.dt = 1.0, .while_woken = woken}); },
            [&] { return run.statuses().substr(1); }, [&] { return run.take_events(); });
    }
    return out;
}

std::string expected(const TreeSpec& spec, int ticks, bool woken, std::string_view bumper) {
    ReferenceTree tree(spec);
    std::string out;
    for (int i = 0; i < ticks; ++i) {
        tree.world.bumper = bumper[static_cast<std::size_t>(i) % bumper.size()] == '1';
        append_tick(
            out, [&] { return tree.step(woken); }, [&] { return tree.statuses(); },
            [&] { return tree.take_events(); });
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

/// Compares one shape with every `step`-th combination of scripts.
void compare_shape(TreeSpec& shape, std::size_t step, bool woken, Comparison& comparison) {
    const std::vector<TreeSpec*> leaves = leaves_of(shape);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        leaves[i]->script = '@' + std::to_string(i);
    }
    Program program = loaded(xml_of(shape));
    const std::vector<Value*> texts = placeholders(program, leaves.size());
    std::size_t combinations = 1;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        combinations *= scripts;
    }
    for (std::size_t number = 0; number < combinations; number += step) {
        std::size_t rest = number;
        for (std::size_t i = 0; i < leaves.size(); ++i, rest /= scripts) {
            leaves[i]->script = script(rest % scripts);
            texts[i]->set_text(leaves[i]->script);
        }
        comparison.add(shape, told(program, 4, woken, "0"), expected(shape, 4, woken, "0"));
    }
}

}  // namespace

TEST_CASE("tree reference: all trees of up to four nodes do the same, tick by tick") {
    Comparison comparison;
    for (int nodes = 1; nodes <= 4; ++nodes) {
        for (TreeSpec& shape : all_shapes(nodes)) {
            compare_shape(shape, 1, false, comparison);
        }
    }
    MESSAGE(comparison.trees, " trees compared, ", comparison.differ, " differ");
    CHECK(comparison.differ == 0);
}

TEST_CASE("tree reference: all shapes of five nodes do the same with some scripts") {
    Comparison comparison;
    std::size_t step = 1;
    for (TreeSpec& shape : all_shapes(5)) {
        step = step % 97 + 61;  // other scripts for every shape
        compare_shape(shape, step, step % 2 == 0, comparison);
    }
    MESSAGE(comparison.trees, " trees compared, ", comparison.differ, " differ");
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
        if (woken && notation(spec).find("[-1]") != std::string::npos) { continue; }
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
        for (int tick = 0; tick < 10; ++tick) {
            run.host.bumper = tree.world.bumper = random.whole(0, 3) == 0;
            append_tick(
                here, [&] { return run.step(); }, [&] { return run.statuses().substr(1); },
                [&] { return run.take_events(); });
            append_tick(
                reference, [&] { return tree.step(); }, [&] { return tree.statuses(); },
                [&] { return tree.take_events(); });
            if (random.whole(0, 2) == 0) {
                run.halt();
                tree.halt();
                here += "halt " + run.statuses().substr(1) + ' ' + run.take_events() + '\n';
                reference += "halt " + tree.statuses() + ' ' + tree.take_events() + '\n';
            }
        }
        comparison.add(spec, here, reference);
    }
    MESSAGE(comparison.trees, " trees compared, ", comparison.differ, " differ");
    CHECK(comparison.differ == 0);
}

}  // namespace trellis::test
