// What states invoke: leaves and trees with their parameters, machines with what they are given.
// SPDX-License-Identifier: MIT
#include "load/check.h"
#include "load/forms.h"
#include "load/machine_compiler.h"
#include "load/words.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace trellis {

namespace {

bool is_true(std::string_view boolean) {
    return boolean == "true" || boolean == "True" || boolean == "TRUE" || boolean == "1";
}

/// Whether an <invoke> of that type is a machine (SCXML 6.4.1).
bool is_machine_type(std::string_view type) {
    return type.empty() || type == "scxml" || type == "http://www.w3.org/TR/scxml/" ||
           type == "http://www.w3.org/TR/scxml";
}

}  // namespace

void MachineCompiler::check_invoke_type(ElementId e) {
    const Attribute* const attribute = document().find(e, "type");
    if (attribute == nullptr) { return; }
    const std::string_view type = document().string(attribute->value);
    Diagnostics& diagnostics = builder_.diagnostics();
    if (type != "leaf" && type != "tree") {
        if (is_machine_type(type)) { return; }
        diagnostics.error("bad-value", attribute->value_where,
                          "\"type\": expected leaf, tree or scxml, found \"" + std::string(type) +
                              '"' + suggestion(type, {"leaf", "tree", "scxml"}));
        return;
    }
    // what only machines have
    for (const char* const other : {"srcexpr", "idlocation", "namelist", "autoforward"}) {
        if (const Attribute* const found = document().find(e, other); found != nullptr) {
            diagnostics.error("not-of-a-machine", found->where,
                              "a " + std::string(type) + " takes no \"" + other + '"');
        }
    }
    for (const ElementId c : document().children(e)) {
        const std::string_view name = document().name(c);
        if (name == "content" || name == "finalize") {
            diagnostics.error("not-of-a-machine", document().at(c).where,
                              "a " + std::string(type) + " takes no <" + std::string(name) + '>');
        }
    }
}

void MachineCompiler::invoke_row(ElementId e, RowId state, const std::string& id) {
    Program& program = builder_.program;
    const std::string_view src = document().value(e, "src");
    const std::string_view type = document().value(e, "type");
    const LeafType* leaf = type == "leaf" ? builder_.registry().find(src) : nullptr;
    check_invoke_type(e);
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
                               .done = event("done.invoke." + id),
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
        text = reader->read(path_of_uri(path), file_.name, {});
    }
    if (!text) {
        diagnostics.error("unreadable-file", source.value_where,
                          "cannot read \"" + std::string(path) + "\"");
        return;
    }
    std::optional<Document> tree = read(*text, diagnostics, builder_.options());
    if (!tree) { return; }
    check(*tree, builder_.grammar(), diagnostics);
    InvokedTree& invoked = trees_.emplace_back(builder_, invoke, machines_);
    invoked.files.add({std::move(text->name), std::move(*tree)});
    if (const TreeSource* main = invoked.files.main_tree({}); main != nullptr) {
        invoked.compiler.tree(*main, invoke);
    }
}

