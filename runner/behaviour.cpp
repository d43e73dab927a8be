// The options, the reader of included files, and loading with messages.
// SPDX-License-Identifier: MIT
#include "runner/behaviour.h"

#include "sim/bridge/leaves.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace trellis {

namespace {

/// "name=value" in two; the text was checked when the command line was read.
std::pair<std::string, std::string> split(const std::string& text) {
    const std::size_t at = text.find('=');
    return {text.substr(0, at), text.substr(at + 1)};
}

const CLI::Validator name_and_value(
    [](const std::string& text) {
        const std::size_t at = text.find('=');
        return at != std::string::npos && at != 0 ? std::string()
                                                  : "expected name=value, found \"" + text + "\"";
    },
    "", "name_and_value");

}  // namespace

void add_options(CLI::App& app, LoadArguments& arguments) {
    app.add_option("--tree", arguments.main_tree, "the tree to run, of a file with several")
        ->type_name("ID");
    app.add_option("--set", arguments.set,
                   "give a variable its first value: of the main tree, or a <data> of a machine; "
                   "\"path/name\" inside a subtree")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->check(name_and_value);
    app.add_option("--ros-pkg", arguments.packages, "the folder that an include's ros_pkg means")
        ->type_name("NAME=FOLDER")
        ->allow_extra_args(false)
        ->check(name_and_value);
    app.add_option("--nodes", arguments.nodes,
                   "take the leaves that the TreeNodesModel of a file declares as known")
        ->type_name("FILE")
        ->allow_extra_args(false);
    app.add_option("--mock", arguments.mock,
                   "put other nodes in the place of some, as the rules in a JSON file say")
        ->type_name("RULES");
}

RoombaRegistry::RoombaRegistry() {
    register_roomba(*this);
}

FileReader::FileReader(const LoadArguments& arguments, Files& files) : files_(files) {
    for (const std::string& package : arguments.packages) {
        packages_.push_back(split(package));
    }
}

std::optional<Source> FileReader::read(std::string_view path, std::string_view from,
                                       std::string_view package) {
    namespace fs = std::filesystem;
    fs::path folder = fs::path(from).parent_path();
    if (!package.empty()) {
        bool known = false;
        for (const auto& [name, place] : packages_) {
            if (name == package) {
                folder = place;
                known = true;
            }
        }
        if (!known) { return {}; }
    }
    const std::string file = (folder / fs::path(path)).lexically_normal().string();
    std::string why;
    std::optional<std::string> text = files_.read(file, DocumentLimits().bytes, why);
    if (!text) { return {}; }
    return Source{file, std::move(*text)};
}

std::optional<Behaviour> compile_behaviour(Source source, const LoadArguments& arguments,
                                           const Registry& registry, Streams& streams) {
    Behaviour behaviour{source.name, {}};
    FileReader reader(arguments, streams.files);
    LoadOptions options{.reader = &reader, .main_tree = arguments.main_tree};
    for (const std::string& given : arguments.set) {
        options.given.push_back(split(given));
    }
    Source rules{shown_name(arguments.mock), {}};
    if (!arguments.mock.empty()) {
        std::optional<std::string> text =
            read_text(arguments.mock, streams, DocumentLimits().bytes);
        if (!text) { return {}; }
        rules.text = std::move(*text);
        options.substitutions = &rules;
    }
    behaviour.program = load(std::move(source), registry, behaviour.diagnostics, options);
    return behaviour;
}

std::optional<Document> load_document(const std::string& file, Streams& streams, Exit& exit) {
    exit = Exit::file;
    std::optional<std::string> text = read_text(file, streams, DocumentLimits().bytes);
    if (!text) { return {}; }
    return parse_document({shown_name(file), std::move(*text)}, streams, exit);
}

std::optional<Document> parse_document(Source source, Streams& streams, Exit& exit) {
    Diagnostics diagnostics;
    const std::string name = source.name;
    std::optional<Document> document = read(std::move(source), diagnostics);
    diagnostics.sort();
    show(diagnostics, streams);
    exit = Exit::no;
    if (!document || !diagnostics.ok()) { return {}; }
    if (!file_kind(*document)) {
        complain(streams, exit,
                 name + " is neither a tree file, with the root element <root>, nor a "
                        "machine, with the root element <scxml>");
        return {};
    }
    exit = Exit::yes;
    return document;
}

std::string shown_name(const std::string& file) {
    return file == "-" ? "standard input" : file;
}

}  // namespace trellis
