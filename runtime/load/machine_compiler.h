// Compiles machines: states to rows, transitions, executable content and activities (MACHINES).
// Private to runtime/load; the entrance is compile.h. Covered by
// tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "load/builder.h"
#include "load/event_names.h"
#include "load/machine_names.h"
#include "load/tree_compiler.h"

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

class MachineCompiler {
public:
    MachineCompiler(Builder& builder, ReadFile file);

    /// Compiles the whole file. The stages read the document one after the other, because later
    /// ones need all of what earlier ones collect.
    void machine();

private:
    // names
    void collect_events(ElementId root);
    void collect_variables(ElementId root);
    // rows
    void state_row(ElementId e, RowId parent);
    void invoke_row(ElementId e, RowId state, const std::string& id);
    void tree_row(const Attribute& source, RowId invoke);
    // what states have
    void fill_state(RowId n);
    void find_quiet_guards(RowId n);
    void transition(ElementId e, RowId source);
    bool add_targets(const Attribute& attribute, RowId inside, Transition& transition);
    TransitionId initial_of(RowId n);
    RowId domain_of(const Transition& transition) const;
    void check_finality(RowId n);
    // activities
    void fill_invoke(RowId n);
    void fill_leaf(ElementId e, RowId invoke);
    void leaf_param(ElementId param, RowId state, const LeafType& type);
    void tree_params(ElementId e, RowId invoke, Scopes& scopes);
    CodeId param_code(ElementId param, RowId state);
    // executable content: machine_content.cpp
    BlockId block(ElementId parent, RowId state);
    void content(ElementId parent, RowId state);
    void action(ElementId e, RowId state);
    void branches(ElementId e, RowId state);
    std::vector<BlockId> blocks(ElementId of, std::string_view name, RowId state);
    std::vector<BlockId> data_blocks(ElementId of, RowId state);
    void add_data(ElementId data, RowId state, std::vector<BlockId>& found);
    CodeId text_value(ElementId e, RowId state);
    BlockId next_action() const;
    Action& add_action(Action::Kind kind);

    CodeId expression(const Attribute& attribute, RowId state,
                      SyntaxMode mode = SyntaxMode::single_expression);
    EventId event(std::string_view name) const {
        return EventNames::find(builder_.program.events, name);
    }
    const Document& document() const { return file_.document; }
    bool is_state(ElementId e) const;
    std::string invoke_id(ElementId state, ElementId invoke, std::uint32_t number) const;
    std::uint32_t add_blocks(const std::vector<BlockId>& list);

    /// A tree below an invoke row; kept until its parameters are known.
    struct InvokedTree {
        RowId invoke;
        TreeFiles files;
        TreeCompiler compiler;
        explicit InvokedTree(Builder& builder, RowId n)
            : invoke(n), files(builder), compiler(builder, files) {}
    };

    Builder& builder_;
    ReadFile file_;
    EventNames names_;
    MachineScope scope_;
    std::vector<ElementId> elements_;  // by row: where it comes from; none below invoke rows
    std::deque<InvokedTree> trees_;
    std::uint32_t state_count_ = 0;
    bool late_ = false;  // binding="late"
};

}  // namespace trellis
