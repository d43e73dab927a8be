// trellis validate: all findings about all files.
// SPDX-License-Identifier: MIT
#include "load/check.h"
#include "load/grammar.h"
#include "runner/commands.h"
#include "runner/declarations.h"
#include "runner/json_writer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <ostream>
#include <set>
#include <utility>

namespace trellis {

namespace {

/// The leaves that the program uses and that are only declared, each once.
std::set<std::string> declared_leaves(const Program& program) {
    std::set<std::string> names;
    for (const LeafCall& call : program.calls) {
        if (is_declared(*call.type)) { names.insert(call.type->name); }
    }
    return names;
}

/// Rows a document wrote; the outermost row is the file itself.
std::size_t node_count(const Program& program) {
    return program.rows.size() - 1;
}

void add_finding(JsonWriter& json, const Diagnostics& diagnostics, const Diagnostic& d) {
    json.begin_object().text("file", diagnostics.file_name(d.where.file));
    if (d.where.line != 0) { json.count("line", d.where.line).count("column", d.where.column); }
    json.text("severity", d.severity == Diagnostic::Severity::error ? "error" : "warning");
    json.text("id", d.id).text("message", d.message).end_object();
}

/// A file that was validated.
struct Validated {
    Behaviour behaviour;
    std::size_t declarations = 0;  ///< of a palette
    bool palette = false;

    bool ok() const { return palette ? behaviour.diagnostics.ok() : behaviour.program.has_value(); }
};

// A file that is only a palette has nothing to compile.
Validated validated(Behaviour behaviour, const Registry& registry) {
    const std::vector<Diagnostic>& found = behaviour.diagnostics.all();
    const bool may_be = std::any_of(found.begin(), found.end(),
                                    [](const Diagnostic& d) { return d.id == "no-main-tree"; });
    if (!may_be) { return {std::move(behaviour)}; }
    Diagnostics diagnostics;
    const std::optional<Document> document = read(behaviour.source(), diagnostics);
    if (!document || !is_palette(*document)) { return {std::move(behaviour)}; }
    check(*document, tree_grammar(registry), diagnostics);
    diagnostics.sort();
    Validated result{{std::move(behaviour.name), {}, std::move(diagnostics)}};
    result.palette = true;
    for (const ElementId models : document->children(document->root())) {
        result.declarations += document->child_count(models);
    }
    return result;
}

void add_file(JsonWriter& json, const Validated& validated) {
    const Behaviour& behaviour = validated.behaviour;
    json.begin_object().text("file", behaviour.name).boolean("ok", validated.ok());
    if (validated.palette) {
        json.text("kind", "palette").count("nodes", validated.declarations);
    } else if (behaviour.program) {
        json.text("kind", behaviour.program->is_machine() ? "machine" : "tree");
        json.count("nodes", node_count(*behaviour.program));
        json.begin_array("declared");
        for (const std::string& name : declared_leaves(*behaviour.program)) {
            json.element(name);
        }
        json.end_array();
    }
    json.begin_array("diagnostics");
    for (const Diagnostic& d : behaviour.diagnostics.all()) {
        add_finding(json, behaviour.diagnostics, d);
    }
    json.end_array().end_object();
}

/// "a.xml: ok, 3 nodes; declared only: Grasp, Release".
std::string summary(const Validated& validated) {
    const std::string& name = validated.behaviour.name;
    if (validated.palette) {
        return name + ": ok, a palette of " + std::to_string(validated.declarations) +
               (validated.declarations == 1 ? " node\n" : " nodes\n");
    }
    const Program& program = *validated.behaviour.program;
    const std::size_t nodes = node_count(program);
    std::string out = name + ": ok, " + std::to_string(nodes) + (nodes == 1 ? " node" : " nodes");
    std::string_view before = "; declared only: ";
    for (const std::string& leaf : declared_leaves(program)) {
        out += std::string(before) + leaf;
        before = ", ";
    }
    return out + '\n';
}

}  // namespace

void add_options(CLI::App& app, ValidateArguments& arguments) {
    app.add_option("FILE", arguments.files, "tree and machine files; - is standard input")
        ->required();
    add_options(app, arguments.load);
    add_format(app, arguments.format);
}

Exit execute(const ValidateArguments& arguments, Streams& streams) {
    Exit exit = Exit::yes;
    JsonWriter json;
    json.begin_object().begin_array("files");
    for (const std::string& file : arguments.files) {
        // what one file declares is not known in the next
        RoombaRegistry registry;
        Exit one = Exit::yes;
        std::optional<Behaviour> behaviour =
            read_declaring(file, arguments.load, registry, streams, one);
        if (!behaviour) {
            exit = std::max(exit, one);
            continue;
        }
        const Validated result = validated(std::move(*behaviour), registry);
        if (!result.ok()) { exit = std::max(exit, Exit::no); }
        if (arguments.format == Format::json) {
            add_file(json, result);
            continue;
        }
        show(result.behaviour.diagnostics, streams);
        if (result.ok()) { streams.out << summary(result); }
    }
    json.end_array().boolean("ok", exit == Exit::yes).end_object();
    if (arguments.format == Format::json) { streams.out << std::move(json).finish(); }
    return exit;
}

}  // namespace trellis
