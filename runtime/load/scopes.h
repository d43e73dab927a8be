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

    /// Makes `name` mean what `key` means in the parent, which is a use of `key` there.
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
    SlotId find(ScopeId scope, std::string_view name);
    /// A variable of this very scope, whatever the remaps say. To make it is no use of it.
    SlotId local(ScopeId scope, std::string_view name);
    /// Whether anything inside the scope means its remap or variable `name`: false only once the
    /// whole scope is compiled, and if no name in it is itself in a variable.
    bool is_used(ScopeId scope, std::string_view name) const;
    /// The names of the variables of this very scope, sorted.
    std::vector<std::string_view> names(ScopeId scope) const;

    /// Takes a name for a subtree of this scope; false if one there has it.
    bool take_name(ScopeId scope, std::string_view name);

    /// Something in the file, or the host, may give the variable a value.
    void written(SlotId slot);
    /// So may every variable of the scope, because a key is itself in a variable.
    void all_written(ScopeId scope) {
        scopes_[scope.index].all_written = true;
        all_used(scope);
    }
    /// A node may mean any name of the scope, because a key is itself in a variable.
    void all_used(ScopeId scope) { scopes_[scope.index].all_used = true; }
    /// Row `n` needs the value; none: what is no row's turn, as a script of _onHalted.
    void needed(SlotId slot, Where where, RowId n);

    /// To be called once all is compiled. An error for each value that is needed and that nothing
    /// may have written; a warning if the row that needs it is never ticked.
    void check_needed();
    /// Of the variables so far, those to which nothing gives a value; after check_needed().
    std::vector<SlotId> never_written() const;

private:
    struct Remap {
        std::string key;
        bool used = false;
    };
    struct Variable {
        bool is_known = false;  ///< it is one of these scopes
        bool is_written = false;
        bool is_used = false;
    };
    struct Scope {
        RowId row;
        ScopeId parent;
        bool autoremap = false;
        bool all_written = false;
        bool all_used = false;
        std::unordered_map<std::string, Remap> remaps;
        std::unordered_map<std::string, SlotId> slots;
        std::unordered_set<std::string> subtrees;
    };
    struct Need {
        SlotId slot;
        Where where;
        RowId row;
    };
    /// The scope and the name there that `name` leads to; the remaps on the way are used.
    std::pair<ScopeId, std::string_view> resolve(ScopeId scope, std::string_view name);
    SlotId used(SlotId slot);
    std::vector<std::string_view> written_names() const;

    Builder& builder_;
    std::vector<Scope> scopes_;
    std::vector<Variable> variables_;  // by slot, also of those that are none of these scopes
    std::vector<Need> needs_;
};

}  // namespace trellis
