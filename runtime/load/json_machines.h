// The JSON of machine files: which members stand for which elements, known to the reader and the
// writer. Included by json_machine_reader.cpp and json_machine_writer.cpp only. Covered by
// tests/load/json_machines_test.cpp.
//
// Element = object, attribute = member of the same name. Each kind of child that may be repeated is
// an array; executable content is an array of one-member objects, {"assign": {…}}; elements that
// have no place of their own are written as XML inside "xml".
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis::json_machines {

constexpr std::string_view scxml_namespace = "http://www.w3.org/2005/07/scxml";

/// Members that are no attributes. An attribute that is called like one of them, and those behind
/// it, are written inside "attributes".
constexpr std::string_view special_members[] = {
    "doc",      "kind",        "data",     "scripts", "onentry",   "onexit", "initialTransition",
    "invoke",   "transitions", "donedata", "states",  "do",        "params", "content",
    "finalize", "text",        "xml",      "scxml",   "attributes"};

constexpr std::string_view state_kinds[] = {"state", "parallel", "final", "history"};

/// Attributes that are lists of names: written as text with blanks, read as an array too.
constexpr std::string_view list_attributes[] = {"event", "target", "initial", "namelist"};

/// Actions that may be written as {"raise": "done"}: the attribute ("" is the text) that it is.
struct Shorthand {
    std::string_view action, attribute;
};
constexpr Shorthand shorthands[] = {
    {"raise", "event"}, {"script", ""}, {"log", "expr"}, {"cancel", "sendid"}};

/// The prefixes that the open elements declare. An attribute p:x is written "{namespace}x".
class Prefixes {
public:
    void declare(std::string_view prefix, std::string_view uri) {
        bindings_.emplace_back(prefix, uri);
    }
    std::size_t size() const { return bindings_.size(); }
    /// Forgets all but the first `size`.
    void resize(std::size_t size) { bindings_.resize(size); }

    /// The namespace of a prefix; empty if no open element declares it.
    std::string_view uri_of(std::string_view prefix) const {
        for (auto b = bindings_.rbegin(); b != bindings_.rend(); ++b) {
            if (b->first == prefix) { return b->second; }
        }
        return {};
    }
    /// The innermost prefix that stands for a namespace; empty if there is none.
    std::string_view prefix_of(std::string_view uri) const {
        for (auto b = bindings_.rbegin(); b != bindings_.rend(); ++b) {
            if (b->second == uri && uri_of(b->first) == uri) { return b->first; }
        }
        return {};
    }

private:
    std::vector<std::pair<std::string, std::string>> bindings_;
};

}  // namespace trellis::json_machines