void MachineCompiler::fill_invoke(RowId n) {
    const ElementId e = elements_[n.index];
    if (is_machine_type(document().value(e, "type"))) { return fill_machine(e, n); }
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
        const Value* const literal = literal_of(builder_.program.code, code);
        if (literal == nullptr) {
            builder_.set_live(*port, code);
        } else if (const Value value = *literal; !builder_.set_literal(*port, value)) {
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
        const std::string_view port = document().string(name->value);
        if (!scopes.find({0}, port)) {
            builder_.diagnostics().warning("unused-parameter", name->value_where,
                                           "nothing in the tree uses \"" + std::string(port) + '"' +
                                               suggestion(port, scopes.names({0})));
        }
        const SlotId slot = scopes.variable({0}, port);
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

// Machines ----------------------------------------------------------------------------------------

void MachineCompiler::fill_machine(ElementId e, RowId n) {
    const RowId state = builder_.program.at(n).parent;
    builder_.program.has_messages = true;
    InvokeInfo info = builder_.program.invokes[builder_.program.at(n).arg];
    if (const Attribute* const src = document().find(e, "src"); src != nullptr) {
        info.machine = machines_.file(document().string(src->value), file_, src->value_where);
    }
    info.source = expression(e, "srcexpr", state);
    info.type = expression(e, "typeexpr", state);
    info.payload = payload(e, state);
    info.autoforward = is_true(document().value(e, "autoforward"));
    if (const Attribute* const where = document().find(e, "idlocation"); where != nullptr) {
        info.id_place = place(*where, state);
    }
    for (const ElementId c : document().children(e)) {
        if (document().name(c) == "finalize") { info.finalize = finalize(e, c, state); }
        if (document().name(c) != "content") { continue; }
        if (document().find(c, "expr") != nullptr) { info.source = expression(c, "expr", state); }
        for (const ElementId machine : document().children(c)) {
            if (document().name(machine) == "scxml") {
                info.machine = machines_.element(file_, machine);
            }
        }
    }
    computes_source_ |= static_cast<bool>(info.source);
    builder_.program.invokes[builder_.program.at(n).arg] = std::move(info);
}

// An empty <finalize> gives the variables of the namelist, and the locations of the <param>s, what
// the event holds under their names (SCXML 6.5.2).
BlockId MachineCompiler::finalize(ElementId invoke, ElementId e, RowId state) {
    if (document().child_count(e) != 0) { return block(e, state); }
    std::vector<std::pair<std::string, const Attribute*>> locations;
    const Attribute* const list = document().find(invoke, "namelist");
    for (const std::string_view word : words(document().value(invoke, "namelist"))) {
        locations.emplace_back(word, list);
    }
    for (const ElementId c : document().children(invoke)) {
        const Attribute* const location = document().find(c, "location");
        if (document().name(c) != "param" || location == nullptr) { continue; }
        locations.emplace_back(document().value(c, "name"), location);
    }
    const BlockId begin = next_action();
    for (const auto& [member, at] : locations) {
        const std::string& name = member;  // clang 14 captures no structured bindings
        const Attribute* const attribute = at;
        const std::string value = "_event.data['" + name + "']";
        const std::string is_there = "isDefined(" + value + ')';
        const auto code = [&](const std::string& text) {
            const Builder::Text source{&file_, text, attribute->value_where};
            MachineNames names(builder_, scope_, state, source);
            return builder_.expression(source, Dialect::machine, SyntaxMode::single_expression,
                                       names);
        };
        const CodeId cond = code(is_there);
        const CodeId given = code(value);
        Builder::Text location = Builder::text_of(file_, *attribute);
        if (attribute == list) { location.text = name; }
        MachineNames names(builder_, scope_, state, location);
        const CodeId store = builder_.store(location, names);
        add_action(Action::Kind::unless).code = cond;
        builder_.program.actions.back().go_to = {next_action().index + 1};
        Action& assign = add_action(Action::Kind::assign);
        assign.code = given;
        assign.store = store;
    }
    add_action(Action::Kind::end);
    return begin;
}

// A computed source must be one of the texts that the machine can compute it from: those that it
// spells, or that a <data> holds.
void MachineCompiler::find_sources() {
    Program& program = builder_.program;
    std::vector<std::string> texts;
    for (const Value& constant : program.code.constants) {
        if (constant.is(Value::Kind::text)) { texts.push_back(constant.as_text()); }
    }
    for (const Slot& slot : program.slots) {
        if (slot.initial.is(Value::Kind::text)) { texts.push_back(slot.initial.as_text()); }
    }
    std::sort(texts.begin(), texts.end());
    texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
    for (std::string& text : texts) {
        const MachineId machine = machines_.source(text, file_);
        if (machine) { program.sources.push_back({std::move(text), machine}); }
    }
}

}  // namespace trellis
