// The 963 scripts of which BehaviorTree.CPP 4.10's results are recorded: every one must give
// exactly that result and leave exactly that blackboard.
// SPDX-License-Identifier: MIT
#include "core/number.h"
#include "support/expressions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace trellis {
namespace {

// as the recordings write values
std::string recorded(const Value& v) {
    switch (v.kind()) {
    case Value::Kind::undefined: return "<empty>";
    case Value::Kind::integer: return std::string("i").append(std::to_string(v.as_integer()));
    case Value::Kind::real: return std::string("d").append(format_g17(v.as_real()));
    case Value::Kind::text: return "'" + v.as_text() + "'";
    default: return print(v);
    }
}

std::string blackboard(const ExpressionWorld& world) {
    std::vector<std::string> entries;
    for (std::size_t i = 0; i < world.slots.size(); ++i) {
        if (world.slots[i].is(Value::Kind::undefined)) continue;
        entries.push_back(world.slot_names[i] + "=" + recorded(world.slots[i]));
    }
    std::sort(entries.begin(), entries.end());
    std::string line;
    for (const std::string& e : entries)
        line += (line.empty() ? "" : " ") + e;
    return line;
}

struct Outcome {
    std::string result;
    std::string blackboard;
};

Outcome outcome_of(const std::string& script) {
    ExpressionWorld world(Dialect::tree);
    world.add_enum("RED", 1);
    world.add_enum("GREEN", 2);
    world.add_enum("BLUE", 3);
    for (const char* start :
         {"i := 3", "j := -2", "d := 1.5", "s := 'abc'", "n := '7'", "b := true"}) {
        world.run(start);
    }
    const CodeId id = world.compile(script);
    if (!id) return {"PARSE_ERROR", blackboard(world)};
    EvalContext context = world.context();
    Value result;
    const bool fine = evaluate(world.code, id, context, result);
    return {fine ? recorded(result) : "RUN_ERROR", blackboard(world)};
}

}  // namespace

TEST_CASE("scripts: every recorded script gives what BehaviorTree.CPP gave") {
    std::ifstream file(TRELLIS_SHARED_DIR "/conformance/scripts/scripts.tsv");
    if (!file) {
        MESSAGE("no recorded scripts in " TRELLIS_SHARED_DIR);
        return;
    }
    int count = 0;
    for (std::string line; std::getline(file, line); ++count) {
        const std::size_t first = line.find('\t');
        const std::size_t second = line.find('\t', first + 1);
        REQUIRE(second != std::string::npos);
        const std::string script = line.substr(0, first);
        CAPTURE(script);
        const Outcome outcome = outcome_of(script);
        CHECK(outcome.result == line.substr(first + 1, second - first - 1));
        CHECK(outcome.blackboard == line.substr(second + 1));
    }
    MESSAGE(count, " recorded scripts");
    CHECK(count == 963);
}

}  // namespace trellis
