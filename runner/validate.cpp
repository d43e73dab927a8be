// trellis validate: all findings about all files.
// SPDX-License-Identifier: MIT
#include "runner/commands.h"
#include "runner/json_writer.h"

#include <CLI/CLI.hpp>

#include <ostream>

namespace trellis {

namespace {

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

void add_file(JsonWriter& json, const Behaviour& behaviour) {
    json.begin_object().text("file", behaviour.source.name);
    json.boolean("ok", behaviour.program.has_value());
    if (behaviour.program) {
        json.text("kind", behaviour.program->is_machine() ? "machine" : "tree");
        json.count("nodes", node_count(*behaviour.program));
    }
    json.begin_array("diagnostics");
    for (const Diagnostic& d : behaviour.diagnostics.all()) {
        add_finding(json, behaviour.diagnostics, d);
    }
    json.end_array().end_object();
}

}  // namespace

void add_options(CLI::App& app, ValidateArguments& arguments) {
    app.add_option("FILE", arguments.files, "tree and machine files; - is standard input")
        ->required();
    add_options(app, arguments.load);
    add_format(app, arguments.format);
}

Exit execute(const ValidateArguments& arguments, Streams& streams) {
    const RoombaRegistry registry;
    Exit exit = Exit::yes;
    JsonWriter json;
    json.begin_object().begin_array("files");
    for (const std::string& file : arguments.files) {
        const std::optional<Behaviour> behaviour =
            read_behaviour(file, arguments.load, registry, streams);
        if (!behaviour) {
            exit = Exit::file;
            continue;
        }
        if (!behaviour->program && exit == Exit::yes) { exit = Exit::no; }
        if (arguments.format == Format::json) {
            add_file(json, *behaviour);
            continue;
        }
        show(behaviour->diagnostics, streams);
        if (behaviour->program) {
            const std::size_t nodes = node_count(*behaviour->program);
            streams.out << behaviour->source.name << ": ok, " << nodes
                        << (nodes == 1 ? " node\n" : " nodes\n");
        }
    }
    json.end_array().boolean("ok", exit == Exit::yes).end_object();
    if (arguments.format == Format::json) { streams.out << std::move(json).finish(); }
    return exit;
}

}  // namespace trellis
