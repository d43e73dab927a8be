// Nodes to rows.
// SPDX-License-Identifier: MIT
#include "load/tree_compiler.h"

#include "core/ports.h"
#include "load/attribute_rule.h"
#include "load/compile.h"
#include "load/json_literal.h"
#include "load/tree_checks.h"

#include <algorithm>
#include <utility>

namespace trellis {

namespace {

constexpr std::string_view explicit_forms[] = {"Action", "Condition", "Control", "Decorator"};

bool is_explicit(std::string_view element) {
    return std::find(std::begin(explicit_forms), std::end(explicit_forms), element) !=
           std::end(explicit_forms);
}

}  // namespace

TreeCompiler::TreeCompiler(Builder& builder, TreeFiles& files, InvokedMachines& machines)
    : builder_(builder), files_(files), machines_(machines), scopes_(builder), types_(builder) {
    for (const OpInfo& op : op_table()) {
        const bool node = op.group == OpGroup::control || op.group == OpGroup::decorator ||
                          op.group == OpGroup::action || op.group == OpGroup::condition;
        if (node && !op.element.empty()) { built_ins_.emplace(op.element, op.op); }
    }
    for (const LeafType& type : builder.registry().leaves()) {
        leaves_.emplace(type.name, &type);
    }
}

RowId TreeCompiler::tree(const TreeSource& tree, RowId parent) {
    const Document& document = tree.file->document;
    const RowId n = builder_.open(Op::tree, parent, tree.id.empty() ? "tree" : tree.id,
                                  document.at(tree.element).where);
    if (!n) { return n; }
    const ScopeId scope = scopes_.add(n, {});
    paths_.resize(scope.index + 1);
    reached_.insert(tree.id);
    expanding_.push_back(tree.id);
    children_of({tree.file, tree.element, scope, n}, n);
    expanding_.pop_back();
    builder_.close(n);
    return n;
}

void TreeCompiler::finish() {
    for (const auto& [name, value] : builder_.options().given) {
        const SlotId slot = scopes_.find(main_scope(), name);
        if (slot) { scopes_.written(slot); }
    }
    finish_checks();
    scopes_.check_needed();
    std::vector<SlotId>& unset = builder_.unset;
    const std::vector<SlotId> more = scopes_.never_written();
    unset.insert(unset.end(), more.begin(), more.end());
    std::sort(unset.begin(), unset.end());
}

// What can be said of any tree that is compiled as a whole.
void TreeCompiler::finish_checks() {
    types_.report();
    // what an error has left out may have been the use
    if (!builder_.diagnostics().ok() || builder_.substitutions != nullptr) { return; }
    for (const Unused& unused : unused_) {
        builder_.diagnostics().warning("unused-parameter", unused.where, unused.message);
    }
}

void TreeCompiler::check_unreached() {
    for (const TreeSource& source : files_.trees()) {
        if (reached_.contains(source.id)) { continue; }
        Builder scratch(builder_.registry(), builder_.grammar(), builder_.diagnostics(),
                        builder_.options());
        scratch.substitutions = builder_.substitutions;
        TreeCompiler compiler(scratch, files_, machines_);
        compiler.tree(source, {});
        compiler.finish_checks();
        if (builder_.diagnostics().ok() && builder_.substitutions == nullptr) {
            check_trees(scratch.program, {}, builder_.diagnostics());
        }
        for (const std::string_view id : compiler.reached_) {
            reached_.insert(id);
        }
    }
}

void TreeCompiler::report_unused_trees(const TreeSource& main) {
    if (!builder_.diagnostics().ok() || builder_.substitutions != nullptr) { return; }
    for (const TreeSource& source : files_.trees()) {
        if (source.file != main.file || reached_.contains(source.id)) { continue; }
        builder_.diagnostics().warning(
            "unused-tree", source.file->document.at(source.element).where,
            "the tree \"" + source.id + "\" is never used: no SubTree leads to it from \"" +
                main.id + '"');
    }
}

void TreeCompiler::children_of(const Place& place, RowId n) {
    for (const ElementId child : document(place).children(place.element)) {
        if (builder_.is_full()) { return; }
        node({place.file, child, place.scope, n});
    }
}

// The name of the node or leaf, whichever way it is spelt.
std::string_view TreeCompiler::kind(const Place& place) const {
    const std::string_view element = document(place).name(place.element);
    return is_explicit(element) ? document(place).value(place.element, "ID") : element;
}

std::string_view TreeCompiler::instance_name(const Place& place) const {
    const std::string_view element = document(place).name(place.element);
    const std::string_view otherwise =
        element == "SubTree" ? document(place).value(place.element, "ID") : kind(place);
    return document(place).value(place.element, "name", otherwise);
}

void TreeCompiler::node(const Place& place) {
    if (builder_.substitutions != nullptr) {
        if (const SubstitutionRule* rule = rule_for(place)) { return replace(place, *rule); }
    }
    const std::string_view name = kind(place);
    if (name == "SubTree") { return subtree(place); }
    if (const auto op = built_ins_.find(name); op != built_ins_.end()) {
        return built_in(place, op_table()[op->second]);
    }
    // an unknown name has been reported by check()
    if (const auto type = leaves_.find(name); type != leaves_.end()) { leaf(place, *type->second); }
}

// Leaves ------------------------------------------------------------------------------------------

void TreeCompiler::leaf(const Place& place, const LeafType& type) {
    const std::uint32_t call = builder_.add_call(type);
    const bool long_form = is_explicit(document(place).name(place.element));
    for (const Attribute& attribute : document(place).attributes_of(place.element)) {
        const std::string_view name = document(place).string(attribute.name);
        if (name == "name" || name.starts_with('_') || (long_form && name == "ID")) { continue; }
        if (const Port* port = type.find(name); port != nullptr) {
            leaf_port(place, *port, attribute);
        }
    }
    const RowId n =
        builder_.open(type.synchronous ? Op::condition : Op::action, place.parent,
                      instance_name(place), document(place).at(place.element).where, call);
    if (!n) { return; }
    conditions(place, n);
    if (type.most_children != 0) { children_of(place, n); }
    builder_.close(n);
}

// A {key} shares a variable of the port's type; anything else is a literal.
void TreeCompiler::leaf_port(const Place& place, const Port& port, const Attribute& attribute) {
    const std::string_view value = document(place).string(attribute.value);
    if (!is_pointer(value)) {
        const bool json = port.type == PortType::any && is_json_literal(value);
        if (port.direction == PortDirection::input && json) {
            builder_.set_literal(port, json_literal(builder_, text_of(place, attribute)));
        } else if (port.direction == PortDirection::input) {
            builder_.set_literal(port, value);
        }
        return;
    }
    const SlotId slot = scopes_.variable(place.scope, pointer_key(value, port.name));
    declare(slot, port.type, attribute.value_where);
    if (port.direction != PortDirection::output) {
        builder_.set_live(port, builder_.variable(slot, Dialect::tree));
        const bool may_be_absent = port.present != Port::always || port.type == PortType::any;
        if (!may_be_absent) { scopes_.needed(slot, attribute.value_where, next_row()); }
    }
    if (port.direction != PortDirection::input) {
        builder_.set_output(port, slot);
        scopes_.written(slot);
    }
}

void TreeCompiler::conditions(const Place& place, RowId n) {
    static constexpr std::pair<std::string_view, CodeId Conditions::*> all[] = {
        {"_failureIf", &Conditions::failure_if}, {"_successIf", &Conditions::success_if},
        {"_skipIf", &Conditions::skip_if},       {"_while", &Conditions::while_true},
        {"_onSuccess", &Conditions::on_success}, {"_onFailure", &Conditions::on_failure},
        {"_onHalted", &Conditions::on_halted},   {"_post", &Conditions::post},
    };
    const auto attributes = document(place).attributes_of(place.element);
    if (std::none_of(attributes.begin(), attributes.end(), [&](const Attribute& attribute) {
            return document(place).string(attribute.name).starts_with('_');
        })) {
        return;
    }
    Conditions found;
    for (const auto& [name, member] : all) {
        const Attribute* attribute = document(place).find(place.element, name);
        if (attribute == nullptr || attribute->value.size == 0) { continue; }
        // halting the whole tree runs this one for nodes that were never ticked, too
        const RowId turn = name == "_onHalted" ? RowId() : n;
        found.*member = compiled(place, text_of(place, *attribute), turn);
    }
    if (found == Conditions()) { return; }
    builder_.program.rows[n.index].conditional = true;
    builder_.program.conditions.emplace_back(n, found);
}

// Subtrees ----------------------------------------------------------------------------------------

void TreeCompiler::subtree(const Place& place) {
    const Attribute* id = document(place).find(place.element, "ID");
    if (id == nullptr) { return; }
    const std::string_view name = document(place).string(id->value);
    const TreeSource* tree = files_.find(name);
    if (tree == nullptr) {
        builder_.diagnostics().error("unknown-tree", id->value_where,
                                     "there is no tree \"" + std::string(name) + "\"" +
                                         suggestion(name, files_.ids()));
        return;
    }
    if (is_recursive(tree->id, id->value_where)) { return; }
    const std::string path =
        builder_.substitutions != nullptr ? path_of(place, name) + '/' : std::string();
    const RowId n = builder_.open(Op::subtree, place.parent, instance_name(place),
                                  document(place).at(place.element).where);
    if (!n) { return; }
    conditions(place, n);
    if (const Attribute* own = document(place).find(place.element, "name");
        own != nullptr && !scopes_.take_name(place.scope, document(place).string(own->value))) {
        builder_.diagnostics().error("duplicate-id", own->value_where,
                                     "there is already a subtree called \"" +
                                         std::string(document(place).string(own->value)) +
                                         "\" in this tree");
    }
    const ScopeId inside = scopes_.add(n, place.scope);
    if (builder_.substitutions != nullptr) {
        paths_.resize(inside.index + 1);
        paths_.back() = path;
    }
    parameters(place, inside, files_.model(name));
    reached_.insert(tree->id);
    expanding_.push_back(tree->id);
    children_of({tree->file, tree->element, inside, n}, n);
    expanding_.pop_back();
    builder_.close(n);
    find_unused(place, inside, files_.model(name));
}

// The attributes of a <SubTree> that mean nothing in the tree, nor in what its model says.
void TreeCompiler::find_unused(const Place& place, ScopeId inside,
                               const std::vector<SubtreePort>* model) {
    const Document& doc = document(place);
    for (const Attribute& attribute : doc.attributes_of(place.element)) {
        const std::string_view name = doc.string(attribute.name);
        if (name == "ID" || name == "name" || name.starts_with('_')) { continue; }
        if (scopes_.is_used(inside, name)) { continue; }
        std::vector<std::string_view> known = scopes_.names(inside);
        if (model != nullptr) {
            const auto is_this = [&](const SubtreePort& port) { return port.name == name; };
            if (std::any_of(model->begin(), model->end(), is_this)) { continue; }
            for (const SubtreePort& port : *model) {
                known.push_back(port.name);
            }
        }
        if (!known_unused_.insert(&attribute).second) { continue; }
        const auto is_given = [&](std::string_view other) {
            return doc.find(place.element, other) != nullptr;
        };
        known.erase(std::remove_if(known.begin(), known.end(), is_given), known.end());
        unused_.push_back({attribute.where,
                           "nothing in the tree \"" + std::string(doc.value(place.element, "ID")) +
                               "\" uses \"" + std::string(name) + '"' + suggestion(name, known)});
    }
}

bool TreeCompiler::is_recursive(std::string_view id, Where where) {
    const auto again = std::find(expanding_.begin(), expanding_.end(), id);
    if (again == expanding_.end()) { return false; }
    std::string chain;
    for (auto at = again; at != expanding_.end(); ++at) {
        chain += std::string(*at) + " uses ";
    }
    builder_.diagnostics().error("tree-recursion", where,
                                 "a tree cannot contain itself: " + chain + std::string(id));
    return true;
}

// The attributes of a <SubTree>, and what its model adds to them (TREES §2.3).
void TreeCompiler::parameters(const Place& place, ScopeId inside,
                              const std::vector<SubtreePort>* model) {
    const Document& doc = document(place);
    const std::string_view autoremap = doc.value(place.element, "_autoremap");
    const bool remaps_all =
        autoremap == "1" || autoremap == "true" || autoremap == "True" || autoremap == "TRUE";
    for (const Attribute& attribute : doc.attributes_of(place.element)) {
        const std::string_view name = doc.string(attribute.name);
        if (name == "ID" || name == "name" || name.starts_with('_')) { continue; }
        const std::string_view value = doc.string(attribute.value);
        if (is_json_literal(value)) {
            local(inside, name, json_literal(builder_, text_of(place, attribute)),
                  attribute.value_where);
        } else {
            parameter(inside, name, value, attribute.value_where);
        }
    }
    // with _autoremap what is not given is shared, even if it has a default
    if (model != nullptr && !remaps_all) {
        for (const SubtreePort& port : *model) {
            if (doc.find(place.element, port.name) != nullptr) { continue; }
            if (port.has_initial) {
                parameter(inside, port.name, port.initial, port.where);
            } else {
                builder_.diagnostics().error("missing-parameter", doc.at(place.element).where,
                                             "the tree \"" +
                                                 std::string(doc.value(place.element, "ID")) +
                                                 "\" needs the parameter \"" + port.name + "\"");
            }
        }
    }
    if (remaps_all) { scopes_.autoremap(inside); }
}

// {key} shares a variable with the scope around; a literal is a variable of the subtree itself.
void TreeCompiler::parameter(ScopeId inside, std::string_view name, std::string_view value,
                             Where where) {
    if (is_pointer(value)) {
        scopes_.remap(inside, name, pointer_key(value, name));
        return;
    }
    local(inside, name, literal_value(value), where);
}

void TreeCompiler::local(ScopeId inside, std::string_view name, Value value, Where where) {
    const SlotId slot = scopes_.local(inside, name);
    types_.begins(slot, value, where);
    builder_.set_initial(slot, std::move(value));
    scopes_.written(slot);
}

// Entrances ---------------------------------------------------------------------------------------

void compile_tree(ReadFile file, Builder& builder) {
    builder.reserve(file.document.elements.size());
    TreeFiles files(builder);
    files.add(std::move(file));
    InvokedMachines machines(builder);
    TreeCompiler compiler(builder, files, machines);
    if (const TreeSource* main = files.main_tree(builder.options().main_tree); main != nullptr) {
        compiler.tree(*main, {});
        compiler.finish();
        // who names another main tree uses the file in more than one way
        if (builder.options().main_tree.empty()) { compiler.report_unused_trees(*main); }
    }
    compiler.check_unreached();
    machines.compile();
}

}  // namespace trellis
