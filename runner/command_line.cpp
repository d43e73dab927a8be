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
#include <optional>
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

/// trellis trace: the one command that has commands of its own.
Execute prepare_trace(CLI::App& app) {
    app.require_subcommand(1);
    CLI::App* diff = app.add_subcommand("diff", "say where two traces first differ");
    CLI::App* convert = app.add_subcommand("convert", "write a trace for Perfetto or Groot2");
    diff->fallthrough();
    convert->fallthrough();
    return [diff, on_diff = prepare<TraceDiffArguments>(*diff),
            on_convert = prepare<TraceConvertArguments>(*convert)](Streams& streams) {
        return diff->parsed() ? on_diff(streams) : on_convert(streams);
    };
}

/// trellis sweep SPEC, and trellis sweep merge.
Execute prepare_sweep(CLI::App& app) {
    CLI::App* merge = app.add_subcommand("merge", "put the parts of a sweep together");
    merge->fallthrough();
    return [merge, on_sweep = prepare<SweepArguments>(app),
            on_merge = prepare<SweepMergeArguments>(*merge)](Streams& streams) {
        return merge->parsed() ? on_merge(streams) : on_sweep(streams);
    };
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
    Command{"convert", "write a file in XML or in JSON, without loss",
            "  trellis convert trees/roomba.xml roomba.json\n"
            "  trellis convert my_tree.xml my_tree.xml      (the same, laid out evenly)\n"
            "  trellis convert - - --to xml < roomba.json\n",
            prepare<ConvertArguments>},
    Command{"show", "draw a behaviour",
            "  trellis show machines/roomba.scxml\n"
            "  trellis show trees/roomba.xml --svg tree.svg\n"
            "  trellis show trees/roomba.xml --dot - | dot -Tpdf > tree.pdf\n",
            prepare<ShowArguments>},
    Command{"try", "step a behaviour by hand, with a robot or without",
            "  trellis try trees/roomba.xml\n"
            "  trellis try trees/roomba.xml --world none --outcomes MoveForward=RRS\n"
            "  printf 'tick 3\\nstate\\n' | trellis try machines/roomba.scxml\n",
            prepare<TryArguments>},
    Command{"fmt", "lay files out evenly",
            "  trellis fmt my_tree.xml\n"
            "  trellis fmt --check trees/*.xml machines/*.scxml\n",
            prepare<FmtArguments>},
    Command{"compare", "run two behaviours side by side and say where they part",
            "  trellis compare machines/roomba.scxml trees/roomba.xml\n"
            "  trellis compare before.xml after.xml --seeds 20 --time 600\n",
            prepare<CompareArguments>},
    Command{"sweep", "run behaviours in worlds with many seeds and say what covers most",
            "  trellis sweep sweeps/lab.json\n"
            "  trellis sweep sweeps/lab.json --out rows.csv\n"
            "  trellis sweep sweeps/lab.json --out rows.csv --resume\n"
            "  trellis sweep sweeps/lab.json --out rows.csv --shard 1/3\n"
            "  trellis sweep merge sweeps/lab.json rows.csv.*.runs --out rows.csv\n",
            prepare_sweep},
    Command{"nodes", "list the nodes, leaves and sensors that files can name",
            "  trellis nodes\n"
            "  trellis nodes --xml > palette.xml            (Groot2 opens it)\n",
            prepare<NodesArguments>},
    Command{"schema", "print the grammar of a kind of file",
            "  trellis schema tree-xsd > trellis_tree.xsd\n"
            "  trellis schema machine-json > trellis_machine.schema.json\n",
            prepare<SchemaArguments>},
    Command{"trace", "compare recorded runs, and convert them",
            "  trellis trace diff before.csv after.csv\n"
            "  trellis trace diff before.csv after.csv --tolerance 0.001\n"
            "  trellis trace convert run.jsonl run.json     (Perfetto opens it)\n"
            "  trellis trace convert run.jsonl run.btlog    (Groot2 opens it)\n",
            prepare_trace},
};

constexpr const char* footer =
    "Examples:\n"
    "  trellis run trees/roomba.xml\n"
    "  trellis validate my_tree.xml\n"
    "  trellis show machines/roomba.scxml --svg machine.svg\n"
    "  trellis compare machines/roomba.scxml trees/roomba.xml\n"
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

/// "trellis run", "trellis trace diff".
std::string full_name(const CLI::App& app) {
    if (app.get_parent() == nullptr) { return app.get_name(); }
    return full_name(*app.get_parent()) + ' ' + app.get_name();
}

/// What is wrong with a word that nothing takes.
std::string unknown_word(const CLI::App& app, const std::string& word) {
    if (!word.starts_with('-')) { return "there is no use for \"" + word + "\" here"; }
    const std::string name = word.substr(0, word.find('='));
    const std::vector<std::string> names = option_names(app);
    return full_name(app) + " has no option " + name +
           suggestion(name, {names.begin(), names.end()});
}

/// The command line of one call.
class CommandLine {
public:
    CommandLine();

    Exit run(std::vector<std::string> words, Streams& streams, const Terminal& terminal);

private:
    std::optional<Exit> check_commands(const std::vector<std::string>& words,
                                       Streams& streams) const;
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
    const CLI::App* used = &app_;
    while (!used->get_subcommands().empty()) {
        used = used->get_subcommands().front();
    }
    return *used;
}

Exit CommandLine::usage(Streams& streams, std::string_view message, const CLI::App& app) const {
    complain(streams, Exit::usage, message);
    streams.err << "try: " << full_name(app) << " --help\n";
    return Exit::usage;
}

// The names of commands come first; CLI11 would only say that one is missing. What to return if
// they make no sense.
std::optional<Exit> CommandLine::check_commands(const std::vector<std::string>& words,
                                                Streams& streams) const {
    const CLI::App* app = &app_;
    for (std::size_t i = 0;; ++i) {
        const std::vector<const CLI::App*> subs = app->get_subcommands({});
        if (subs.empty()) { return {}; }
        if (i == words.size()) {
            if (app->get_require_subcommand_min() == 0) { return {}; }
            return usage(streams, "which command?", *app);
        }
        if (words[i].starts_with('-')) { return {}; }
        std::vector<std::string_view> names;
        const CLI::App* named = nullptr;
        for (const CLI::App* sub : subs) {
            if (sub->get_name() == words[i]) { named = sub; }
            names.emplace_back(sub->get_name());
        }
        if (named == nullptr) {
            // the first word may be an argument instead
            if (app->get_require_subcommand_min() == 0) { return {}; }
            return usage(streams,
                         "there is no command \"" + words[i] + '"' + suggestion(words[i], names),
                         *app);
        }
        app = named;
    }
}

Exit CommandLine::run(std::vector<std::string> words, Streams& streams, const Terminal& terminal) {
    if (const std::optional<Exit> exit = check_commands(words, streams)) { return *exit; }
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    try {
        app_.parse(words);
    } catch (const CLI::CallForHelp&) {
        streams.out << app_.help();
        return Exit::yes;
    } catch (const CLI::CallForVersion& version) {
        streams.out << version.what() << '\n';
        return Exit::yes;
    } catch (const CLI::ParseError& error) {
        // a word that nothing takes explains more than what is missing
        const std::vector<std::string> unknown = app_.remaining(true);
        return usage(streams,
                     unknown.empty() ? error.what() : unknown_word(used(), unknown.front()),
                     used());
    }
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
