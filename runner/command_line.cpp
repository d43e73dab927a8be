// The table of commands, and CLI11 behind it.
// SPDX-License-Identifier: MIT
#include "runner/command_line.h"

#include "load/diagnostics.h"
#include "runner/choice.h"
#include "runner/commands.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <ostream>
#include <string_view>

namespace trellis {

namespace {

using Execute = std::function<Exit(Streams&)>;

/// One line of `trellis --help`, and what it takes to run it.
struct Command {
    const char* name;
    const char* summary;
    const char* examples;
    Execute (*prepare)(CLI::App&);
};

/// Adds a command's options, to be filled in by parsing; then it can be executed.
template <class Arguments>
Execute prepare(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    add_options(app, *arguments);
    return [arguments](Streams& streams) { return execute(*arguments, streams); };
}

constexpr std::array commands{
    Command{
        "run", "drive the robot with a behaviour and say what happened",
        "  trellis run trees/roomba.xml\n"
        "  trellis run machines/roomba.scxml --seed 7 --time 600 --trace out.csv --svg out.svg\n"
        "  trellis run trees/roomba.xml --set speed=0.3 --format json\n",
        prepare<RunArguments>},
    Command{"validate", "say everything that is wrong with files",
            "  trellis validate trees/*.xml machines/*.scxml\n"
            "  trellis validate my_tree.xml --format json\n",
            prepare<ValidateArguments>},
};

constexpr const char* footer =
    "Examples:\n"
    "  trellis run trees/roomba.xml\n"
    "  trellis validate my_tree.xml\n"
    "\n"
    "trellis COMMAND --help says more. Exit code: 0 yes or done, 1 no, 2 usage,\n"
    "3 a file cannot be read or written, 4 internal error.";

enum class Colour : std::uint8_t { automatic, always, never };

bool coloured(Colour colour, const Terminal& terminal) {
    switch (colour) {
    case Colour::always: return true;
    case Colour::never: return false;
    case Colour::automatic: break;
    }
    return !terminal.no_color && (terminal.clicolor_force || terminal.is_terminal);
}

/// The long names of a command's options, for suggestions.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

/// What is wrong with a word that nothing takes.
std::string unknown_word(const CLI::App& app, const std::string& word) {
    if (!word.starts_with('-')) { return "there is no use for \"" + word + "\" here"; }
    const std::string name = word.substr(0, word.find('='));
    const std::vector<std::string> names = option_names(app);
    return app.get_name() + " has no option " + name +
           suggestion(name, {names.begin(), names.end()});
}

/// The command line of one call.
class CommandLine {
public:
    CommandLine();

    Exit run(std::vector<std::string> words, Streams& streams, const Terminal& terminal);

private:
    Exit usage(Streams& streams, std::string_view message, const CLI::App& app) const;
    const CLI::App& used() const;

    CLI::App app_{"Runs behaviour trees and statecharts, written as files, against a simulated "
                  "Roomba."};
    std::vector<std::pair<CLI::App*, Execute>> commands_;
    Colour colour_ = Colour::automatic;
};

CommandLine::CommandLine() {
    app_.name("trellis");
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "trellis " TRELLIS_VERSION);
    app_.footer(footer);
    for (const Command& command : commands) {
        CLI::App* sub = app_.add_subcommand(command.name, command.summary);
        sub->footer(std::string("Examples:\n") + command.examples);
        commands_.emplace_back(sub, command.prepare(*sub));
        add_choice<Colour>(
            *sub, "--color", colour_,
            {{"auto", Colour::automatic}, {"always", Colour::always}, {"never", Colour::never}},
            "colour of messages; auto: on a terminal, unless NO_COLOR is set");
    }
}

const CLI::App& CommandLine::used() const {
    for (const auto& [sub, execute] : commands_) {
        if (sub->parsed()) { return *sub; }
    }
    return app_;
}

Exit CommandLine::usage(Streams& streams, std::string_view message, const CLI::App& app) const {
    complain(streams, Exit::usage, message);
    streams.err << "try: " << (&app == &app_ ? "" : "trellis ") << app.get_name() << " --help\n";
    return Exit::usage;
}

Exit CommandLine::run(std::vector<std::string> words, Streams& streams, const Terminal& terminal) {
    // the name of a command comes first; CLI11 would only say that one is missing
    std::vector<std::string_view> names;
    for (const Command& command : commands) {
        names.emplace_back(command.name);
    }
    if (words.empty()) { return usage(streams, "which command?", app_); }
    if (!words.front().starts_with('-') &&
        std::find(names.begin(), names.end(), words.front()) == names.end()) {
        return usage(streams,
                     "there is no command \"" + words.front() + '"' +
                         suggestion(words.front(), names),
                     app_);
    }
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    try {
        app_.parse(words);
    } catch (const CLI::CallForHelp&) {
        streams.out << app_.help();
        return Exit::yes;
    } catch (const CLI::CallForVersion& version) {
        streams.out << version.what() << '\n';
        return Exit::yes;
    } catch (const CLI::ExtrasError&) {
        return usage(streams, unknown_word(used(), app_.remaining(true).front()), used());
    } catch (const CLI::ParseError& error) { return usage(streams, error.what(), used()); }
    streams.colour = coloured(colour_, terminal);
    for (const auto& [sub, execute] : commands_) {
        if (sub->parsed()) { return execute(streams); }
    }
    return Exit::internal;
}

}  // namespace

void add_format(CLI::App& app, Format& format) {
    add_choice<Format>(app, "--format", format, {{"text", Format::text}, {"json", Format::json}},
                       "how to write the result");
}

Exit run_program(const std::vector<std::string>& words, Streams streams, const Terminal& terminal) {
    try {
        return CommandLine().run(words, streams, terminal);
    } catch (const std::bad_alloc&) {
        return complain(streams, Exit::internal, "internal error: not enough memory");
    } catch (const std::exception& error) {
        return complain(streams, Exit::internal, std::string("internal error: ") + error.what());
    }
}

}  // namespace trellis
