// Executable content and data of machines: elements to actions (SCXML 4 and 5).
// SPDX-License-Identifier: MIT
#include "load/expression.h"
#include "load/machine_compiler.h"
#include "load/words.h"

#include <algorithm>
#include <utility>

namespace trellis {

namespace {

/// Whether it is made of literals, arrays and objects only: what JSON can spell.
bool is_literal(const Syntax& syntax) {
    return std::all_of(syntax.nodes.begin(), syntax.nodes.end(), [](const SyntaxNode& node) {
        return node.kind == SyntaxKind::literal || node.kind == SyntaxKind::array ||
               node.kind == SyntaxKind::object ||
               (node.kind == SyntaxKind::unary && node.op == CodeOp::negate);
    });
}

}  // namespace

BlockId MachineCompiler::next_action() const {
    return {static_cast<std::uint32_t>(builder_.program.actions.size())};
}

Action& MachineCompiler::add_action(Action::Kind kind) {
    return builder_.program.actions.emplace_back(Action{.kind = kind});
}

std::uint32_t MachineCompiler::add_blocks(const std::vector<BlockId>& list) {
    std::vector<BlockId>& table = builder_.program.blocks;
    table.insert(table.end(), list.begin(), list.end());
    return static_cast<std::uint32_t>(table.size() - list.size());
}

// The content of one element as a block of its own.
BlockId MachineCompiler::block(ElementId parent, RowId state) {
    const BlockId begin = next_action();
    content(parent, state);
    add_action(Action::Kind::end);
    return begin;
}

void MachineCompiler::content(ElementId parent, RowId state) {
    for (const ElementId c : document().children(parent)) {
        action(c, state);
    }
}

std::vector<BlockId> MachineCompiler::blocks(ElementId of, std::string_view name, RowId state) {
    std::vector<BlockId> found;
    for (const ElementId c : document().children(of)) {
        if (document().name(c) == name) { found.push_back(block(c, state)); }
    }
    return found;
}

void MachineCompiler::action(ElementId e, RowId state) {
    Program& program = builder_.program;
    const std::string_view name = document().name(e);
    if (name == "raise") {
        if (const Attribute* raised = document().find(e, "event"); raised != nullptr) {
            add_action(Action::Kind::raise).event = event(document().string(raised->value));
        }
    } else if (name == "log") {
        const Attribute* value = document().find(e, "expr");
        const CodeId code = value != nullptr ? expression(*value, state) : CodeId();
        Action& log = add_action(Action::Kind::log);
        log.code = code;
        log.label = static_cast<std::uint32_t>(program.labels.size());
        program.labels.emplace_back(document().value(e, "label"));
    } else if (name == "assign") {
        const Attribute* location = document().find(e, "location");
        if (location == nullptr) { return; }
        const Attribute* value = document().find(e, "expr");
        const CodeId code = value != nullptr ? expression(*value, state) : text_value(e, state);
        const Builder::Text place = Builder::text_of(file_, *location);
        MachineNames names(builder_, scope_, state, place);
        const CodeId store = builder_.store(place, names);
        Action& assign = add_action(Action::Kind::assign);
        assign.code = code;
        const auto variable = scope_.variables.find(std::string(place.text));
        if (variable != scope_.variables.end()) {
            assign.slot = variable->second;
        } else {
            assign.store = store;
        }
    } else if (name == "script") {
        const Builder::Text script = Builder::text_of(file_, e);
        MachineNames names(builder_, scope_, state, script);
        const CodeId code =
            builder_.expression(script, Dialect::machine, SyntaxMode::script, names.of_script());
        add_action(Action::Kind::run).code = code;
    } else if (name == "if") {
        branches(e, state);
    }
}

// <if cond> A <elseif cond> B <else/> C: a test and a jump per branch, no nesting (SCXML 4.3).
void MachineCompiler::branches(ElementId e, RowId state) {
    std::vector<Action>& actions = builder_.program.actions;
    std::vector<std::size_t> jumps;  // from the end of each branch to the end of all
    std::size_t test = actions.size();
    const auto begin_branch = [&](const Attribute* cond) {
        const CodeId code = cond != nullptr ? expression(*cond, state) : CodeId();
        test = actions.size();
        add_action(Action::Kind::unless).code = code;
    };
    const auto end_branch = [&] {
        jumps.push_back(actions.size());
        add_action(Action::Kind::jump);
        actions[test].go_to = next_action();
    };
    begin_branch(document().find(e, "cond"));
    bool in_else = false;
    for (const ElementId c : document().children(e)) {
        const std::string_view name = document().name(c);
        if (name == "elseif") {
            end_branch();
            begin_branch(document().find(c, "cond"));
        } else if (name == "else") {
            end_branch();
            in_else = true;
        } else {
            action(c, state);
        }
    }
    if (!in_else) { actions[test].go_to = next_action(); }
    for (const std::size_t jump : jumps) {
        actions[jump].go_to = next_action();
    }
}

// Data --------------------------------------------------------------------------------------------

// A block per variable, because an error in one must not keep the others from their values. Early
// binding: all of them when the machine starts. Late: each when its state is first entered, before
// its onentry (SCXML 5.3.3).
std::vector<BlockId> MachineCompiler::data_blocks(ElementId of, RowId state) {
    std::vector<BlockId> found;
    const ElementId root = document().root();
    if (late_) {
        for (const ElementId c : document().children(of)) {
            if (document().name(c) != "datamodel") { continue; }
            for (const ElementId data : document().children(c)) {
                add_data(data, state, found);
            }
        }
    } else if (of == root) {
        for (ElementId e = root; e != document().at(root).end; ++e.index) {
            if (document().name(e) == "data") { add_data(e, {0}, found); }
        }
    }
    if (of == root) {
        for (const ElementId c : document().children(root)) {
            if (document().name(c) != "script") { continue; }
            found.push_back(next_action());
            action(c, {0});
            add_action(Action::Kind::end);
        }
    }
    return found;
}

void MachineCompiler::add_data(ElementId data, RowId state, std::vector<BlockId>& found) {
    Program& program = builder_.program;
    const auto slot = scope_.variables.find(std::string(document().value(data, "id")));
    if (slot == scope_.variables.end()) { return; }
    const Attribute* value = document().find(data, "expr");
    const CodeId code = value != nullptr ? expression(*value, state) : text_value(data, state);
    if (!code) { return; }
    const Instruction& first = program.code.instructions[code.index];
    if (!late_ && first.last && first.op == CodeOp::copy && first.a.space() == Space::constant) {
        program.slots[slot->second.index].initial = program.code.constants[first.a.index()];
        return;
    }
    found.push_back(next_action());
    Action& initialise = add_action(Action::Kind::initialise);
    initialise.code = code;
    initialise.slot = slot->second;
    add_action(Action::Kind::end);
}

// Inline content is a value if it is one, else its words (SCXML 5.9.3, B.2.9). None if empty.
CodeId MachineCompiler::text_value(ElementId e, RowId state) {
    const std::string_view text = document().text(e);
    if (text.empty()) { return {}; }
    ParseError wrong;
    const std::optional<Syntax> syntax =
        parse_expression(text, Dialect::machine, SyntaxMode::single_expression, wrong);
    if (syntax && is_literal(*syntax)) {
        const Builder::Text literal = Builder::text_of(file_, e);
        MachineNames names(builder_, scope_, state, literal);
        return builder_.expression(literal, Dialect::machine, SyntaxMode::single_expression, names);
    }
    std::string normal;
    for (const std::string_view word : words(text)) {
        if (!normal.empty()) { normal += ' '; }
        normal += word;
    }
    return builder_.constant(Value::text(normal), Dialect::machine);
}

}  // namespace trellis
