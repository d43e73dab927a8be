// Name resolution of scopes.h.
// SPDX-License-Identifier: MIT
#include "load/scopes.h"

#include "load/tree_statuses.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace trellis {

namespace {

/// Whether `n` is one of the rows, which are sorted and do not overlap.
bool is_among(const std::vector<NeverTicked>& all, RowId n) {
    const auto after =
        std::upper_bound(all.begin(), all.end(), n,
                         [](RowId row, const NeverTicked& rows) { return row < rows.first; });
    return after != all.begin() && n < std::prev(after)->end;
}

}  // namespace

ScopeId Scopes::add(RowId n, ScopeId parent) {
    scopes_.push_back({.row = n, .parent = parent, .remaps = {}, .slots = {}, .subtrees = {}});
    return {static_cast<std::uint32_t>(scopes_.size() - 1)};
}

void Scopes::remap(ScopeId scope, std::string_view name, std::string_view key) {
    scopes_[scope.index].remaps.emplace(name, Remap{std::string(key)});
    find(scopes_[scope.index].parent, key);
}

std::pair<ScopeId, std::string_view> Scopes::resolve(ScopeId scope, std::string_view name) {
    for (;;) {
        Scope& here = scopes_[scope.index];
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
            remap->second.used = true;
            name = remap->second.key;
        } else if (!here.autoremap || name.starts_with('_')) {
            return {scope, name};
        }
        scope = here.parent;
    }
}

SlotId Scopes::used(SlotId slot) {
    variables_[slot.index].is_used = true;
    return slot;
}

SlotId Scopes::variable(ScopeId scope, std::string_view name) {
    const auto [owner, there] = resolve(scope, name);
    return used(local(owner, there));
}

SlotId Scopes::find(ScopeId scope, std::string_view name) {
    const auto [owner, there] = resolve(scope, name);
    const Scope& found = scopes_[owner.index];
    const auto slot = found.slots.find(std::string(there));
    return slot == found.slots.end() ? SlotId() : used(slot->second);
}

SlotId Scopes::own(ScopeId scope, std::string_view name) {
    return resolve(scope, name).first == scope ? variable(scope, name) : SlotId();
}

SlotId Scopes::local(ScopeId scope, std::string_view name) {
    Scope& here = scopes_[scope.index];
    const auto [slot, fresh] = here.slots.try_emplace(std::string(name));
    if (fresh) {
        slot->second = builder_.add_slot(name, here.row);
        // a machine has variables, and other trees, in the same table
        variables_.resize(slot->second.index + 1);
        variables_.back().is_known = true;
    }
    return slot->second;
}

bool Scopes::is_used(ScopeId scope, std::string_view name) const {
    const Scope& here = scopes_[scope.index];
    if (here.all_used) { return true; }
    const auto slot = here.slots.find(std::string(name));
    if (slot != here.slots.end()) { return variables_[slot->second.index].is_used; }
    const auto remap = here.remaps.find(std::string(name));
    return remap != here.remaps.end() && remap->second.used;
}

std::vector<std::string_view> Scopes::names(ScopeId scope) const {
    std::vector<std::string_view> names;
    for (const auto& [name, slot] : scopes_[scope.index].slots) {
        names.emplace_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

bool Scopes::take_name(ScopeId scope, std::string_view name) {
    return scopes_[scope.index].subtrees.emplace(name).second;
}

void Scopes::written(SlotId slot) {
    variables_[slot.index].is_written = true;
}

void Scopes::needed(SlotId slot, Where where, RowId n) {
    needs_.push_back({slot, where, n});
}

// Needs -------------------------------------------------------------------------------------------

std::vector<std::string_view> Scopes::written_names() const {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < variables_.size(); ++i) {
        if (variables_[i].is_written) { names.push_back(builder_.program.slots[i].name); }
    }
    return names;
}

std::vector<SlotId> Scopes::never_written() const {
    std::vector<SlotId> slots;
    for (std::uint32_t i = 0; i < variables_.size(); ++i) {
        if (variables_[i].is_known && !variables_[i].is_written) { slots.push_back({i}); }
    }
    return slots;
}

void Scopes::check_needed() {
    for (const Scope& scope : scopes_) {
        if (!scope.all_written) { continue; }
        for (const auto& [name, slot] : scope.slots) {
            written(slot);
        }
    }
    const auto is_met = [&](const Need& need) { return variables_[need.slot.index].is_written; };
    needs_.erase(std::remove_if(needs_.begin(), needs_.end(), is_met), needs_.end());
    if (needs_.empty()) { return; }
    // more are not shown
    needs_.resize(std::min(needs_.size(), Diagnostics::most + 1));

    std::vector<NeverTicked> idle;
    // what an error has left is no whole program
    if (builder_.diagnostics().ok()) {
        idle = find_statuses(builder_.program, never_written()).never_ticked;
    }
    const std::vector<std::string_view> known = written_names();
    for (const Need& need : needs_) {
        const std::string& name = builder_.program.slots[need.slot.index].name;
        // one of the same name in another tree is no suggestion
        std::vector<std::string_view> others = known;
        others.erase(std::remove(others.begin(), others.end(), name), others.end());
        const std::string message =
            "nothing gives the variable \"" + name + "\" a value" + suggestion(name, others);
        if (is_among(idle, need.row)) {
            builder_.diagnostics().warning("never-set", need.where, message);
        } else {
            builder_.diagnostics().error("never-set", need.where, message);
        }
    }
}

}  // namespace trellis
