// trellis convert: from one spelling of a document to the other, or to the canonical form of its
// own.
// SPDX-License-Identifier: MIT
#include "runner/choice.h"
#include "runner/commands.h"
#include "runner/respelled.h"

#include <CLI/CLI.hpp>

namespace trellis {

namespace {

/// The spelling that a file's name asks for; none for names that do not tell.
std::optional<Document::Spelling> spelling_of(std::string_view path) {
    if (path.ends_with(".json")) { return Document::Spelling::json; }
    if (path.ends_with(".xml") || path.ends_with(".scxml")) { return Document::Spelling::xml; }
    return {};
}

}  // namespace

void add_options(CLI::App& app, ConvertArguments& arguments) {
    app.add_option("IN", arguments.in, "the tree or machine file to read; - is standard input")
        ->required();
    app.add_option("OUT", arguments.out, "the file to write; - is standard output")->required();
    using Spelling = Document::Spelling;
    add_choice<std::optional<Spelling>>(app, "--to", arguments.to,
                                        {{"xml", Spelling::xml}, {"json", Spelling::json}},
                                        "the spelling, where the name of OUT does not tell it");
}

Exit execute(const ConvertArguments& arguments, Streams& streams) {
    const std::optional<Document::Spelling> to =
        arguments.to ? arguments.to : spelling_of(arguments.out);
    if (!to) {
        return complain(streams, Exit::usage,
                        "the name \"" + arguments.out +
                            "\" does not say what to write: give --to xml or --to json");
    }
    Exit exit = Exit::yes;
    const std::optional<Document> document = load_document(arguments.in, streams, exit);
    if (!document) { return exit; }
    const std::optional<std::string> text = respelled(*document, *file_kind(*document), *to);
    if (!text) { return complain(streams, Exit::internal, respelling_failed); }
    return write_text(arguments.out, *text, streams) ? Exit::yes : Exit::file;
}

}  // namespace trellis
