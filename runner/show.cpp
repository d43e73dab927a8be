// trellis show: pictures of a behaviour file.
// SPDX-License-Identifier: MIT
#include "runner/commands.h"
#include "runner/drawing/drawing.h"

#include <CLI/CLI.hpp>

#include <ostream>
#include <utility>

namespace trellis {

namespace {

Exit show_program(const ShowArguments& arguments, const Registry& registry, Streams& streams) {
    Exit exit = Exit::yes;
    const LoadArguments load{.main_tree = arguments.main_tree, .set = {}, .packages = {}};
    const auto behaviour = load_behaviour(arguments.file, load, registry, streams, exit);
    if (behaviour) { streams.out << dump(*behaviour->program); }
    return exit;
}

}  // namespace

void add_options(CLI::App& app, ShowArguments& arguments) {
    app.add_option("FILE", arguments.file, "the behaviour: a tree or machine file, or -")
        ->required();
    app.add_option("--svg", arguments.svg, "draw it into a file; - is standard output")
        ->type_name("FILE");
    app.add_option("--dot", arguments.dot, "write it for Graphviz; - is standard output")
        ->type_name("FILE");
    app.add_flag("--text", arguments.text, "print it as text, as without --svg and --dot");
    app.add_flag("--ascii", arguments.ascii, "text of ASCII characters only");
    app.add_flag("--sideways", arguments.sideways, "draw a tree from left to right");
    app.add_option("--tree", arguments.main_tree, "the tree to draw first, of a file with several")
        ->type_name("ID");
    app.add_flag("--program", arguments.program, "print the compiled program instead")
        ->excludes("--svg", "--dot", "--text", "--ascii");
}

Exit execute(const ShowArguments& arguments, Streams& streams) {
    const RoombaRegistry registry;
    if (arguments.program) { return show_program(arguments, registry, streams); }
    Exit exit = Exit::yes;
    const std::optional<Document> document = load_document(arguments.file, streams, exit);
    if (!document) { return exit; }
    const DrawingOptions options{.ascii = arguments.ascii,
                                 .main_tree = arguments.main_tree,
                                 .sideways = arguments.sideways,
                                 .registry = &registry};
    const std::pair<const std::string&, DrawingFormat> pictures[] = {
        {arguments.svg, DrawingFormat::svg}, {arguments.dot, DrawingFormat::dot}};
    for (const auto& [path, format] : pictures) {
        if (!path.empty() && !write_text(path, draw(*document, format, options), streams)) {
            return Exit::file;
        }
    }
    if (arguments.text || arguments.ascii || (arguments.svg.empty() && arguments.dot.empty())) {
        streams.out << draw(*document, DrawingFormat::text, options);
    }
    return Exit::yes;
}

}  // namespace trellis
