// Compiles machines: states to rows, transitions, executable content, messages and activities
// (MACHINES). The stages are in machine_compiler.cpp (names, rows), machine_states.cpp,
// machine_content.cpp, machine_messages.cpp and machine_activities.cpp. Private to runtime/load;
// the entrance is compile.h. Covered by tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "load/builder.h"
#include "load/event_names.h"
#include "load/invoked_machines.h"
#include "load/machine_names.h"
#include "load/tree_compiler.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

class MachineCompiler {
public:
    /// For the machine that the element `root` of `file` spells; `machines` collects those that it
    /// invokes.
    MachineCompiler(Builder& builder, const ReadFile& file, ElementId root,
                    InvokedMachines& machines);

    /// Compiles it all. The stages read the document one after the other, because later ones need
    /// all of what earlier ones collect.
    void machine();

private:
    // names
    void collect_events();
    void collect_variables();
    /// Calls `visit` for the elements of this machine, without those of machines inside it.
    template <class Visit>
    void for_each_element(Visit visit) const {
        for (ElementId e = root_; e != document().at(root_).end;) {
            if (e != root_ && document().name(e) == "scxml") {
                e = document().at(e).end;
            } else {
                visit(e);
                ++e.index;
            }
        }
    }
    // rows
    void state_row(ElementId e, RowId parent);
    void check_invoke_type(ElementId e);
    void invoke_row(ElementId e, RowId state, const std::string& id);
    void tree_row(const Attribute& source, RowId invoke);
    void history_row(ElementId e, RowId state);
    void name_state(ElementId e, RowId n);
    // what states have: machine_states.cpp
    void fill_state(RowId n);
    void find_quiet(RowId n);
    RowId quiet_activity(RowId n) const;
    std::optional<std::vector<Condition>> guards_of_tick(RowId n) const;
    void transition(ElementId e, RowId source);
    bool add_targets(const Attribute& attribute, RowId inside, Transition& transition);
    void check_targets(const Attribute& attribute, const Transition& transition);
    bool can_be_active_together(RowId a, RowId b) const;
    TransitionId initial_of(RowId n);
    void fill_history(RowId n);
    RowId domain_of(const Transition& transition) const;
    void find_dependence_on_time();
    void find_doubts();
    // activities: machine_activities.cpp
    void fill_invoke(RowId n);
    void fill_leaf(ElementId e, RowId invoke);
    void leaf_param(ElementId param, RowId state, const LeafType& type);
    void tree_params(ElementId e, RowId invoke, Scopes& scopes);
    void fill_machine(ElementId e, RowId invoke);
    BlockId finalize(ElementId invoke, ElementId e, RowId state);
    void find_sources();
    CodeId param_code(ElementId param, RowId state);
    // executable content: machine_content.cpp
    BlockId block(ElementId parent, RowId state);
    void content(ElementId parent, RowId state);
    void action(ElementId e, RowId state);
    void branches(ElementId e, RowId state);
    void loop(ElementId e, RowId state);
    void script(ElementId e, RowId state);
    void assign(ElementId e, RowId state);
    std::uint32_t label(std::string text);
    SlotId loop_variable(const Attribute& attribute);
    std::vector<BlockId> blocks(ElementId of, std::string_view name, RowId state);
    std::vector<BlockId> data_blocks(ElementId of, RowId state);
    void add_data(ElementId data, RowId state, std::vector<BlockId>& found);
    CodeId text_value(ElementId e, RowId state);
    CodeId text_value(const Builder::Text& text, RowId state);
    std::optional<Builder::Text> named_file(const Attribute& src);
    BlockId next_action() const;
    Action& add_action(Action::Kind kind);
    // messages: machine_messages.cpp
    void send(ElementId e, RowId state);
    void cancel(ElementId e, RowId state);
    PayloadId payload(ElementId e, RowId state);
    LiveText live_text(ElementId e, const std::string& name, RowId state);
    Place place(const Attribute& location, RowId state);

    CodeId expression(const Attribute& attribute, RowId state,
                      SyntaxMode mode = SyntaxMode::single_expression);
    /// The same for the attribute of that name; none if `e` does not have it.
    CodeId expression(ElementId e, std::string_view name, RowId state);
    EventId event(std::string_view name) const {
        return EventNames::find(builder_.program.events, name);
    }
    const Document& document() const { return file_.document; }
    bool is_state(ElementId e) const;
    bool is_state(RowId n) const {
        return op_table()[builder_.program.at(n).op].group == OpGroup::state;
    }
    bool is_compound(RowId n) const {
        const Op op = builder_.program.at(n).op;
        return op == Op::machine || (op == Op::state && !is_atomic(n));
    }
    bool is_atomic(RowId n) const;
    std::string invoke_id(ElementId state, ElementId invoke, std::uint32_t number) const;
    std::uint32_t add_blocks(const std::vector<BlockId>& list);

    /// A tree below an invoke row; kept until its parameters are known.
    struct InvokedTree {
        RowId invoke;
        TreeFiles files;
        TreeCompiler compiler;
        InvokedTree(Builder& builder, RowId n, InvokedMachines& machines)
            : invoke(n), files(builder), compiler(builder, files, machines) {}
    };

    Builder& builder_;
    const ReadFile& file_;
    const ElementId root_;
    InvokedMachines& machines_;
    EventNames names_;
    MachineScope scope_;
    std::vector<ElementId> elements_;     // by row: where it comes from; none below invoke rows
    std::vector<ElementId> transitions_;  // by transition; none for ways of entering
    std::deque<InvokedTree> trees_;
    std::deque<std::string> named_texts_;  // of src attributes of <data> and <script>
    std::uint32_t state_count_ = 0;
    bool late_ = false;             // binding="late"
    bool computes_source_ = false;  // an invoke has a source that is an expression
};

}  // namespace trellis
