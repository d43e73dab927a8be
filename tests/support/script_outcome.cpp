// Running one script and spelling its outcome.
// SPDX-License-Identifier: MIT
#include "support/script_outcome.h"

#include "core/number.h"
#include "support/expressions.h"

#include <algorithm>
#include <vector>

namespace trellis::test {

namespace {

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
        if (world.slots[i].is(Value::Kind::undefined)) { continue; }
        entries.push_back(world.slot_names[i] + "=" + recorded(world.slots[i]));
    }
    std::sort(entries.begin(), entries.end());
    std::string line;
    for (const std::string& entry : entries) {
        line += (line.empty() ? "" : " ") + entry;
    }
    return line;
}

}  // namespace

ScriptOutcome outcome_of(const std::string& script) {
    ExpressionWorld world(Dialect::tree);
    world.add_enum("RED", 1);
    world.add_enum("GREEN", 2);
    world.add_enum("BLUE", 3);
    for (const char* start :
         {"i := 3", "j := -2", "d := 1.5", "s := 'abc'", "n := '7'", "b := true"}) {
        world.run(start);
    }
    const CodeId id = world.compile(script);
    if (!id) { return {"PARSE_ERROR", blackboard(world)}; }
    EvalContext context = world.context();
    Value result;
    const bool fine = evaluate(world.code, id, context, result);
    return {fine ? recorded(result) : "RUN_ERROR", blackboard(world)};
}

}  // namespace trellis::test
