// trellis convert: from one spelling of a document to the other, or to the canonical form of its
// own.
// SPDX-License-Identifier: MIT
#include "load/json.h"
#include "load/load.h"
#include "load/xml.h"
#include "runner/choice.h"
#include "runner/commands.h"

#include <CLI/CLI.hpp>

namespace trellis {

namespace {

/// The spelling that a file's name asks for; none for names that do not tell.
std::optional<Document::Spelling> spelling_of(std::string_view path) {
    if (path.ends_with(".json")) { return Document::Spelling::json; }
    if (path.ends_with(".xml") || path.ends_with(".scxml")) { return Document::Spelling::xml; }
    return {};
}

/// Whether reading `text` gives the document that it was written from.
bool says_the_same(const Document& document, FileKind kind, Document::Spelling spelling,
                   const std::string& text) {
    Diagnostics diagnostics;
    const std::optional<Document> again = read({"", text}, diagnostics);
    if (!again || !diagnostics.ok()) { return false; }
    return spelling == Document::Spelling::xml ? same_content(*again, document)
                                               : same_content(*again, canonical(document, kind));
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
    const FileKind kind = *file_kind(*document);
    const std::string text =
        *to == Document::Spelling::xml ? write_xml(*document) : write_json(*document, kind);
    if (!says_the_same(*document, kind, *to, text)) {
        return complain(streams, Exit::internal,
                        "internal error: the converted text would not mean the same; nothing was "
                        "written");
    }
    return write_text(arguments.out, text, streams) ? Exit::yes : Exit::file;
}

}  // namespace trellis
