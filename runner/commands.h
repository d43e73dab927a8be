// The commands of the program, each as its arguments, the options that fill them in, and a function
// that runs it with given streams. The table of commands is in command_line.cpp. Each command has
// its own source file and test of the same name.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/behaviour.h"
#include "runner/episode_arguments.h"
#include "runner/streams.h"

#include <string>
#include <vector>

namespace trellis {

/// --format: how the result is written.
enum class Format : std::uint8_t { text, json };

/// Adds --format to a command.
void add_format(CLI::App& app, Format& format);

/// trellis run: drives the robot with a behaviour and says what happened.
struct RunArguments {
    std::string file;
    LoadArguments load;
    EpisodeArguments episode;
    std::vector<std::string> traces;  ///< by extension: .csv (and "-") or .jsonl
    std::string svg;                  ///< empty: none
    bool log = false;
    bool no_world = false;  ///< --world none: no robot; prints "final: ID"
    Format format = Format::text;
};
void add_options(CLI::App& app, RunArguments& arguments);
/// Yes; no if the file is invalid or the behaviour failed, and without a world also if no final
/// state was reached.
Exit execute(const RunArguments& arguments, Streams& streams);

/// trellis validate: says everything that is wrong with some files.
struct ValidateArguments {
    std::vector<std::string> files;
    LoadArguments load;
    Format format = Format::text;
};
void add_options(CLI::App& app, ValidateArguments& arguments);
/// Yes if all files are valid.
Exit execute(const ValidateArguments& arguments, Streams& streams);

}  // namespace trellis
