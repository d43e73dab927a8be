// Compiles trees: nodes to rows, attributes to ports, names to variables (TREES §2). The built-in
// nodes and their ports are in tree_nodes.cpp, machines in tree_machines.cpp, replaced nodes in
// tree_tests.cpp. Private to
// runtime/load; the entrance is compile.h. Covered by tests/load/compile_tree_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "load/builder.h"
#include "load/invoked_machines.h"
#include "load/scopes.h"
#include "load/tree_files.h"
#include "load/variable_types.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace trellis {

struct SubstitutionRule;
struct TestConfig;

class TreeCompiler {
public:
    TreeCompiler(Builder& builder, TreeFiles& files, InvokedMachines& machines);

    /// Compiles `tree` as a whole tree below row `parent` (none: as row 0).
    RowId tree(const TreeSource& tree, RowId parent);
    /// To be called after the last tree: finds variables that nothing writes, that are taken for
    /// values of different types, and parameters that nothing uses.
    void finish();
    /// Trees that were not reached are compiled too, for their faults, and thrown away.
    void check_unreached();
    /// Warns of the trees of the main file to which nothing leads from `main`.
    void report_unused_trees(const TreeSource& main);
    Scopes& scopes() { return scopes_; }
    ScopeId main_scope() const { return {0}; }

private:
    struct Place {  // where a node stands
        const ReadFile* file;
        ElementId element;
        ScopeId scope;
        RowId parent;
    };

    void node(const Place& place);
    void built_in(const Place& place, const OpInfo& op);
    void leaf(const Place& place, const LeafType& type);
    void subtree(const Place& place);
    void parameters(const Place& place, ScopeId inside, const std::vector<SubtreePort>* model);
    void parameter(ScopeId inside, std::string_view name, std::string_view value, Where where);
    void local(ScopeId inside, std::string_view name, Value value, Where where);
    void find_unused(const Place& place, ScopeId inside, const std::vector<SubtreePort>* model);
    void finish_checks();
    bool is_recursive(std::string_view id, Where where);
    void children_of(const Place& place, RowId n);

    // built-in nodes: tree_nodes.cpp
    std::uint32_t node_arg(const Place& place, Op op);
    std::uint32_t ports(const Place& place, Op op);
    CodeId port_code(const Place& place, Op op, std::string_view name, std::string_view type,
                     const Attribute& attribute);
    SlotId named_entry(const Place& place, Op op);
    CodeId queue(const Attribute& attribute, std::string_view text, Op op);
    void check_threshold(const Place& place, std::string_view port, std::size_t children);
    void keep_skips(RowId question);
    /// An entry that a port of that type is bound to has this type from the beginning.
    void declare(SlotId slot, PortType type, Where where);
    /// The script of row `n`; none: it may run although the row is never ticked.
    CodeId compiled(const Place& place, const Builder::Text& script, RowId n);
    /// The row that is opened next.
    RowId next_row() const { return {static_cast<std::uint32_t>(builder_.program.rows.size())}; }

    // machines as nodes: tree_machines.cpp
    std::uint32_t machine(const Place& place);
    MachineParam machine_param(const Place& place, MachineId machine, const Attribute& attribute);

    // substitution rules: tree_tests.cpp
    std::string path_of(const Place& place, std::string_view type) const;
    SubstitutionRule* rule_for(const Place& place);
    void replace(const Place& place, const SubstitutionRule& rule);
    bool is_replaceable(const Place& place, const SubstitutionRule& rule);
    void test(const Place& place, const TestConfig& config);

    void leaf_port(const Place& place, const Port& port, const Attribute& attribute);
    void conditions(const Place& place, RowId n);

    const Document& document(const Place& place) const { return place.file->document; }
    static Builder::Text text_of(const Place& place, const Attribute& attribute) {
        return Builder::text_of(*place.file, attribute);
    }
    std::string_view kind(const Place& place) const;
    std::string_view instance_name(const Place& place) const;

    Builder& builder_;
    TreeFiles& files_;
    InvokedMachines& machines_;
    Scopes scopes_;
    VariableTypes types_;
    std::unordered_map<std::string_view, Op> built_ins_;
    std::unordered_map<std::string_view, const LeafType*> leaves_;
    std::vector<std::string> paths_;           // by scope: before the nodes in it; for rules only
    std::vector<std::string_view> expanding_;  // IDs of the subtrees being compiled
    std::unordered_set<std::string_view> reached_;
    struct Unused {
        Where where;
        std::string message;
    };
    std::vector<Unused> unused_;  // parameters of subtrees
    std::unordered_set<const Attribute*> known_unused_;
};

}  // namespace trellis
