// Executable content and data of machines: elements to actions (SCXML 4 and 5).
// SPDX-License-Identifier: MIT
#include "load/expression.h"
#include "load/forms.h"
#include "load/machine_compiler.h"
#include "load/text.h"
#include "load/words.h"
#include "load/xml.h"

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
    const std::string_view name = document().name(e);
    if (name == "raise") {
        if (const Attribute* raised = document().find(e, "event"); raised != nullptr) {
            add_action(Action::Kind::raise).event = event(document().string(raised->value));
        }
    } else if (name == "log") {
        const CodeId code = expression(e, "expr", state);
        Action& log = add_action(Action::Kind::log);
        log.code = code;
        log.arg = label(std::string(document().value(e, "label")));
    } else if (name == "assign") {
        assign(e, state);
    } else if (name == "script") {
        script(e, state);
    } else if (name == "if") {
        branches(e, state);
    } else if (name == "foreach") {
        loop(e, state);
    } else if (name == "send") {
        send(e, state);
    } else if (name == "cancel") {
        cancel(e, state);
    }
}

std::uint32_t MachineCompiler::label(std::string text) {
    std::vector<std::string>& labels = builder_.program.labels;
    labels.push_back(std::move(text));
    return static_cast<std::uint32_t>(labels.size() - 1);
}

void MachineCompiler::assign(ElementId e, RowId state) {
    const Attribute* location = document().find(e, "location");
    if (location == nullptr) { return; }
    const Attribute* value = document().find(e, "expr");
    const CodeId code = value != nullptr ? expression(*value, state) : text_value(e, state);
    const Place to = place(*location, state);
    Action& assign = add_action(Action::Kind::assign);
    assign.code = code;
    assign.slot = to.slot;
    assign.store = to.store;
}

