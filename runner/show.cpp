// trellis show: pictures of a behaviour file, as it is written or as a run found it.
// SPDX-License-Identifier: MIT
#include "runner/commands.h"
#include "runner/declarations.h"
#include "runner/recording.h"
#include "runner/run_highlights.h"
#include "runner/table.h"

#include <CLI/CLI.hpp>

#include <ostream>
#include <utility>

namespace trellis {

namespace {

Exit show_program(const ShowArguments& arguments, Registry& registry, Streams& streams) {
    Exit exit = Exit::yes;
    const auto behaviour = load_declaring(arguments.file, arguments.load, registry, streams, exit);
    if (behaviour) { streams.out << dump(*behaviour->program); }
    return exit;
}

/// What is drawn, and what a run did in it.
struct Subject {
    Document document;
    std::string main_tree;              ///< as in DrawingOptions
    std::vector<Highlight> highlights;  ///< none without a trace
    std::string heading;                ///< which tick it is; empty without a trace
};

void see(const ShowArguments& arguments, const Recording& recording, const Program& program,
         Subject& subject) {
    const std::uint64_t last = recording.ticks;
    const std::uint64_t tick = arguments.coverage ? last : arguments.tick.value_or(last);
    RowStatuses statuses(program);
    for (const TraceEvent& event : recording.events) {
        if (event.tick <= tick) { statuses.on(event); }
    }
    const Places places(program, subject.document);
    if (arguments.coverage) {
        subject.highlights = highlights_unreached(program, places, statuses);
        subject.heading = "what " + std::to_string(last) + " ticks never reached";
        return;
    }
    subject.highlights = highlights_at(program, places, statuses, tick);
    subject.heading = "tick " + std::to_string(tick) + " of " + std::to_string(last) + ", " +
                      fixed(static_cast<double>(tick) * recording.dt, 3) + " s";
}

/// The behaviour and what the recorded run did; none after messages.
std::optional<Subject> load_with_trace(const ShowArguments& arguments, Registry& registry,
                                       Streams& streams, Exit& exit) {
    const std::optional<Recording> recording = load_recording(arguments.trace, streams, exit);
    if (!recording) { return {}; }
    if (arguments.tick && *arguments.tick > recording->ticks) {
        exit = complain(streams, Exit::no,
                        shown_name(arguments.trace) + " ends with tick " +
                            std::to_string(recording->ticks));
        return {};
    }
    const auto behaviour =
        load_recorded(arguments.file, arguments.load, *recording, registry, streams, exit);
    if (!behaviour) { return {}; }
    Diagnostics diagnostics;
    Subject subject{*read(behaviour->source(), diagnostics), {}, {}, {}};
    subject.main_tree =
        arguments.load.main_tree.empty() ? recording->tree : arguments.load.main_tree;
    see(arguments, *recording, *behaviour->program, subject);
    return subject;
}

std::optional<Subject> load_subject(const ShowArguments& arguments, Registry& registry,
                                    Streams& streams, Exit& exit) {
    if (!arguments.trace.empty()) { return load_with_trace(arguments, registry, streams, exit); }
    std::optional<Document> document = load_document(arguments.file, streams, exit);
    if (!document) { return {}; }
    return Subject{std::move(*document), arguments.load.main_tree, {}, {}};
}

bool needs_trace(const ShowArguments& arguments) {
    return arguments.trace.empty() && (arguments.tick || arguments.coverage);
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
    app.add_option("--trace", arguments.trace,
                   "show what a run did that trellis run --trace FILE.jsonl has recorded")
        ->type_name("FILE");
    CLI::Option* tick =
        app.add_option("--tick", arguments.tick, "of the trace; its last one if not given")
            ->type_name("N");
    app.add_flag("--coverage", arguments.coverage, "show what the run of the trace never reached")
        ->excludes(tick);
    app.add_flag("--program", arguments.program, "print the compiled program instead")
        ->excludes("--svg", "--dot", "--text", "--ascii", "--trace");
    add_options(app, arguments.load);
}

Exit execute(const ShowArguments& arguments, Streams& streams) {
    RoombaRegistry registry;
    if (needs_trace(arguments)) {
        return complain(streams, Exit::usage, "--tick and --coverage need --trace FILE.jsonl");
    }
    if (arguments.program) { return show_program(arguments, registry, streams); }
    Exit exit = Exit::yes;
    const std::optional<Subject> subject = load_subject(arguments, registry, streams, exit);
    if (!subject) { return exit; }
    const DrawingOptions options{.ascii = arguments.ascii,
                                 .main_tree = subject->main_tree,
                                 .sideways = arguments.sideways,
                                 .registry = &registry,
                                 .highlights = subject->highlights};
    const std::pair<const std::string&, DrawingFormat> pictures[] = {
        {arguments.svg, DrawingFormat::svg}, {arguments.dot, DrawingFormat::dot}};
    for (const auto& [path, format] : pictures) {
        if (!path.empty() && !write_text(path, draw(subject->document, format, options), streams)) {
            return Exit::file;
        }
    }
    if (arguments.text || arguments.ascii || (arguments.svg.empty() && arguments.dot.empty())) {
        if (!subject->heading.empty()) { streams.out << subject->heading << "\n\n"; }
        streams.out << draw(subject->document, DrawingFormat::text, options);
    }
    return Exit::yes;
}

}  // namespace trellis
