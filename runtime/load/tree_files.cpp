// Includes, trees and models of tree_files.h.
// SPDX-License-Identifier: MIT
#include "load/tree_files.h"

#include "core/program.h"
#include "load/check.h"
#include "load/grammar.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace trellis {

void TreeFiles::add(ReadFile file) {
    including_.push_back(file.name);
    const ReadFile& kept = files_.emplace_back(std::move(file));
    const auto rest = [](std::uint32_t limit, std::size_t used) {
        return limit - static_cast<std::uint32_t>(std::min<std::size_t>(limit, used));
    };
    left_.elements = rest(left_.elements, kept.document.elements.size());
    left_.attributes = rest(left_.attributes, kept.document.attributes.size());
    if (!kept.document.empty()) {
        for (const ElementId e : kept.document.children(kept.document.root())) {
            add_element(kept, e);
        }
    }
    including_.pop_back();
}

void TreeFiles::add_element(const ReadFile& file, ElementId e) {
    const std::string_view name = file.document.name(e);
    if (name == "include") {
        add_include(file, e);
    } else if (name == "BehaviorTree") {
        add_tree(file, e);
    } else if (name == "TreeNodesModel") {
        add_models(file, e);
    }
}

void TreeFiles::add_include(const ReadFile& file, ElementId e) {
    const Attribute* path = file.document.find(e, "path");
    if (path == nullptr || includes_end_) { return; }
    const std::string_view name = file.document.string(path->value);
    Diagnostics& diagnostics = builder_.diagnostics();
    std::optional<Source> source;
    if (builder_.options().reader != nullptr) {
        source =
            builder_.options().reader->read(name, file.name, file.document.value(e, "ros_pkg"));
    }
    if (!source) {
        diagnostics.error("unreadable-file", path->value_where,
                          "cannot read \"" + std::string(name) + "\"");
        return;
    }
    if (!take_include(*source, path->value_where)) { return; }
    const auto again = std::find(including_.begin(), including_.end(), source->name);
    if (again != including_.end()) {
        std::string chain;
        for (auto at = again; at != including_.end(); ++at) {
            chain += *at + " includes ";
        }
        diagnostics.error("include-cycle", path->value_where, chain + source->name);
        return;
    }
    // a file that is included twice is the same file
    const bool known = std::any_of(files_.begin(), files_.end(), [&](const ReadFile& other) {
        return other.name == source->name;
    });
    if (known) { return; }
    LoadOptions options = builder_.options();
    options.limits.elements = left_.elements;
    options.limits.attributes = left_.attributes;
    std::string included = source->name;
    std::optional<Document> document = read(std::move(*source), diagnostics, options);
    if (!document) { return; }
    check(*document, builder_.grammar(), diagnostics);
    add({std::move(included), std::move(*document)});
}

// Why a file that is known counts again: to know it, it was read.
bool TreeFiles::take_include(const Source& source, Where where) {
    const LoadOptions& options = builder_.options();
    includes_end_ = ++includes_ > options.includes || source.text.size() > left_.bytes;
    if (!includes_end_) {
        left_.bytes -= source.text.size();
        return true;
    }
    const bool many = includes_ > options.includes;
    builder_.diagnostics().error(
        "too-large", where,
        "the included files are more than " +
            (many ? std::to_string(options.includes)
                  : std::to_string(options.limits.bytes) + " bytes in all"));
    return false;
}

void TreeFiles::add_tree(const ReadFile& file, ElementId e) {
    std::string id(file.document.value(e, "ID"));
    Diagnostics& diagnostics = builder_.diagnostics();
    if (id.empty()) {
        const Document& document = file.document;
        const ElementId root = document.root();
        const auto is_tree = [&](ElementId c) { return document.name(c) == "BehaviorTree"; };
        std::size_t trees = 0;
        for (const ElementId c : document.children(root)) {
            trees += is_tree(c) ? 1U : 0U;
        }
        if (trees > 1) {
            diagnostics.error("missing-id", document.at(e).where,
                              "a BehaviorTree needs an ID where a file has several");
        }
    }
    if (const TreeSource* other = find(id); other != nullptr && !id.empty()) {
        const Where where = other->file->document.at(other->element).where;
        diagnostics.warning("duplicate-id", file.document.at(e).where,
                            "there is already a tree \"" + id + "\" in " + other->file->name +
                                ", line " + std::to_string(where.line) + "; this one runs");
        TreeSource& replaced = *std::find_if(trees_.begin(), trees_.end(),
                                             [&](const TreeSource& tree) { return tree.id == id; });
        replaced.file = &file;
        replaced.element = e;
        return;
    }
    // a tree may be called like a leaf of the host: a SubTree names trees only
    const OpTable ops = op_table();
    if (!id.empty() &&
        std::any_of(ops.begin(), ops.end(), [&](const OpInfo& op) { return op.element == id; })) {
        diagnostics.error("duplicate-id", file.document.find(e, "ID")->value_where,
                          "there is already a node \"" + id + "\"");
        return;
    }
    const TreeSource& tree = trees_.emplace_back(TreeSource{&file, e, std::move(id)});
    by_id_.emplace(tree.id, &tree);
}

void TreeFiles::add_models(const ReadFile& file, ElementId e) {
    const Document& document = file.document;
    for (const ElementId model : document.children(e)) {
        if (document.name(model) != "SubTree") { continue; }
        std::vector<SubtreePort>& ports = models_[std::string(document.value(model, "ID"))];
        for (const ElementId port : document.children(model)) {
            if (!document.name(port).ends_with("_port")) { continue; }
            ports.push_back({std::string(document.value(port, "name")),
                             std::string(document.value(port, "default")),
                             document.find(port, "default") != nullptr, document.at(port).where});
        }
    }
}

const TreeSource* TreeFiles::main_tree(std::string_view named) {
    const ReadFile& file = files_.front();
    const ElementId root = file.document.root();
    Diagnostics& diagnostics = builder_.diagnostics();
    const Attribute* said = file.document.find(root, "main_tree_to_execute");
    Where where = file.document.at(root).where;
    if (named.empty() && said != nullptr) {
        named = file.document.string(said->value);
        where = said->value_where;
    }
    if (!named.empty()) {
        const TreeSource* tree = find(named);
        if (tree == nullptr) {
            diagnostics.error("unknown-tree", where,
                              "there is no tree \"" + std::string(named) + "\"" +
                                  suggestion(named, ids()));
        }
        return tree;
    }
    const TreeSource* only = nullptr;
    for (const TreeSource& tree : trees_) {
        if (tree.file != &file) { continue; }
        if (only != nullptr) {
            diagnostics.error("no-main-tree", where,
                              "main_tree_to_execute must say which of the trees runs");
            return nullptr;
        }
        only = &tree;
    }
    if (only == nullptr) {
        diagnostics.error("no-main-tree", where, "this file has no BehaviorTree to run");
    }
    return only;
}

const TreeSource* TreeFiles::find(std::string_view id) const {
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? nullptr : found->second;
}

std::vector<std::string_view> TreeFiles::ids() const {
    std::vector<std::string_view> ids;
    for (const TreeSource& tree : trees_) {
        ids.emplace_back(tree.id);
    }
    return ids;
}

const std::vector<SubtreePort>* TreeFiles::model(std::string_view id) const {
    const auto found = models_.find(std::string(id));
    return found == models_.end() ? nullptr : &found->second;
}

}  // namespace trellis
