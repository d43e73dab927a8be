// trellis try: commands that step a behaviour by hand.
// SPDX-License-Identifier: MIT
#include "core/number.h"
#include "runner/choice.h"
#include "runner/commands.h"
#include "runner/declarations.h"
#include "runner/run_highlights.h"
#include "runner/trial.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <istream>
#include <memory>
#include <ostream>
#include <utility>

namespace trellis {

namespace {

/// "word rest" in two, without the blanks between and around.
std::pair<std::string, std::string> first_word(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    std::string_view rest = line.substr(end);
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    return {std::string(line.substr(0, end)), std::string(rest)};
}

/// The text without blanks around it.
std::string trimmed(std::string_view text) {
    const auto [word, rest] = first_word(text);
    return rest.empty() ? word : word + ' ' + rest;
}

/// "name=value" in two; an empty name if there is no "=".
std::pair<std::string, std::string> assignment(std::string_view text) {
    const std::size_t at = text.find('=');
    if (at == std::string_view::npos) { return {}; }
    return {trimmed(text.substr(0, at)), trimmed(text.substr(at + 1))};
}

/// A conversation with one trial.
class Prompt {
public:
    Prompt(Document document, Mocks& mocks, Trial& trial, bool ascii, Streams& streams)
        : document_(std::move(document)), places_(mocks.program(), document_), mocks_(mocks),
          trial_(trial), ascii_(ascii), streams_(streams) {}

    /// Reads commands to the end. False if one made no sense or a tick failed.
    bool talk();

private:
    struct Command {
        const char* name;
        const char* arguments;
        const char* help;
        bool (Prompt::*run)(const std::string& arguments);  ///< false after a message
    };
    static const std::array<Command, 13> commands;

    bool run_line(const std::string& line);
    bool tick(const std::string& count);
    bool state(const std::string&);
    bool set(const std::string& text);
    bool get(const std::string& name);
    bool vars(const std::string&);
    bool outcomes(const std::string& text);
    bool send(const std::string& text);
    bool back(const std::string& count);
    bool halt(const std::string&);
    bool reset(const std::string&);
    bool pose(const std::string&);
    bool help(const std::string&);
    bool quit(const std::string&);

    bool wrong(std::string_view message) {
        complain(streams_, Exit::no, message);
        return false;
    }
    bool count_in(const std::string& text, std::size_t& count);
    std::string where() const;
    void tell_happened();

