// Event names as intervals: a descriptor is a row, and what it matches are the rows inside it.
// SPDX-License-Identifier: MIT
#include "load/event_names.h"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {
namespace {

std::vector<EventName> table_of(const std::vector<std::string>& names) {
    EventNames all;
    for (const std::string& name : names) {
        all.add(name);
    }
    return all.table();
}

/// The rule itself: a prefix of whole tokens (SCXML 3.12.1).
bool is_prefix(std::string_view prefix, std::string_view name) {
    return prefix.empty() || name == prefix ||
           (name.starts_with(prefix) && name[prefix.size()] == '.');
}

}  // namespace

TEST_CASE(
    "event names: rows are the names, the empty one first, each before what it is a prefix of") {
    std::string texts;
    for (const EventName& row : table_of({"b", "a.x", "a-b", "a", "ab", "a.x.y", "done.state.s"})) {
        texts += '[' + row.text + ' ' + std::to_string(row.end.index) + ']';
    }
    CHECK(texts == "[ 8][a 4][a.x 4][a.x.y 4][a-b 5][ab 6][b 7][done.state.s 8]");
}

TEST_CASE("event names: the forms of a descriptor are one row") {
    const std::vector<EventName> table = table_of({"a.b", "*"});
    for (const char* spelling : {"a.b", "a.b.", "a.b.*"}) {
        CHECK(EventNames::find(table, spelling) == EventId{1});
    }
    for (const char* all : {"*", ".*"}) {
        CHECK(EventNames::find(table, all) == EventId{0});
    }
    CHECK_FALSE(EventNames::find(table, "a"));
    CHECK_FALSE(EventNames::find(table, "a.b.c"));
}

TEST_CASE("event names: intervals match exactly what prefixes of tokens match") {
    const std::vector<std::string> names = {"a",    "a.a",  "a.b",   "a.b.a", "a-b", "a-b.a",
                                            "aa",   "aa.b", "a.aa",  "b",     "b.a", "b.a.a.a",
                                            "a b.", "A",    "a\xC3", "a!"};
    Program program;
    program.events = table_of(names);
    for (const EventName& descriptor : program.events) {
        for (const EventName& event : program.events) {
            const auto d = EventNames::find(program.events, descriptor.text);
            const auto e = EventNames::find(program.events, event.text);
            CAPTURE(descriptor.text);
            CAPTURE(event.text);
            CHECK(program.matches(d, e) == is_prefix(descriptor.text, event.text));
        }
    }
}

}  // namespace trellis
