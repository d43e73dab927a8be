// What a row shows at a tick, from the events up to it.
// SPDX-License-Identifier: MIT
#include "runner/row_statuses.h"

#include <doctest/doctest.h>

using namespace trellis;

namespace {

using Kind = TraceEvent::Kind;
constexpr RowId row{0};

Program one_row() {
    Program program;
    program.rows.resize(1);
    program.transitions.resize(1);
    return program;
}

TraceEvent status(std::uint64_t tick, Status from, Status to) {
    return {.tick = tick, .kind = Kind::status, .row = row, .from = from, .to = to};
}

}  // namespace

TEST_CASE("row statuses: a node that ended shows how during the tick, then idle") {
    const Program program = one_row();
    RowStatuses statuses(program);
    CHECK(statuses.at(row, 1) == Status::idle);
    CHECK_FALSE(statuses.reached(row));
    statuses.on(status(1, Status::idle, Status::running));
    CHECK(statuses.at(row, 1) == Status::running);
    CHECK(statuses.at(row, 2) == Status::running);
    statuses.on(status(3, Status::running, Status::success));
    statuses.on(status(3, Status::success, Status::idle));
    CHECK(statuses.at(row, 3) == Status::success);
    CHECK(statuses.at(row, 4) == Status::idle);
    CHECK(statuses.reached(row));
}

TEST_CASE("row statuses: one that keeps its result shows it") {
    const Program program = one_row();
    RowStatuses statuses(program);
    statuses.on(status(1, Status::idle, Status::failure));
    CHECK(statuses.at(row, 5) == Status::failure);
}

TEST_CASE("row statuses: a halted node is idle, a skipped one skipped") {
    const Program program = one_row();
    RowStatuses statuses(program);
    statuses.on({.tick = 1, .kind = Kind::tick, .row = row, .to = Status::running});
    statuses.on(status(1, Status::idle, Status::running));
    statuses.on({.tick = 1, .kind = Kind::halt, .row = row});
    statuses.on(status(1, Status::running, Status::idle));
    CHECK(statuses.at(row, 1) == Status::idle);
    statuses.on(status(2, Status::idle, Status::running));
    statuses.on({.tick = 3, .kind = Kind::skip, .row = row});
    CHECK(statuses.at(row, 3) == Status::skipped);
    CHECK(statuses.at(row, 4) == Status::running);
    statuses.on(status(3, Status::running, Status::idle));
    CHECK(statuses.at(row, 3) == Status::skipped);
}

TEST_CASE("row statuses: transitions") {
    const Program program = one_row();
    RowStatuses statuses(program);
    CHECK_FALSE(statuses.taken({0}));
    statuses.on({.tick = 2, .kind = Kind::transition, .row = row, .transition = {0}});
    CHECK(statuses.taken({0}));
    CHECK(statuses.taken({0}, 2));
    CHECK_FALSE(statuses.taken({0}, 3));
}