    Document document_;
    Places places_;
    Mocks& mocks_;
    Trial& trial_;
    bool ascii_;
    Streams& streams_;
    bool over_ = false;
};

const std::array<Prompt::Command, 13> Prompt::commands{{
    {"tick", "[N]", "run one tick, or N; an empty line too", &Prompt::tick},
    {"state", "", "show what every node or state did in the last tick", &Prompt::state},
    {"vars", "", "list the variables", &Prompt::vars},
    {"get", "NAME", "print a variable", &Prompt::get},
    {"set", "NAME=VALUE", "give a variable a value", &Prompt::set},
    {"outcomes", "NAME=SFRK",
     "make leaves return these, again and again; without: list those "
     "that nobody told what to return",
     &Prompt::outcomes},
    {"send", "EVENT [DATA]", "send an event to a machine; it is taken in the next tick",
     &Prompt::send},
    {"back", "[N]", "undo one step, or N", &Prompt::back},
    {"halt", "", "halt everything that runs", &Prompt::halt},
    {"reset", "", "begin again", &Prompt::reset},
    {"pose", "", "say where the robot is", &Prompt::pose},
    {"help", "", "list the commands", &Prompt::help},
    {"quit", "", "end", &Prompt::quit},
}};

bool Prompt::talk() {
    bool ok = true;
    std::string line;
    for (;;) {
        if (streams_.prompt) { streams_.out << where() << "> "; }
        streams_.out.flush();
        if (over_ || !std::getline(streams_.in, line)) { break; }
        ok = run_line(line) && ok;
        if (over_) { break; }
    }
    if (streams_.prompt && !over_) { streams_.out << '\n'; }
    return ok;
}

bool Prompt::run_line(const std::string& line) {
    auto [name, arguments] = first_word(line);
    if (name.starts_with('#')) { return true; }
    if (name.empty()) {
        // someone at a terminal who presses Enter wants to go on; a script may have empty lines
        if (!streams_.prompt) { return true; }
        name = "tick";
    }
    std::vector<std::string_view> names;
    for (const Command& command : commands) {
        names.emplace_back(command.name);
        if (command.name != name) { continue; }
        if (*command.arguments == '\0' && !arguments.empty()) {
            return wrong(name + " takes nothing, found \"" + arguments + '"');
        }
        return (this->*command.run)(arguments);
    }
    const std::string hint = suggestion(name, names);
    return wrong("there is no command \"" + name + '"' + (hint.empty() ? "; try help" : hint));
}

bool Prompt::count_in(const std::string& text, std::size_t& count) {
    count = 1;
    if (text.empty()) { return true; }
    constexpr double most = 1e6;
    const ParsedNumber number = parse_whole_number(text);
    const bool digits = text.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || number.value < 1 || number.value > most) {
        return wrong("expected a whole number from 1 to 1000000, found \"" + text + '"');
    }
    count = static_cast<std::size_t>(number.value);
    return true;
}

// The tick, and where a machine or what a tree is.
std::string Prompt::where() const {
    const Trial::Moment& now = trial_.now();
    std::string out = "tick " + std::to_string(now.state.tick);
    if (!trial_.program().is_machine()) { return out + "  " + std::string(name_of(now.status)); }
    std::string active;
    for (RowId n{1}; n.index < trial_.program().rows.size(); ++n.index) {
        const bool state = op_table()[trial_.program().at(n).op].group == OpGroup::state;
        if (state && now.statuses.at(n, now.state.tick) == Status::running) {
            active += (active.empty() ? "" : ", ") + std::string(trial_.program().name(n));
        }
    }
    return out + "  " + (active.empty() ? "-" : active);
}

void Prompt::tell_happened() {
    streams_.out << where();
    std::string_view separator = "  ";
    for (const std::string& what : trial_.happened()) {
        streams_.out << separator << what;
        separator = ", ";
    }
    streams_.out << '\n';
}

// Of many ticks only those are told in which something else happened than in the one before.
bool Prompt::tick(const std::string& text) {
    std::size_t count = 0;
    if (!count_in(text, count)) { return false; }
    std::vector<std::string> last;
    for (std::size_t i = 0; i < count; ++i) {
        if (trial_.is_over()) {
            return wrong("the machine has come to its end; try back or reset");
        }
        if (!trial_.tick()) {
            streams_.err << trial_.fault() << '\n';
            return false;
        }
        const bool told = i == 0 || i + 1 == count || trial_.happened() != last;
        if (told) { tell_happened(); }
        last = trial_.happened();
    }
    return true;
}

bool Prompt::state(const std::string&) {
    const Trial::Moment& now = trial_.now();
    const std::vector<Highlight> highlights =
        highlights_at(trial_.program(), places_, now.statuses, now.state.tick);
    streams_.out << where() << '\n'
                 << draw(document_, DrawingFormat::text,
                         {.ascii = ascii_,
                          .main_tree = trial_.program().name({0}),
                          .highlights = highlights});
    return true;
}

bool Prompt::set(const std::string& text) {
    const auto [name, value] = assignment(text);
    if (name.empty()) { return wrong("expected set NAME=VALUE, found \"" + text + '"'); }
    const std::string why = trial_.assign(name, value);
    return why.empty() || wrong(why);
}

bool Prompt::get(const std::string& name) {
    std::vector<std::string> names;
    for (const auto& [known, value] : trial_.variables()) {
        if (known == name) {
            streams_.out << print(*value) << '\n';
            return true;
        }
        names.push_back(known);
    }
    return wrong("there is no variable \"" + name + '"' +
                 suggestion(name, {names.begin(), names.end()}));
}

bool Prompt::vars(const std::string&) {
    for (const auto& [name, value] : trial_.variables()) {
        if (name.starts_with('_')) { continue; }
        streams_.out << name << " = " << print(*value) << '\n';
    }
    return true;
}

bool Prompt::outcomes(const std::string& text) {
    if (text.empty()) {
        for (const std::string& name : mocks_.untold()) {
            streams_.out << name << '\n';
        }
        return true;
    }
    const auto [name, letters] = assignment(text);
    if (name.empty()) { return wrong("expected outcomes NAME=SFRK, found \"" + text + '"'); }
    const std::string why = mocks_.tell(name, letters);
    return why.empty() || wrong(why);
}

bool Prompt::send(const std::string& text) {
    const auto [event, data] = first_word(text);
    if (event.empty()) { return wrong("expected send EVENT [DATA]"); }
    if (!trial_.program().is_machine()) { return wrong("a tree takes no events; try set"); }
    trial_.send(event, data.empty() ? Value() : Trial::value_in(data));
    return true;
}

bool Prompt::back(const std::string& text) {
    std::size_t count = 0;
    if (!count_in(text, count)) { return false; }
    const std::size_t undone = trial_.back(count);
    streams_.out << where() << '\n';
    if (undone == count) { return true; }
    return wrong("only " + std::to_string(undone) + " of " + std::to_string(count) +
                 " steps could be undone");
}

bool Prompt::halt(const std::string&) {
    trial_.halt();
    tell_happened();
    return true;
}

bool Prompt::reset(const std::string&) {
    trial_.reset();
    streams_.out << where() << '\n';
    return true;
}

bool Prompt::pose(const std::string&) {
    const Roomba& robot = trial_.now().robot;
    streams_.out << "x " << print_number(robot.x) << " m, y " << print_number(robot.y)
                 << " m, rotation " << print_number(robot.rotation) << " rad"
                 << (robot.bumper ? ", at a wall\n" : "\n");
    return true;
}

bool Prompt::help(const std::string&) {
    for (const Command& command : commands) {
        std::string usage = command.name;
        if (*command.arguments != '\0') { usage += std::string(" ") + command.arguments; }
        usage.resize(std::max<std::size_t>(usage.size() + 1, 20), ' ');
        streams_.out << usage << command.help << '\n';
    }
    return true;
}

bool Prompt::quit(const std::string&) {
    over_ = true;
    return true;
}

}  // namespace

