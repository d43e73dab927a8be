// The stages of loading, in order.
// SPDX-License-Identifier: MIT
#include "load/load.h"

#include "load/check.h"
#include "load/compile.h"
#include "load/grammar.h"
#include "load/json.h"
#include "load/leaf_places.h"
#include "load/machine_moves.h"
#include "load/substitutions.h"
#include "load/tree_checks.h"
#include "load/xml.h"

#include <utility>

namespace trellis {

namespace {

bool is_json(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

void give(Builder& builder) {
    Program& program = builder.program;
    for (const auto& [name, text] : builder.options().given) {
        std::vector<std::string> paths;
        SlotId found;
        for (std::uint32_t i = 0; i < program.slots.size(); ++i) {
            paths.push_back(path_of(program, program.slots[i]));
            if (paths.back() == name) { found = {i}; }
        }
        if (found) {
            builder.set_initial(found, literal_value(text));
            continue;
        }
        const std::vector<std::string_view> known(paths.begin(), paths.end());
        builder.diagnostics().error("unknown-variable", {},
                                    "there is no variable \"" + name + "\" to set" +
                                        suggestion(name, known));
    }
}

void check_and_compile(ReadFile file, Builder& builder) {
    if (kind_of(file.document) == FileKind::machine) {
        check(file.document, machine_grammar(), builder.diagnostics());
        compile_machine(std::move(file), builder);
    } else {
        check(file.document, builder.grammar(), builder.diagnostics());
        compile_tree(std::move(file), builder);
    }
}

void warn_of_unused(const Substitutions& rules, Diagnostics& diagnostics) {
    for (const SubstitutionRule& rule : rules.rules) {
        if (rule.used) { continue; }
        diagnostics.warning("substitution", rule.where,
                            "no node is replaced by the rule for \"" + rule.pattern + '"');
    }
}

/// What is found in a whole program.
void finish(Program& program) {
    place_leaves(program);
    find_moves(program);
}

}  // namespace

std::string path_of(const Program& program, const Slot& slot) {
    std::string path = slot.name;
    for (RowId n = slot.scope; n && program.at(n).op == Op::subtree;) {
        path.insert(0, program.names[n.index] + '/');
        do {
            n = program.at(n).parent;
        } while (program.at(n).op != Op::subtree && program.at(n).op != Op::tree);
    }
    return path;
}

FileKind kind_of(const Document& document) {
    const std::string_view root = document.name(document.root());
    const bool machine = closest(root, {"root", "scxml"}) == "scxml";
    return file_kind(document).value_or(machine ? FileKind::machine : FileKind::tree);
}

std::optional<Document> read(Source source, Diagnostics& diagnostics, const LoadOptions& options) {
    const std::uint32_t file =
        diagnostics.take_file(std::move(source.name), std::move(source.text));
    const std::string_view text = diagnostics.file_text(file);
    if (!is_json(text)) { return read_xml(text, file, diagnostics, options.limits); }
    const std::optional<JsonTree> json = parse_json(text, file, diagnostics, options.limits);
    if (!json) { return {}; }
    const std::optional<FileKind> kind = json_kind(*json);
    if (!kind) {
        diagnostics.structural_error(
            "wrong-root", json->at(json->root()).where,
            "expected a tree file, with \"trees\", or a machine file, with \"states\"");
        return {};
    }
    return document_from_json(*json, *kind, diagnostics, options.limits);
}

std::optional<Program> load(Source source, const Registry& registry, Diagnostics& diagnostics,
                            const LoadOptions& options) {
    std::optional<Program> program;
    std::string file = source.name;
    if (std::optional<Document> document = read(std::move(source), diagnostics, options);
        document) {
        Grammar trees = tree_grammar(registry);
        Builder builder(registry, trees, diagnostics, options);
        std::optional<Substitutions> rules;
        if (options.substitutions != nullptr) {
            const std::size_t before = diagnostics.errors();
            rules = read_substitutions(*options.substitutions, trees, diagnostics, options);
            if (diagnostics.errors() != before) {
                // what stands in the tree is not known without all of its rules
                diagnostics.sort();
                return {};
            }
            for (const SubstitutionRule& rule : rules->rules) {
                trees.replaced.push_back(rule.pattern);
            }
            builder.substitutions = &*rules;
        }
        check_and_compile({std::move(file), std::move(*document)}, builder);
        if (rules) { warn_of_unused(*rules, diagnostics); }
        give(builder);
        builder.name_enumerators();
        // rules replace nodes on purpose, and what an error leaves is no whole program
        if (diagnostics.ok() && !rules) {
            check_trees(builder.program, builder.unset, diagnostics);
            for (const Program& machine : builder.program.machines) {
                check_trees(machine, {}, diagnostics);
            }
        }
        program = std::move(builder.program);
    }
    diagnostics.sort();
    if (!diagnostics.ok()) { return {}; }
    finish(*program);
    for (Program& machine : program->machines) {
        finish(machine);
    }
    for (std::uint32_t i = 0; i < diagnostics.file_count(); ++i) {
        program->files.emplace_back(diagnostics.file_name(i));
    }
    return program;
}

}  // namespace trellis
