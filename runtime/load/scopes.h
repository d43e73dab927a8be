// Which variable a name means inside a tree: one blackboard per tree and subtree, with the sharing
// that remaps, _autoremap and @ describe (TREES §2.2, §2.3). Decided while compiling, so that a
// tick compares numbers. Private to runtime/load. Covered by tests/load/compile_tree_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/builder.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace trellis {

using ScopeId = Id<struct ScopeTag>;

/// The blackboards of one program.
class Scopes {
public:
    explicit Scopes(Builder& builder) : builder_(builder) {}

    /// The blackboard of tree or subtree row `n`; `parent` is none for a whole tree.
    ScopeId add(RowId n, ScopeId parent);
    RowId row(ScopeId scope) const { return scopes_[scope.index].row; }
    ScopeId parent(ScopeId scope) const { return scopes_[scope.index].parent; }

    /// Makes `name` mean what `key` means in the parent.
    void remap(ScopeId scope, std::string_view name, std::string_view key);
    /// Makes every name that is not remapped, and does not begin with _, mean the same in the
    /// parent.
    void autoremap(ScopeId scope) { scopes_[scope.index].autoremap = true; }

    /// The variable that `name` means, made if there is none yet: in this scope, or where remaps
    /// lead to; a leading @ means the outermost one.
    SlotId variable(ScopeId scope, std::string_view name);
    /// The same, but none if that is a variable of another scope.
    SlotId own(ScopeId scope, std::string_view name);
    /// The variable that `name` means, or none.
    SlotId find(ScopeId scope, std::string_view name) const;
    /// A variable of this very scope, whatever the remaps say.
    SlotId local(ScopeId scope, std::string_view name);

    /// A port of type `type` is bound to the variable; false if one of another type is already. A
    /// text before it is no clash, as it is converted (TREES §2.1).
    bool bind_type(SlotId slot, PortType type);
    /// Takes a name for a subtree of this scope; false if one there has it.
    bool take_name(ScopeId scope, std::string_view name);

    /// Something in the file, or the host, may give the variable a value.
    void written(SlotId slot);
    /// So may every variable of the scope, because a key is itself in a variable.
    void all_written(ScopeId scope) { scopes_[scope.index].all_written = true; }
    /// The file needs the value: an error, once compiled, if nothing may have written it.
    void needed(SlotId slot, Where where);
    void check_needed();

private:
    struct Scope {
        RowId row;
        ScopeId parent;
        bool autoremap = false;
        bool all_written = false;
        std::unordered_map<std::string, std::string> remaps;
        std::unordered_map<std::string, SlotId> slots;
        std::unordered_set<std::string> subtrees;
    };
    struct Need {
        SlotId slot;
        Where where;
    };
    /// The scope and the name there that `name` leads to.
    std::pair<ScopeId, std::string_view> resolve(ScopeId scope, std::string_view name) const;

    Builder& builder_;
    std::vector<Scope> scopes_;
    std::vector<bool> written_;         // by slot
    std::vector<PortType> port_types_;  // by slot; any: no typed port yet
    std::vector<Need> needs_;
};

}  // namespace trellis
