// trellis fmt: each file in its own spelling, evenly laid out.
// SPDX-License-Identifier: MIT
#include "runner/commands.h"
#include "runner/respelled.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <ostream>

namespace trellis {

namespace {

/// One file. What is right already is not written, so that its time of change stays.
Exit format(const std::string& file, bool check, Streams& streams) {
    const std::optional<std::string> text = read_text(file, streams, DocumentLimits().bytes);
    if (!text) { return Exit::file; }
    Exit exit = Exit::yes;
    const std::optional<Document> document =
        parse_document({shown_name(file), *text}, streams, exit);
    if (!document) { return exit; }
    const std::optional<std::string> even =
        respelled(*document, *file_kind(*document), document->spelling);
    if (!even) { return complain(streams, Exit::internal, respelling_failed); }
    if (check) {
        if (*even == *text) { return Exit::yes; }
        streams.out << shown_name(file) << '\n';
        return Exit::no;
    }
    if (*even == *text && file != "-") { return Exit::yes; }
    return write_text(file, *even, streams) ? Exit::yes : Exit::file;
}

}  // namespace

void add_options(CLI::App& app, FmtArguments& arguments) {
    app.add_option("FILE", arguments.files,
                   "tree and machine files, written in place; - is standard input and output")
        ->required();
    app.add_flag("--check", arguments.check,
                 "write nothing; print the files that are not laid out so");
}

Exit execute(const FmtArguments& arguments, Streams& streams) {
    Exit exit = Exit::yes;
    for (const std::string& file : arguments.files) {
        exit = std::max(exit, format(file, arguments.check, streams));
    }
    return exit;
}

}  // namespace trellis
