// The tables of programs: what rows, names and statuses are called, intervals, comparison, dumps.
// SPDX-License-Identifier: MIT
#include "core/program.h"

#include "support/loading.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <type_traits>

namespace trellis {
namespace {

// ids of different tables do not mix
static_assert(!std::is_convertible_v<RowId, SlotId>);
static_assert(!std::is_convertible_v<int, RowId>);
static_assert(!RowId());
static_assert(RowId{3} < RowId{4} && RowId{0});
static_assert(is_done(Status::success) && is_done(Status::failure) && !is_done(Status::skipped));

Program sample() {
    return test::loaded("<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence name='s'><Inverter>"
                        "<Leaf name='l' script='S'/></Inverter><Fallback><Leaf script='F'/>"
                        "<Leaf script='R'/></Fallback></Sequence></BehaviorTree></root>");
}

std::string child_names(const Program& program, Children children) {
    std::string out;
    for (const RowId n : children) {
        out += std::string(program.name(n)) + ' ';
    }
    return out;
}

}  // namespace

TEST_CASE("program: statuses have the names of BehaviorTree.CPP") {
    std::string all;
    for (const Status s :
         {Status::idle, Status::running, Status::success, Status::failure, Status::skipped}) {
        all += std::string(name_of(s)) + ' ';
    }
    CHECK(all == "IDLE RUNNING SUCCESS FAILURE SKIPPED ");
}

TEST_CASE("program: the table of ops is indexed by op, with its own name and a line of doc each") {
    std::size_t i = 0;
    for (const OpInfo& info : op_table()) {
        CHECK(static_cast<std::size_t>(info.op) == i++);
        CHECK(&op_table()[info.op] == &info);
        CHECK_FALSE(info.name.empty());
        CHECK_FALSE(info.doc.empty());
        CHECK(info.least_children <= info.most_children);
    }
    CHECK(op_table()[Op::retry].element == "RetryUntilSuccessful");
}

TEST_CASE("program: the subtree of a row is an interval, its children are found by jumping") {
    const Program p = sample();
    CHECK(child_names(p, children(p, {1})) == "Inverter Fallback ");
    CHECK(child_names(p, children(p, {1}).first(1)) == "Inverter ");
    CHECK(child_names(p, children(p, {1}).first(0)).empty());
    CHECK(child_names(p, children(p, {3})).empty());
    CHECK(p.within({3}, {1}));
    CHECK(p.within({1}, {1}));
    CHECK_FALSE(p.within({4}, {2}));
    CHECK_FALSE(p.within({1}, {2}));
}

TEST_CASE("program: compares behaviour, not places or file names") {
    const Program a = sample();
    Program b = a;
    b.origins[1].line = 99;
    b.files = {"elsewhere"};
    CHECK(a == b);
    b.names.texts[1] = "other";
    CHECK_FALSE(a == b);
    b = a;
    b.rows[2].op = Op::force_success;
    CHECK_FALSE(a == b);
    b = a;
    b.code.constants.back().set_text("changed");
    CHECK_FALSE(a == b);
}

TEST_CASE("program: the dump shows a row per line, indented by depth, with names for numbers") {
    const std::string text = dump(sample());
    CHECK(text.starts_with("rows\n"
                           "0  tree \"T\" end 7 arg 0\n"
                           "1    sequence \"s\" end 7 arg 0\n"
                           "2      inverter \"Inverter\" end 4 arg 0\n"
                           "3        action \"l\" end 4 arg 0\n"));
    CHECK(text.find("\ncalls\n  Leaf at ") != std::string::npos);
}

}  // namespace trellis
