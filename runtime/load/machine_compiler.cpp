// The names that a machine uses, and its rows.
// SPDX-License-Identifier: MIT
#include "load/machine_compiler.h"

#include "load/check.h"
#include "load/compile.h"
#include "load/forms.h"
#include "load/machine_checks.h"
#include "load/words.h"

#include <algorithm>
#include <utility>

namespace trellis {

MachineCompiler::MachineCompiler(Builder& builder, const ReadFile& file, ElementId root,
                                 InvokedMachines& machines)
    : builder_(builder), file_(file), root_(root), machines_(machines) {}

void MachineCompiler::machine() {
    late_ = document().value(root_, "binding") == "late";
    names_.add("error.execution");
    names_.add("error.communication");
    collect_events();
    Program& program = builder_.program;
    program.events = names_.table();
    program.tick_event = event("tick");
    program.error_event = event("error.execution");
    program.communication_event = event("error.communication");

    state_row(root_, {});
    if (builder_.is_full()) { return; }
    collect_variables();
    elements_.resize(program.rows.size());
    program.states.resize(state_count_);
    for (std::uint32_t i = 0; i < elements_.size(); ++i) {
        if (elements_[i] && is_state(RowId{i})) { fill_state({i}); }
        if (elements_[i] && program.rows[i].op == Op::history) { fill_history({i}); }
    }
    for (std::uint32_t i = 0; i < elements_.size(); ++i) {
        if (elements_[i] && program.rows[i].op == Op::invoke) { fill_invoke({i}); }
    }
    for (InvokedTree& tree : trees_) {
        tree.compiler.finish();
    }
    find_dependence_on_time();
    if (computes_source_) { find_sources(); }
    if (builder_.diagnostics().ok()) { find_doubts(); }
    // of parallel states several are active at once; `_event` is written in every cycle
    if (program.has_parallel || program.event_slot) { return; }
    for (std::uint32_t i = 0; i < elements_.size(); ++i) {
        if (elements_[i] && is_state(RowId{i})) { find_quiet({i}); }
    }
}

// What the machine puts into its own queues can be told from the text, unless it computes names or
// others get its events too.
void MachineCompiler::find_doubts() {
    std::vector<ElementId> raises;
    bool computed = false;
    bool forwards = false;
    for_each_element([&](ElementId e) {
        const std::string_view name = document().name(e);
        const auto has = [&](std::string_view what) { return document().find(e, what) != nullptr; };
        computed |= has("eventexpr");
        forwards |= has("autoforward");
        const bool elsewhere = has("target") || has("targetexpr") || has("type") || has("typeexpr");
        if (name == "raise" || (name == "send" && !elsewhere)) { raises.push_back(e); }
    });
    transitions_.resize(builder_.program.transitions.size());
    check_machine({.program = builder_.program,
                   .document = document(),
                   .rows = elements_,
                   .transitions = transitions_,
                   .raises = raises,
                   .computes_events = computed,
                   .forwards_events = forwards},
                  builder_.diagnostics());
}

bool MachineCompiler::is_state(ElementId e) const {
    const std::string_view name = document().name(e);
    return name == "state" || name == "parallel" || name == "final";
}

bool MachineCompiler::is_atomic(RowId n) const {
    for (const RowId c : children(builder_.program, n)) {
        if (is_state(c)) { return false; }
    }
    return true;
}

// Names -------------------------------------------------------------------------------------------

void MachineCompiler::collect_events() {
    for_each_element([this](ElementId e) {
        const std::string_view name = document().name(e);
        if (name == "transition" || name == "raise" || name == "send") {
            for (const std::string_view word : words(document().value(e, "event"))) {
                names_.add(word);
            }
        }
        if (name != "state" && name != "parallel") { return; }
        if (const Attribute* id = document().find(e, "id"); id != nullptr) {
            names_.add("done.state." + std::string(document().string(id->value)));
        }
        std::uint32_t number = 0;
        for (const ElementId c : document().children(e)) {
            if (document().name(c) != "invoke") { continue; }
            const std::string id = "done.invoke." + invoke_id(e, c, ++number);
            names_.add(id);
            names_.add(id + ".success");
            names_.add(id + ".failure");
        }
    });
}

// An id of our own has the form that SCXML 6.4.1 asks for: "stateid.platformid".
std::string MachineCompiler::invoke_id(ElementId state, ElementId invoke,
                                       std::uint32_t number) const {
    const Attribute* id = document().find(invoke, "id");
    if (id != nullptr) { return std::string(document().string(id->value)); }
    return std::string(document().value(state, "id")) + '.' + std::to_string(number);
}

void MachineCompiler::collect_variables() {
    for_each_element([this](ElementId e) {
        const Attribute* id = document().name(e) == "data" ? document().find(e, "id") : nullptr;
        if (id == nullptr) { return; }
        const std::string name(document().string(id->value));
        const auto [at, fresh] = scope_.variables.try_emplace(name);
        if (!fresh) {
            builder_.diagnostics().error("duplicate-id", id->value_where,
                                         "there is already a variable \"" + name + "\"");
            return;
        }
        at->second = builder_.add_slot(name, {0});
        // only the machine's own can be given values when it is invoked (SCXML 6.4.4)
        const ElementId around = document().at(document().at(e).parent).parent;
        if (around == root_) { builder_.program.parameters.push_back(at->second); }
    });
}

// Rows --------------------------------------------------------------------------------------------

// A state's activities come before its histories, and those before its states: all three are
// intervals then.
void MachineCompiler::state_row(ElementId e, RowId parent) {
    const std::string_view element = document().name(e);
    const Attribute* id = document().find(e, parent ? "id" : "name");
    const std::string name =
        id != nullptr ? std::string(document().string(id->value))
        : !parent     ? std::string("machine")
                      : std::string(element) + '#' + std::to_string(builder_.program.rows.size());
    const Op op = !parent                 ? Op::machine
                  : element == "final"    ? Op::final
                  : element == "parallel" ? Op::parallel_state
                                          : Op::state;
    const RowId n = builder_.open(op, parent, name, document().at(e).where, state_count_++);
    if (!n) { return; }
    builder_.program.has_parallel |= op == Op::parallel_state;
    elements_.resize(n.index + 1);
    elements_[n.index] = e;
    if (parent) { name_state(e, n); }
    std::uint32_t number = 0;
    for (const ElementId c : document().children(e)) {
        if (document().name(c) == "invoke") { invoke_row(c, n, invoke_id(e, c, ++number)); }
    }
    for (const ElementId c : document().children(e)) {
        if (document().name(c) == "history") { history_row(c, n); }
    }
    for (const ElementId c : document().children(e)) {
        if (is_state(c)) { state_row(c, n); }
    }
    builder_.close(n);
}

void MachineCompiler::name_state(ElementId e, RowId n) {
    const Attribute* id = document().find(e, "id");
    if (id == nullptr || scope_.states.emplace(document().string(id->value), n).second) { return; }
    builder_.diagnostics().error("duplicate-id", id->value_where,
                                 "there is already a state \"" +
                                     std::string(document().string(id->value)) + "\"");
}

void MachineCompiler::history_row(ElementId e, RowId state) {
    Program& program = builder_.program;
    const Attribute* id = document().find(e, "id");
    const std::string name = id != nullptr ? std::string(document().string(id->value))
                                           : "history#" + std::to_string(program.rows.size());
    const RowId n = builder_.open(Op::history, state, name, document().at(e).where,
                                  static_cast<std::uint32_t>(program.histories.size()));
    if (!n) { return; }
    program.histories.push_back({.deep = document().value(e, "type") == "deep"});
    elements_.resize(n.index + 1);
    elements_[n.index] = e;
    name_state(e, n);
    builder_.close(n);
}

CodeId MachineCompiler::expression(const Attribute& attribute, RowId state, SyntaxMode mode) {
    const Builder::Text text = Builder::text_of(file_, attribute);
    MachineNames names(builder_, scope_, state, text);
    return builder_.expression(text, Dialect::machine, mode, names);
}

CodeId MachineCompiler::expression(ElementId e, std::string_view name, RowId state) {
    const Attribute* const attribute = document().find(e, name);
    return attribute != nullptr ? expression(*attribute, state) : CodeId();
}

void compile_machine(ReadFile file, Builder& builder) {
    InvokedMachines machines(builder);
    MachineCompiler(builder, file, file.document.root(), machines).machine();
    machines.compile();
}

}  // namespace trellis
