// Name resolution of scopes.h.
// SPDX-License-Identifier: MIT
#include "load/scopes.h"

#include <algorithm>
#include <utility>

namespace trellis {

ScopeId Scopes::add(RowId n, ScopeId parent) {
    scopes_.push_back({.row = n, .parent = parent, .remaps = {}, .slots = {}, .subtrees = {}});
    return {static_cast<std::uint32_t>(scopes_.size() - 1)};
}

void Scopes::remap(ScopeId scope, std::string_view name, std::string_view key) {
    scopes_[scope.index].remaps.emplace(name, key);
}

std::pair<ScopeId, std::string_view> Scopes::resolve(ScopeId scope, std::string_view name) const {
    for (;;) {
        const Scope& here = scopes_[scope.index];
        if (name.starts_with('@')) {
            name.remove_prefix(1);
            while (scopes_[scope.index].parent) {
                scope = scopes_[scope.index].parent;
            }
            return {scope, name};
        }
        if (!here.parent || here.slots.contains(std::string(name))) { return {scope, name}; }
        const auto remap = here.remaps.find(std::string(name));
        if (remap != here.remaps.end()) {
            name = remap->second;
        } else if (!here.autoremap || name.starts_with('_')) {
            return {scope, name};
        }
        scope = here.parent;
    }
}

SlotId Scopes::variable(ScopeId scope, std::string_view name) {
    const auto [owner, there] = resolve(scope, name);
    return local(owner, there);
}

SlotId Scopes::find(ScopeId scope, std::string_view name) const {
    const auto [owner, there] = resolve(scope, name);
    const Scope& found = scopes_[owner.index];
    const auto slot = found.slots.find(std::string(there));
    return slot == found.slots.end() ? SlotId() : slot->second;
}

SlotId Scopes::own(ScopeId scope, std::string_view name) {
    return resolve(scope, name).first == scope ? variable(scope, name) : SlotId();
}

SlotId Scopes::local(ScopeId scope, std::string_view name) {
    Scope& here = scopes_[scope.index];
    const auto [slot, fresh] = here.slots.try_emplace(std::string(name));
    if (fresh) {
        slot->second = builder_.add_slot(name, here.row);
        written_.push_back(false);
        port_types_.push_back(PortType::any);
    }
    return slot->second;
}

bool Scopes::bind_type(SlotId slot, PortType type) {
    PortType& before = port_types_[slot.index];
    if (type == PortType::any || before == type) { return true; }
    if (before != PortType::any && before != PortType::text) { return false; }
    before = type;
    return true;
}

bool Scopes::take_name(ScopeId scope, std::string_view name) {
    return scopes_[scope.index].subtrees.emplace(name).second;
}

void Scopes::written(SlotId slot) {
    written_[slot.index] = true;
}

void Scopes::needed(SlotId slot, Where where) {
    needs_.push_back({slot, where});
}

void Scopes::check_needed() {
    for (const Scope& scope : scopes_) {
        if (!scope.all_written) { continue; }
        for (const auto& [name, slot] : scope.slots) {
            written(slot);
        }
    }
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < written_.size(); ++i) {
        if (written_[i]) { known.push_back(builder_.program.slots[i].name); }
    }
    for (const Need& need : needs_) {
        if (written_[need.slot.index]) { continue; }
        const std::string& name = builder_.program.slots[need.slot.index].name;
        // one of the same name in another tree is no suggestion
        std::vector<std::string_view> others = known;
        others.erase(std::remove(others.begin(), others.end(), name), others.end());
        builder_.diagnostics().error("never-set", need.where,
                                     "nothing gives the variable \"" + name + "\" a value" +
                                         suggestion(name, others));
    }
}

}  // namespace trellis
