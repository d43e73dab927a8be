// States, transitions and activities of machines.
// SPDX-License-Identifier: MIT
#include "load/machine_compiler.h"

#include "load/check.h"
#include "load/compile.h"
#include "load/forms.h"
#include "load/words.h"

#include <algorithm>
#include <utility>

namespace trellis {

MachineCompiler::MachineCompiler(Builder& builder, ReadFile file)
    : builder_(builder), file_(std::move(file)) {}

void MachineCompiler::machine() {
    const ElementId root = document().root();
    late_ = document().value(root, "binding") == "late";
    names_.add("error.execution");
    collect_events(root);
    Program& program = builder_.program;
    program.events = names_.table();
    program.tick_event = event("tick");
    program.error_event = event("error.execution");

    state_row(root, {});
    if (builder_.is_full()) { return; }
    collect_variables(root);
    elements_.resize(program.rows.size());
    program.states.resize(state_count_);
    for (std::uint32_t i = 0; i < elements_.size(); ++i) {
        if (elements_[i] && program.rows[i].op != Op::invoke) { fill_state({i}); }
    }
    for (std::uint32_t i = 0; i < elements_.size(); ++i) {
        if (elements_[i] && program.rows[i].op == Op::invoke) { fill_invoke({i}); }
        if (elements_[i] && program.rows[i].op == Op::state) { find_quiet_guards({i}); }
    }
    for (InvokedTree& tree : trees_) {
        tree.compiler.finish();
    }
}

bool MachineCompiler::is_state(ElementId e) const {
    const std::string_view name = document().name(e);
    return name == "state" || name == "final";
}

// Names -------------------------------------------------------------------------------------------

void MachineCompiler::collect_events(ElementId root) {
    for (ElementId e = root; e != document().at(root).end; ++e.index) {
        const std::string_view name = document().name(e);
        if (name == "transition" || name == "raise") {
            for (const std::string_view word : words(document().value(e, "event"))) {
                names_.add(word);
            }
        } else if (name == "state") {
            if (const Attribute* id = document().find(e, "id"); id != nullptr) {
                names_.add("done.state." + std::string(document().string(id->value)));
            }
            std::uint32_t number = 0;
            for (const ElementId c : document().children(e)) {
                if (document().name(c) != "invoke") { continue; }
                const std::string id = "done.invoke." + invoke_id(e, c, ++number);
                names_.add(id + ".success");
                names_.add(id + ".failure");
            }
        }
    }
}

// An id of our own has the form that SCXML 6.4.1 asks for: "stateid.platformid".
std::string MachineCompiler::invoke_id(ElementId state, ElementId invoke,
                                       std::uint32_t number) const {
    const Attribute* id = document().find(invoke, "id");
    if (id != nullptr) { return std::string(document().string(id->value)); }
    return std::string(document().value(state, "id")) + '.' + std::to_string(number);
}

void MachineCompiler::collect_variables(ElementId root) {
    for (ElementId e = root; e != document().at(root).end; ++e.index) {
        const Attribute* id = document().name(e) == "data" ? document().find(e, "id") : nullptr;
        if (id == nullptr) { continue; }
        const std::string name(document().string(id->value));
        const auto [at, fresh] = scope_.variables.try_emplace(name);
        if (fresh) {
            at->second = builder_.add_slot(name, {0});
        } else {
            builder_.diagnostics().error("duplicate-id", id->value_where,
                                         "there is already a variable \"" + name + "\"");
        }
    }
}

// Rows --------------------------------------------------------------------------------------------

// A state's activities come before its states: both are intervals then.
void MachineCompiler::state_row(ElementId e, RowId parent) {
    const std::string_view element = document().name(e);
    const Attribute* id = document().find(e, parent ? "id" : "name");
    const std::string name =
        id != nullptr ? std::string(document().string(id->value))
        : !parent     ? std::string("machine")
                      : std::string(element) + '#' + std::to_string(builder_.program.rows.size());
    const Op op = !parent ? Op::machine : element == "final" ? Op::final : Op::state;
    const RowId n = builder_.open(op, parent, name, document().at(e).where, state_count_++);
    if (!n) { return; }
    elements_.resize(n.index + 1);
    elements_[n.index] = e;
    if (parent && id != nullptr && !scope_.states.emplace(document().string(id->value), n).second) {
        builder_.diagnostics().error("duplicate-id", id->value_where,
                                     "there is already a state \"" + name + "\"");
    }
    std::uint32_t number = 0;
    for (const ElementId c : document().children(e)) {
        if (document().name(c) == "invoke") { invoke_row(c, n, invoke_id(e, c, ++number)); }
    }
    for (const ElementId c : document().children(e)) {
        if (is_state(c)) { state_row(c, n); }
    }
    builder_.close(n);
}

void MachineCompiler::invoke_row(ElementId e, RowId state, const std::string& id) {
    Program& program = builder_.program;
    const std::string_view src = document().value(e, "src");
    const std::string_view type = document().value(e, "type");
    const LeafType* leaf = type == "leaf" ? builder_.registry().find(src) : nullptr;
    const Attribute* source = document().find(e, "src");
    if (type == "leaf" && leaf == nullptr && source != nullptr) {
        std::vector<std::string_view> known;
        for (const LeafType& other : builder_.registry().leaves()) {
            known.emplace_back(other.name);
        }
        builder_.diagnostics().error("unknown-leaf", source->value_where,
                                     "there is no leaf \"" + std::string(src) + "\"" +
                                         suggestion(src, known));
    }
    const Where where = document().at(e).where;
    const RowId n = builder_.open(Op::invoke, state, id, where,
                                  static_cast<std::uint32_t>(program.invokes.size()));
    if (!n) { return; }
    program.invokes.push_back({.id = id,
                               .done_success = event("done.invoke." + id + ".success"),
                               .done_failure = event("done.invoke." + id + ".failure")});
    elements_.resize(n.index + 1);
    elements_[n.index] = e;
    if (leaf != nullptr) {
        const Op op = leaf->synchronous ? Op::condition : Op::action;
        if (const RowId row = builder_.open(op, n, leaf->name, where); row) { builder_.close(row); }
    } else if (type == "tree" && source != nullptr) {
        tree_row(*source, n);
    }
    builder_.close(n);
}

void MachineCompiler::tree_row(const Attribute& source, RowId invoke) {
    Diagnostics& diagnostics = builder_.diagnostics();
    const std::string_view path = document().string(source.value);
    std::optional<Source> text;
    if (SourceReader* reader = builder_.options().reader; reader != nullptr) {
        text = reader->read(path, file_.name, {});
    }
    if (!text) {
        diagnostics.error("unreadable-file", source.value_where,
                          "cannot read \"" + std::string(path) + "\"");
        return;
    }
    std::optional<Document> tree = read(*text, diagnostics, builder_.options());
    if (!tree) { return; }
    check(*tree, builder_.grammar(), diagnostics);
    InvokedTree& invoked = trees_.emplace_back(builder_, invoke);
    invoked.files.add({std::move(text->name), std::move(*tree)});
    if (const TreeSource* main = invoked.files.main_tree({}); main != nullptr) {
        invoked.compiler.tree(*main, invoke);
    }
}

// What states have --------------------------------------------------------------------------------

void MachineCompiler::fill_state(RowId n) {
    Program& program = builder_.program;
    const ElementId e = elements_[n.index];
    StateInfo state;
    state.first_transition = static_cast<std::uint32_t>(program.transitions.size());
    for (const ElementId c : document().children(e)) {
        // one that stands in the root or a final state has been reported
        if (document().name(c) == "transition" && program.at(n).op == Op::state) {
            transition(c, n);
        }
    }
    state.transition_count =
        static_cast<std::uint32_t>(program.transitions.size()) - state.first_transition;

    std::vector<BlockId> entry = data_blocks(e, n);
    const std::vector<BlockId> onentry = blocks(e, "onentry", n);
    entry.insert(entry.end(), onentry.begin(), onentry.end());
    const std::vector<BlockId> onexit = blocks(e, "onexit", n);
    state.first_entry = add_blocks(entry);
    state.entry_count = static_cast<std::uint32_t>(entry.size());
    state.first_exit = add_blocks(onexit);
    state.exit_count = static_cast<std::uint32_t>(onexit.size());

    state.initial = initial_of(n);
    for (RowId up = program.at(n).parent; up && !state.outer; up = program.at(up).parent) {
        if (program.state(up).transition_count != 0) { state.outer = up; }
    }
    if (program.at(n).op == Op::state && document().find(e, "id") != nullptr) {
        state.done = event("done.state." + program.names[n.index]);
    }
    for (const RowId c : children(program, n)) {
        if (program.at(c).op == Op::invoke) { ++state.invokes; }
    }
    program.states[program.at(n).arg] = state;
}

// What the event `tick` asks while the state is the active atomic one.
void MachineCompiler::find_quiet_guards(RowId n) {
    Program& program = builder_.program;
    StateInfo& state = program.states[program.at(n).arg];
    std::vector<Condition> guards;
    for (RowId at = n; at; at = program.state(at).outer) {
        const StateInfo& around = program.state(at);
        for (std::uint32_t i = 0; i < around.transition_count; ++i) {
            const Transition& t = program.transitions[around.first_transition + i];
            bool named = false;
            for (std::uint32_t k = 0; k < t.event_count && program.tick_event; ++k) {
                named = named ||
                        program.matches(program.descriptors[t.first_event + k], program.tick_event);
            }
            if (t.event_count == 0 || (named && t.guard.form == Condition::Form::code)) { return; }
            if (named) { guards.push_back(t.guard); }
        }
    }
    state.may_be_quiet = true;
    state.first_guard = static_cast<std::uint32_t>(program.quiet_guards.size());
    state.guard_count = static_cast<std::uint32_t>(guards.size());
    program.quiet_guards.insert(program.quiet_guards.end(), guards.begin(), guards.end());
}

void MachineCompiler::transition(ElementId e, RowId source) {
    Program& program = builder_.program;
    Transition t{.source = source};
    t.first_event = static_cast<std::uint32_t>(program.descriptors.size());
    if (const Attribute* events = document().find(e, "event"); events != nullptr) {
        for (const std::string_view word : words(document().string(events->value))) {
            program.descriptors.push_back(event(word));
        }
    }
    t.event_count = static_cast<std::uint32_t>(program.descriptors.size()) - t.first_event;
    program.has_eventless |= t.event_count == 0;
    if (t.event_count == 1) {
        t.event_begin = program.descriptors.back();
        t.event_end = program.events[t.event_begin.index].end;
    }
    if (const Attribute* cond = document().find(e, "cond"); cond != nullptr) {
        t.guard = find_condition(program, expression(*cond, source));
    }
    if (const Attribute* target = document().find(e, "target"); target != nullptr) {
        if (add_targets(*target, {0}, t)) {
            t.internal = document().value(e, "type") == "internal";
            t.domain = domain_of(t);
            t.internal = t.internal && t.domain == source;
        }
    }
    if (document().child_count(e) != 0) { t.block = block(e, source); }
    program.transitions.push_back(t);
}

// The states that an attribute names; they must lie inside `inside` and not exclude each other.
bool MachineCompiler::add_targets(const Attribute& attribute, RowId inside, Transition& t) {
    Program& program = builder_.program;
    Diagnostics& diagnostics = builder_.diagnostics();
    t.first_target = static_cast<std::uint32_t>(program.targets.size());
    std::vector<RowId> targets;
    for (const std::string_view word : words(document().string(attribute.value))) {
        const auto found = scope_.states.find(word);
        if (found == scope_.states.end()) {
            std::vector<std::string_view> known;
            for (const auto& [id, n] : scope_.states) {
                known.push_back(id);
            }
            std::sort(known.begin(), known.end());
            diagnostics.error("unknown-state", attribute.value_where,
                              "there is no state \"" + std::string(word) + "\"" +
                                  suggestion(word, known));
            continue;
        }
        if (found->second == inside || !program.within(found->second, inside)) {
            diagnostics.error("initial-outside", attribute.value_where,
                              "\"" + std::string(word) + "\" is not inside \"" +
                                  program.names[inside.index] + "\"");
            continue;
        }
        targets.push_back(found->second);
    }
    // a state around another target is entered on the way to it
    for (const RowId target : targets) {
        const bool around = std::any_of(targets.begin(), targets.end(), [&](RowId other) {
            return other != target && program.within(other, target);
        });
        if (!around) { program.targets.push_back(target); }
    }
    t.target_count = static_cast<std::uint32_t>(program.targets.size()) - t.first_target;
    for (std::uint32_t i = 1; i < t.target_count; ++i) {
        const RowId a = program.targets[t.first_target];
        const RowId b = program.targets[t.first_target + i];
        diagnostics.error("illegal-targets", attribute.value_where,
                          "the states \"" + program.names[a.index] + "\" and \"" +
                              program.names[b.index] + "\" cannot be active together");
    }
    return t.target_count != 0;
}

// Where a machine or compound state begins: <initial>, the attribute, or its first state.
TransitionId MachineCompiler::initial_of(RowId n) {
    Program& program = builder_.program;
    const ElementId e = elements_[n.index];
    Transition t{.source = n, .domain = n};
    RowId first;
    const Attribute* target = document().find(e, "initial");
    for (const ElementId c : document().children(e)) {
        if (document().name(c) != "initial" || document().child_count(c) == 0) { continue; }
        const ElementId way = *document().children(c).begin();
        target = document().find(way, "target");
        if (document().child_count(way) != 0) { t.block = block(way, n); }
    }
    for (const RowId c : children(program, n)) {
        if (program.at(c).op != Op::invoke && !first) { first = c; }
    }
    if (!first) {
        // where something else is wrong, the states may be what could not be read
        if (target != nullptr && builder_.diagnostics().ok()) {
            builder_.diagnostics().error("initial-outside", target->value_where,
                                         "\"" + program.names[n.index] +
                                             "\" has no states to begin in");
        }
        return {};
    }
    if (target != nullptr) {
        if (!add_targets(*target, n, t)) { return {}; }
    } else {
        t.first_target = static_cast<std::uint32_t>(program.targets.size());
        t.target_count = 1;
        program.targets.push_back(first);
    }
    program.transitions.push_back(t);
    return {static_cast<std::uint32_t>(program.transitions.size() - 1)};
}

// The innermost compound state, or the machine, that is around the source and all targets; the
// source itself if the transition is internal and its targets lie inside (SCXML 3.13).
RowId MachineCompiler::domain_of(const Transition& t) const {
    const Program& program = builder_.program;
    const auto around_targets = [&](RowId n) {
        for (std::uint32_t i = 0; i < t.target_count; ++i) {
            const RowId target = program.targets[t.first_target + i];
            if (target == n || !program.within(target, n)) { return false; }
        }
        return true;
    };
    if (t.internal && around_targets(t.source)) { return t.source; }
    RowId n = program.at(t.source).parent;
    while (!around_targets(n)) {
        n = program.at(n).parent;
    }
    return n;
}

// Activities --------------------------------------------------------------------------------------

void MachineCompiler::fill_invoke(RowId n) {
    const ElementId e = elements_[n.index];
    if (builder_.program.at(n).end.index == n.index + 1) { return; }  // reported before
    if (document().value(e, "type") == "leaf") { return fill_leaf(e, n); }
    for (InvokedTree& tree : trees_) {
        if (tree.invoke == n) { tree_params(e, n, tree.compiler.scopes()); }
    }
}

void MachineCompiler::fill_leaf(ElementId e, RowId invoke) {
    Program& program = builder_.program;
    const LeafType& type = *builder_.registry().find(document().value(e, "src"));
    const std::uint32_t call = builder_.add_call(type);
    program.rows[invoke.index + 1].arg = call;
    for (const ElementId c : document().children(e)) {
        if (document().name(c) == "param") { leaf_param(c, program.at(invoke).parent, type); }
    }
    for (const Port& port : type.ports) {
        if (!port.required) { continue; }
        const auto given = [&](ElementId c) { return document().value(c, "name") == port.name; };
        bool found = false;
        for (const ElementId c : document().children(e)) {
            found = found || given(c);
        }
        if (!found) {
            builder_.diagnostics().error("missing-param", document().at(e).where,
                                         type.name + " needs the param \"" + port.name + "\"");
        }
    }
}

void MachineCompiler::leaf_param(ElementId param, RowId state, const LeafType& type) {
    const Attribute* name = document().find(param, "name");
    if (name == nullptr) { return; }
    const Port* port = type.find(document().string(name->value));
    Diagnostics& diagnostics = builder_.diagnostics();
    if (port == nullptr) {
        std::vector<std::string_view> known;
        for (const Port& other : type.ports) {
            known.emplace_back(other.name);
        }
        diagnostics.error("unknown-port", name->value_where,
                          type.name + " has no port \"" +
                              std::string(document().string(name->value)) + "\"" +
                              suggestion(document().string(name->value), known));
        return;
    }
    if (port->direction != PortDirection::output) {
        const CodeId code = param_code(param, state);
        if (!code) { return; }
        const Instruction& first = builder_.program.code.instructions[code.index];
        const bool literal =
            first.last && first.op == CodeOp::copy && first.a.space() == Space::constant;
        if (!literal) {
            builder_.set_live(*port, code);
        } else if (const Value value = builder_.program.code.constants[first.a.index()];
                   !builder_.set_literal(*port, value)) {
            diagnostics.error("bad-value", document().at(param).where,
                              print(value) + " is not of the type of \"" + port->name + "\", " +
                                  std::string(name_of(port->type)));
        }
    }
    if (port->direction == PortDirection::input) { return; }
    const Attribute* location = document().find(param, "location");
    const auto variable =
        location == nullptr
            ? scope_.variables.end()
            : scope_.variables.find(std::string(document().string(location->value)));
    if (variable == scope_.variables.end()) {
        diagnostics.error("bad-output", document().at(param).where,
                          "the output \"" + port->name + "\" needs location=\"a variable\"");
        return;
    }
    builder_.set_output(*port, variable->second);
}

void MachineCompiler::tree_params(ElementId e, RowId invoke, Scopes& scopes) {
    Program& program = builder_.program;
    InvokeInfo& info = program.invokes[program.at(invoke).arg];
    info.first_param = static_cast<std::uint32_t>(program.params.size());
    for (const ElementId c : document().children(e)) {
        const Attribute* name = document().find(c, "name");
        if (document().name(c) != "param" || name == nullptr) { continue; }
        const SlotId slot = scopes.variable({0}, document().string(name->value));
        scopes.written(slot);
        const CodeId code = param_code(c, program.at(invoke).parent);
        if (code) { program.params.push_back({slot, code}); }
    }
    info.param_count = static_cast<std::uint32_t>(program.params.size()) - info.first_param;
}

CodeId MachineCompiler::param_code(ElementId param, RowId state) {
    const Attribute* value = document().find(param, "expr");
    const bool is_location = value == nullptr;
    if (is_location) { value = document().find(param, "location"); }
    if (value == nullptr) { return {}; }
    return expression(*value, state,
                      is_location ? SyntaxMode::location : SyntaxMode::single_expression);
}

CodeId MachineCompiler::expression(const Attribute& attribute, RowId state, SyntaxMode mode) {
    const Builder::Text text = Builder::text_of(file_, attribute);
    MachineNames names(builder_, scope_, state, text);
    return builder_.expression(text, Dialect::machine, mode, names);
}

void compile_machine(ReadFile file, Builder& builder) {
    MachineCompiler(builder, std::move(file)).machine();
}

}  // namespace trellis
