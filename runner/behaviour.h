// Loading a behaviour file for a command: the options that say which and how, the files it
// includes, the Roomba's leaves. Leaves of other robots are in declarations.h. Covered by
// tests/runner/behaviour_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "load/diagnostics.h"
#include "load/document.h"
#include "load/load.h"
#include "runner/streams.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

namespace trellis {

/// How behaviour files are loaded, whichever they are.
struct LoadArguments {
    std::string main_tree;              ///< --tree ID; empty: what the file says
    std::vector<std::string> set;       ///< --set name=value
    std::vector<std::string> packages;  ///< --ros-pkg NAME=FOLDER
    std::vector<std::string> nodes;     ///< --nodes FILE
    std::string mock;                   ///< --mock RULES; empty: none
};

/// Adds --tree, --set, --ros-pkg, --nodes and --mock to a command.
void add_options(CLI::App& app, LoadArguments& arguments);

/// The Roomba's leaves and sensors, as a value that a command keeps while its programs live.
class RoombaRegistry : public Registry {
public:
    RoombaRegistry();
};

/// The texts that a behaviour file refers to: relative to the file that names them, or to the
/// folder given for a package.
class FileReader : public SourceReader {
public:
    FileReader(const LoadArguments& arguments, Files& files);
    std::optional<Source> read(std::string_view path, std::string_view from,
                               std::string_view package) override;

private:
    std::vector<std::pair<std::string, std::string>> packages_;  // name, folder
    Files& files_;
};

/// A file as it was read and what became of it.
struct Behaviour {
    std::string name;                ///< as messages show it
    std::optional<Program> program;  ///< none if there are errors
    Diagnostics diagnostics = {};    ///< which has the text

    /// The file to read once more.
    Source source() const { return {name, std::string(diagnostics.file_text(0))}; }
};

/// Compiles what was read, with the files it includes and the rules of --mock; none, after a
/// message, if these cannot be read.
std::optional<Behaviour> compile_behaviour(Source source, const LoadArguments& arguments,
                                           const Registry& registry, Streams& streams);

/// The file as a document, before any check of what it means; none after messages.
std::optional<Document> load_document(const std::string& file, Streams& streams, Exit& exit);

/// The same of a text that was read.
std::optional<Document> parse_document(Source source, Streams& streams, Exit& exit);

/// How messages call a file: "standard input" for "-".
std::string shown_name(const std::string& file);

}  // namespace trellis
