// Look-ups of machine_names.h. A name that nothing declares is a warning, because SCXML lets it
// fail at run time, as an event that a machine may answer (SCXML 5.9, MACHINES).
// SPDX-License-Identifier: MIT
#include "load/machine_names.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace trellis {

namespace {

template <class Table>
std::vector<std::string_view> names_in(const Table& table) {
    std::vector<std::string_view> names;
    for (const auto& entry : table) {
        names.emplace_back(entry.first);
    }
    std::sort(names.begin(), names.end());  // messages do not depend on hashing
    return names;
}

/// The one processor there is, under both its names (SCXML 5.10, C.1).
Value event_processors() {
    Value location = Value::object();
    location.set_member("location", Value::text("#_scxml_s1"));
    Value processors = Value::object();
    processors.set_member("scxml", location);
    processors.set_member("http://www.w3.org/TR/scxml/#SCXMLEventProcessor", location);
    return processors;
}

}  // namespace

Meaning MachineNames::variable(std::string_view name, Use use) {
    const auto found = scope_.variables.find(std::string(name));
    if (found != scope_.variables.end()) {
        return {
            .kind = Meaning::Kind::slot, .index = found->second.index, .value = {}, .message = {}};
    }
    static constexpr std::string_view system[] = {"_event", "_ioprocessors", "_name", "_sessionid"};
    const auto* known = std::find(std::begin(system), std::end(system), name);
    if (known != std::end(system)) { return system_variable(*known); }
    if (may_create_ && use != Use::read) {
        const SlotId slot = builder_.add_slot(name, {0});
        scope_.variables.emplace(name, slot);
        return {.kind = Meaning::Kind::slot, .index = slot.index, .value = {}, .message = {}};
    }
    if (name == "pi") { return {}; }
    builder_.diagnostics().warning("unknown-name", builder_.place_of(text_, name),
                                   "no <data> declares \"" + std::string(name) + "\"" +
                                       suggestion(name, names_in(scope_.variables)));
    return {};
}

// System variables are made when they are first used, and cannot be assigned to (SCXML 5.10).
Meaning MachineNames::system_variable(std::string_view name) {
    const auto [at, fresh] = scope_.system.try_emplace(name);
    if (fresh) {
        at->second = builder_.add_slot(name, {0});
        Slot& variable = builder_.program.slots[at->second.index];
        if (name == "_event") { builder_.program.event_slot = at->second; }
        if (name == "_name") { variable.initial = Value::text(builder_.program.name({0})); }
        // those of the outermost session; an invoked one gets its own when it begins
        if (name == "_sessionid") {
            variable.initial = Value::text("s1");
            builder_.program.session_slot = at->second;
        }
        if (name == "_ioprocessors") {
            variable.initial = event_processors();
            builder_.program.processors_slot = at->second;
        }
    }
    return {.kind = Meaning::Kind::read_only_slot,
            .index = at->second.index,
            .value = {},
            .message = {}};
}

Meaning MachineNames::elapsed() {
    return {
        .kind = Meaning::Kind::elapsed_since, .index = state_.index, .value = {}, .message = {}};
}

Meaning MachineNames::state(std::string_view name) {
    const auto found = scope_.states.find(name);
    if (found != scope_.states.end()) {
        return {
            .kind = Meaning::Kind::state, .index = found->second.index, .value = {}, .message = {}};
    }
    builder_.diagnostics().warning("unknown-name", builder_.place_of(text_, name),
                                   "there is no state \"" + std::string(name) + "\"" +
                                       suggestion(name, names_in(scope_.states)));
    return {};
}

}  // namespace trellis