void add_options(CLI::App& app, TryArguments& arguments) {
    app.add_option("FILE", arguments.file, "the behaviour: a tree or machine file")->required();
    app.add_option("--outcomes", arguments.outcomes,
                   "make the leaves with that ID or name return these again and again: S, F, R "
                   "and K for success, failure, running and skipped")
        ->type_name("NAME=SFRK")
        ->allow_extra_args(false);
    add_choice<bool>(app, "--world", arguments.no_world, {{"lab", false}, {"none", true}},
                     "the lab's room, or no robot: then no leaf acts, all return what "
                     "--outcomes says");
    app.add_option("--seed", arguments.seed, "seed of the random numbers; 0 if not given")
        ->type_name("N");
    app.add_flag("--ascii", arguments.ascii, "pictures of ASCII characters only");
    add_options(app, arguments.load);
}

Exit execute(const TryArguments& arguments, Streams& streams) {
    if (arguments.file == "-") {
        return complain(streams, Exit::usage,
                        "the commands come from standard input: the behaviour must be a file");
    }
    RoombaRegistry registry;
    Exit exit = Exit::yes;
    std::optional<Behaviour> behaviour =
        load_behaviour(arguments.file, arguments.load, registry, streams, exit, Declared::leaves);
    if (!behaviour) { return exit; }
    Mocks mocks(std::move(*behaviour->program), arguments.no_world);
    for (const std::string& text : arguments.outcomes) {
        const auto [name, letters] = assignment(text);
        const std::string why = name.empty()
                                    ? "expected --outcomes NAME=SFRK, found \"" + text + '"'
                                    : mocks.tell(name, letters);
        if (!why.empty()) { return complain(streams, Exit::usage, why); }
    }
    EpisodeSetup setup;
    setup.random = Random(arguments.seed);
    Trial trial(mocks, std::move(setup), !arguments.no_world);
    Diagnostics diagnostics;
    Prompt prompt(*read(behaviour->source(), diagnostics), mocks, trial, arguments.ascii, streams);
    if (streams.prompt) { streams.out << "help lists the commands, quit ends\n"; }
    const bool ok = prompt.talk();
    return ok || streams.prompt ? Exit::yes : Exit::no;
}

}  // namespace trellis
