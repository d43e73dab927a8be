// trellis trace convert: a recorded run for the viewers of others.
// SPDX-License-Identifier: MIT
#include "runner/choice.h"
#include "runner/chrome_trace.h"
#include "runner/commands.h"
#include "runner/groot_log.h"
#include "runner/recording.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace trellis {

namespace {

using To = TraceConvertArguments::To;

/// The format that a file's name asks for; none for names that do not tell.
std::optional<To> format_of(std::string_view path) {
    if (path.ends_with(".json")) { return To::chrome; }
    if (path.ends_with(".btlog")) { return To::btlog; }
    return {};
}

/// The documents of the files that the behaviour was read from, by index; empty for what is none.
std::vector<Document> documents_of(const Behaviour& behaviour) {
    std::vector<Document> documents;
    for (std::uint32_t i = 0; i < behaviour.diagnostics.file_count(); ++i) {
        const std::string_view text = behaviour.diagnostics.file_text(i);
        Diagnostics diagnostics;
        std::optional<Document> document = read({{}, std::string(text)}, diagnostics);
        documents.push_back(document ? std::move(*document) : Document());
    }
    return documents;
}

Exit write_groot_log(const TraceConvertArguments& arguments, const Recording& recording,
                     const Behaviour& behaviour, const Registry& registry, Streams& streams) {
    const Program& program = *behaviour.program;
    if (program.is_machine()) {
        return complain(streams, Exit::no,
                        "a .btlog is of a tree: " + behaviour.name +
                            " is a machine; --to chrome takes both");
    }
    const std::size_t nodes = program.rows.size() - 1;
    if (nodes > most_groot_nodes) {
        return complain(streams, Exit::no,
                        "a .btlog numbers at most " + std::to_string(most_groot_nodes) +
                            " nodes, with 16 bits: " + behaviour.name + " has " +
                            std::to_string(nodes));
    }
    const std::vector<Document> documents = documents_of(behaviour);
    const std::string xml = groot_xml(program, documents, registry);
    const std::string log = groot_log(recording, xml, std::llround(arguments.start * 1e6));
    return write_text(arguments.out, log, streams) ? Exit::yes : Exit::file;
}

}  // namespace

void add_options(CLI::App& app, TraceConvertArguments& arguments) {
    app.add_option("IN", arguments.in, "a trace, as trellis run --trace FILE.jsonl writes it, or -")
        ->required();
    app.add_option("OUT", arguments.out, "the file to write; - is standard output")->required();
    add_choice<std::optional<To>>(
        app, "--to", arguments.to, {{"chrome", To::chrome}, {"btlog", To::btlog}},
        "for chrome://tracing and Perfetto (.json), or for Groot2 (.btlog)");
    app.add_option("--behaviour", arguments.behaviour,
                   "the file that ran, if it is no longer where the trace says")
        ->type_name("FILE");
    app.add_option("--start", arguments.start,
                   "when the run began, in seconds since 1970; 0 if not given")
        ->type_name("S")
        ->check(CLI::Range(0.0, 1e11));
    add_options(app, arguments.load);
}

Exit execute(const TraceConvertArguments& arguments, Streams& streams) {
    const std::optional<To> to = arguments.to ? arguments.to : format_of(arguments.out);
    if (!to) {
        return complain(streams, Exit::usage,
                        "the name \"" + arguments.out +
                            "\" does not say what to write: give --to chrome or --to btlog");
    }
    RoombaRegistry registry;
    Exit exit = Exit::yes;
    const std::optional<Recording> recording = load_recording(arguments.in, streams, exit);
    if (!recording) { return exit; }
    const std::string& file = arguments.behaviour.empty() ? recording->file : arguments.behaviour;
    if (file == "-") {
        return complain(streams, Exit::usage,
                        "the behaviour was read from standard input: name it with --behaviour");
    }
    const auto behaviour = load_recorded(file, arguments.load, *recording, registry, streams, exit);
    if (!behaviour) { return exit; }
    if (*to == To::btlog) {
        return write_groot_log(arguments, *recording, *behaviour, registry, streams);
    }
    const std::string text = chrome_trace(*recording, *behaviour->program, arguments.start);
    return write_text(arguments.out, text, streams) ? Exit::yes : Exit::file;
}

}  // namespace trellis