void MachineCompiler::script(ElementId e, RowId state) {
    Builder::Text text = Builder::text_of(file_, e);
    if (const Attribute* const src = document().find(e, "src"); src != nullptr) {
        const std::optional<Builder::Text> found = named_file(*src);
        if (!found) { return; }
        text = *found;
    }
    MachineNames names(builder_, scope_, state, text);
    const CodeId code =
        builder_.expression(text, Dialect::machine, SyntaxMode::script, names.of_script());
    add_action(Action::Kind::run).code = code;
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

// <foreach>: its content is a block of its own inside the one around it.
void MachineCompiler::loop(ElementId e, RowId state) {
    const CodeId array = expression(e, "array", state);
    const Attribute* const item = document().find(e, "item");
    const Attribute* const index = document().find(e, "index");
    if (item == nullptr) { return; }
    Loop loop;
    for (const Attribute* const attribute : {item, index}) {
        if (attribute == nullptr) { continue; }
        const SlotId slot = loop_variable(*attribute);
        if (!slot) { return; }
        (attribute == item ? loop.item : loop.index) = slot;
    }
    std::vector<Action>& actions = builder_.program.actions;
    const std::size_t begin = actions.size();
    Action& each = add_action(Action::Kind::each);
    each.code = array;
    each.arg = static_cast<std::uint32_t>(builder_.program.loops.size());
    builder_.program.loops.push_back(loop);
    content(e, state);
    add_action(Action::Kind::end);
    actions[begin].go_to = next_action();
}

// A variable of that name, made if there is none (SCXML 4.6). None if it cannot be one: the loop
// then fails when it is reached.
SlotId MachineCompiler::loop_variable(const Attribute& attribute) {
    const std::string name(document().string(attribute.value));
    const bool is_name = !name.empty() && name[0] != '_' && !(name[0] >= '0' && name[0] <= '9') &&
                         std::all_of(name.begin(), name.end(), [](char c) {
                             return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                    (c >= '0' && c <= '9') || c == '_';
                         });
    if (!is_name) {
        const std::string why = quoted(name) + " cannot be a variable";
        builder_.diagnostics().warning("not-a-variable", attribute.value_where, why);
        add_action(Action::Kind::refuse).arg = label(why);
        return {};
    }
    const auto [at, fresh] = scope_.variables.try_emplace(name);
    if (fresh) { at->second = builder_.add_slot(name, {0}); }
    return at->second;
}

// Data --------------------------------------------------------------------------------------------

// A block per variable, because an error in one must not keep the others from their values. Early
// binding: all of them when the machine starts. Late: each when its state is first entered, before
// its onentry (SCXML 5.3.3).
std::vector<BlockId> MachineCompiler::data_blocks(ElementId of, RowId state) {
    std::vector<BlockId> found;
    if (late_) {
        for (const ElementId c : document().children(of)) {
            if (document().name(c) != "datamodel") { continue; }
            for (const ElementId data : document().children(c)) {
                add_data(data, state, found);
            }
        }
    } else if (of == root_) {
        for_each_element([&](ElementId e) {
            if (document().name(e) == "data") { add_data(e, {0}, found); }
        });
    }
    if (of == root_) {
        for (const ElementId c : document().children(root_)) {
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
    CodeId code = expression(data, "expr", state);
    if (const Attribute* const src = document().find(data, "src"); src != nullptr) {
        const std::optional<Builder::Text> text = named_file(*src);
        if (!text) { return; }
        code = text_value(*text, state);
    } else if (!code) {
        code = text_value(data, state);
    }
    if (!code) { return; }
    if (const Value* const value = literal_of(program.code, code); !late_ && value != nullptr) {
        program.slots[slot->second.index].initial = *value;
        return;
    }
    found.push_back(next_action());
    Action& initialise = add_action(Action::Kind::initialise);
    initialise.code = code;
    initialise.slot = slot->second;
    add_action(Action::Kind::end);
}

// Inline content is a value if it is one, else its words; elements are their text in XML (SCXML
// 5.9.3, B.2.9). None if it is empty.
CodeId MachineCompiler::text_value(ElementId e, RowId state) {
    if (document().child_count(e) != 0) {
        std::string xml;
        for (const ElementId c : document().children(e)) {
            xml += write_xml(document(), c);
        }
        return builder_.constant(Value::text(trimmed(xml)), Dialect::machine);
    }
    return text_value(Builder::text_of(file_, e), state);
}

CodeId MachineCompiler::text_value(const Builder::Text& text, RowId state) {
    if (is_blank(text.text)) { return {}; }
    ParseError wrong;
    const std::optional<Syntax> syntax =
        parse_expression(text.text, Dialect::machine, SyntaxMode::single_expression, wrong);
    if (syntax && is_literal(*syntax)) {
        MachineNames names(builder_, scope_, state, text);
        return builder_.expression(text, Dialect::machine, SyntaxMode::single_expression, names);
    }
    std::string normal;
    for (const std::string_view word : words(text.text)) {
        if (!normal.empty()) { normal += ' '; }
        normal += word;
    }
    return builder_.constant(Value::text(normal), Dialect::machine);
}

// The text of the file that a src names; nothing after an error.
std::optional<Builder::Text> MachineCompiler::named_file(const Attribute& src) {
    const std::string_view path = document().string(src.value);
    std::optional<Source> source;
    if (SourceReader* const reader = builder_.options().reader; reader != nullptr) {
        source = reader->read(path_of_uri(path), file_.name, {});
    }
    Diagnostics& diagnostics = builder_.diagnostics();
    if (!source) {
        diagnostics.error("unreadable-file", src.value_where,
                          "cannot read \"" + std::string(path) + "\"");
        return {};
    }
    const std::string& text = named_texts_.emplace_back(std::move(source->text));
    const std::uint32_t file = diagnostics.add_file(source->name, text);
    return Builder::Text{&file_, text, {.file = file, .line = 1, .column = 1}};
}

}  // namespace trellis
