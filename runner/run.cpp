// trellis run: one episode, its traces, its picture and its report.
// SPDX-License-Identifier: MIT
#include "exec/step.h"
#include "runner/choice.h"
#include "runner/commands.h"
#include "runner/declarations.h"
#include "runner/event_lines.h"
#include "runner/run_report.h"
#include "runner/start_events.h"
#include "sim/bridge/trace_csv.h"
#include "sim/coverage.h"
#include "sim/trail.h"
#include "sim/trail_svg.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <ostream>
#include <utility>

namespace trellis {

namespace {

/// A trace that is being written.
struct TraceFile {
    std::string path;
    bool events;  ///< JSON Lines; else CSV
    std::unique_ptr<OutputFile> file;
};

/// One run: drives the episode and hands what happens to whoever asked for it.
class Run : TraceSink {
public:
    /// `floor` is that of the world, to measure coverage on; null if nobody asks.
    Run(const RunArguments& arguments, const Behaviour& behaviour, const Floor* floor,
        Streams& streams)
        : arguments_(arguments), behaviour_(behaviour), program_(*behaviour.program),
          streams_(streams), labels_(program_), tally_(labels_) {
        if (arguments.stats) { profile_.emplace(program_); }
        if (floor != nullptr) { coverage_.emplace(*floor); }
    }

    /// Opens the traces; false after a message. `random` says where random numbers come from.
    bool open(const std::string& random);
    /// Runs to the end; false if a trace cannot be written any more.
    bool drive(Episode& episode);
    /// Gives the traces their names and writes the picture; false after a message.
    bool write_files(const Episode& episode, const std::string& random);
    std::string report(const Episode& episode, std::string random);

private:
    void on(const TraceEvent& event) override;
    void add_row(const Episode& episode);
    void add_point(const Roomba& before, const State& after);
    void cover(const Episode& episode);
    std::string picture(const Episode& episode, const std::string& random) const;
    std::string text_of(const RunReport& report) const {
        return arguments_.format == Format::json ? report_json(report) : report_text(report);
    }

    const RunArguments& arguments_;
    const Behaviour& behaviour_;
    const Program& program_;
    Streams& streams_;
    Labels labels_;
    Tally tally_;
    std::optional<Profile> profile_;
    std::vector<TraceFile> traces_;
    Trail trail_;
    std::optional<Coverage> coverage_;
    std::vector<std::string> log_;
    bool written_ = true;
};

bool Run::open(const std::string& random) {
    std::string run_line;
    append_run_line(run_line, program_,
                    {.file = arguments_.file,
                     .tree = arguments_.load.main_tree,
                     .dt = arguments_.episode.dt,
                     .random = random});
    for (const std::string& path : arguments_.traces) {
        std::unique_ptr<OutputFile> file = open_output(path, streams_);
        if (!file) { return false; }
        traces_.push_back({path, path.ends_with(".jsonl"), std::move(file)});
        const TraceFile& trace = traces_.back();
        trace.file->write(trace.events ? std::string_view(run_line) : trace_csv_header);
    }
    return true;
}

void Run::on(const TraceEvent& event) {
    tally_.on(event);
    if (profile_) { profile_->on(event); }
    if (event.kind == TraceEvent::Kind::log && arguments_.log) {
        if (arguments_.format == Format::json) {
            log_.emplace_back(event.text);
        } else {
            streams_.out << event.text << '\n';
        }
    }
    std::string line;
    for (const TraceFile& trace : traces_) {
        if (!trace.events) { continue; }
        if (line.empty()) { append_event_line(line, program_, event); }
        written_ = trace.file->write(line) && written_;
    }
}

void Run::add_row(const Episode& episode) {
    std::string line;
    for (const TraceFile& trace : traces_) {
        if (trace.events) { continue; }
        if (line.empty()) { append_trace_csv(line, episode.row()); }
        written_ = trace.file->write(line) && written_;
    }
}

void Run::add_point(const Roomba& before, const State& after) {
    if (arguments_.svg.empty()) { return; }
    const std::uint32_t label = labels_.of(labels_.row(after)).index;
    trail_.add({before.x, before.y,
                static_cast<std::uint16_t>(std::min<std::uint32_t>(label, TrailPoint::no_leaf))});
}

void Run::cover(const Episode& episode) {
    if (coverage_) { coverage_->add(episode.robot().x, episode.robot().y, episode.state().tick); }
}

bool Run::drive(Episode& episode) {
    trace_start(episode, *this);
    add_row(episode);
    cover(episode);
    const std::uint64_t ticks = arguments_.episode.tick_count();
    for (std::uint64_t i = 0; i < ticks && written_ && streams_.out; ++i) {
        const Roomba before = episode.robot();
        if (!episode.tick(this)) { break; }
        tally_.tick(episode);
        add_point(before, episode.state());
        cover(episode);
        add_row(episode);
        if (episode.is_over()) { break; }
    }
    return written_;
}

std::string Run::picture(const Episode& episode, const std::string& random) const {
    return trail_svg(episode.setup().world, trail_.points(), episode.robot(),
                     {.title = shown_name(arguments_.file),
                      .run = random,
                      .seconds = episode.row().time,
                      .leaves = labels_.names(),
                      .walled = episode.setup().walled,
                      .floor = coverage_ ? &coverage_->floor() : nullptr,
                      .start = start_of(episode.setup())});
}

bool Run::write_files(const Episode& episode, const std::string& random) {
    std::string end_line;
    append_end_line(end_line, episode.state().tick, ending(episode));
    for (const TraceFile& trace : traces_) {
        if (trace.events) { trace.file->write(end_line); }
        if (!commit(*trace.file, trace.path, streams_)) { return false; }
    }
    return arguments_.svg.empty() || write_text(arguments_.svg, picture(episode, random), streams_);
}

std::string Run::report(const Episode& episode, std::string random) {
    const std::string file = shown_name(arguments_.file);
    RunReport report{file, std::move(random), episode, labels_, tally_, log_};
    if (coverage_) {
        report.coverage.emplace(
            CoverageReport{*coverage_, tally_, episode.state().tick, episode.setup().dt});
    }
    if (!profile_) { return text_of(report); }
    const std::uint64_t ticks = episode.state().tick;
    profile_->finish(ticks);
    Diagnostics diagnostics;
    const std::optional<Document> document = read(behaviour_.source(), diagnostics);
    const ProfileReport stats{program_, *document, *profile_, ticks, arguments_.episode.dt};
    report.profile = &stats;
    return text_of(report);
}

/// The error of a run that cannot go on.
void show_fault(const Program& program, const State& state, Streams& streams) {
    streams.err << describe_fault(program, state) << '\n';
}

/// Whether the traces or the picture go to standard output, where the report then does not.
bool writes_to_pipe(const RunArguments& arguments) {
    const auto& traces = arguments.traces;
    return arguments.svg == "-" || std::find(traces.begin(), traces.end(), "-") != traces.end();
}

class LogSink : public TraceSink {
public:
    explicit LogSink(std::ostream& out) : out_(out) {}
    void on(const TraceEvent& event) override {
        if (event.kind == TraceEvent::Kind::log) { out_ << event.text << '\n'; }
    }

private:
    std::ostream& out_;
};

// Without a robot: only the events of the machine itself, as fast as they come.
Exit run_without_world(const RunArguments& arguments, const Program& program, Random random,
                       Streams& streams) {
    if (!program.is_machine() || program.host != nullptr) {
        return complain(streams, Exit::no,
                        shown_name(arguments.file) + " needs a robot: only a machine whose leaves "
                                                     "and expressions need none runs without one");
    }
    LogSink log(streams.out);
    const StepOptions options{.dt = arguments.episode.dt, .trace = arguments.log ? &log : nullptr};
    State state = fresh_state(program);
    state.random = std::move(random);
    start(program, state, {}, options);
    // time jumps to the next cycle in which something can happen; a machine that can do nothing any
    // more has ended
    const std::uint64_t ticks = arguments.episode.tick_count();
    while (!state.fault) {
        const std::optional<std::uint64_t> idle = idle_cycles(program, state);
        if (!idle || state.tick + *idle >= ticks) { break; }
        skip_cycles(state, *idle);
        if (is_done(step(program, state, {}, options))) { break; }
    }
    if (state.fault) {
        show_fault(program, state, streams);
        return Exit::no;
    }
    const RowId final = state.session.final;
    streams.out << "final: " << (final ? program.name(final) : "-") << '\n';
    return final ? Exit::yes : Exit::no;
}

Exit run_in_world(const RunArguments& arguments, const Behaviour& behaviour, Random random,
                  const std::string& random_words, Streams& streams) {
    const Program& program = *behaviour.program;
    EpisodeSetup setup = setup_of(arguments.episode);
    setup.random = std::move(random);
    const std::vector<std::int64_t>& seeds = arguments.episode.seeds;
    setup.noise = noise_of(seeds.empty() ? 0 : seeds.back());
    std::optional<WalledWorld> world;
    if (!arguments.world.is_lab()) {
        Exit exit = Exit::yes;
        world = load_world(arguments.world.name, streams, exit);
        if (!world) { return exit; }
        setup.walled = &*world;
    }
    const Pose start = start_of(setup);
    if (world && !fits(*world, {start.x, start.y})) {
        return complain(streams, Exit::usage, "--pose: the robot does not fit there");
    }
    Episode episode(program, std::move(setup));
    std::optional<Floor> floor;
    if (arguments.cell) {
        floor.emplace(world ? floor_of(world->walls, {start.x, start.y}, *arguments.cell)
                            : floor_of(episode.setup().world, *arguments.cell));
    }
    Run run(arguments, behaviour, floor ? &*floor : nullptr, streams);
    if (!run.open(random_words)) { return Exit::file; }
    run.drive(episode);
    if (episode.state().fault) { show_fault(program, episode.state(), streams); }
    if (!run.write_files(episode, random_words)) { return Exit::file; }
    (writes_to_pipe(arguments) ? streams.err : streams.out) << run.report(episode, random_words);
    return episode.state().fault ? Exit::no : Exit::yes;
}

const CLI::Validator trace_name(
    [](const std::string& path) {
        const bool known = path == "-" || path.ends_with(".csv") || path.ends_with(".jsonl");
        return known ? std::string()
                     : "a trace is written as FILE.csv or FILE.jsonl, not as \"" + path + "\"";
    },
    "", "trace_name");

void add_coverage_options(CLI::App& app, RunArguments& arguments) {
    app.add_flag_callback(
        "--coverage", [&arguments] { arguments.cell = arguments.cell.value_or(default_cell); },
        "report how much of the floor was covered, and when");
    app.add_option("--cell", arguments.cell,
                   "report coverage, on cells of so many metres; 0.05 if not given")
        ->type_name("M")
        ->check(CLI::Range(finest_cell, coarsest_cell));
}

}  // namespace

void add_options(CLI::App& app, RunArguments& arguments) {
    app.add_option("FILE", arguments.file, "the behaviour: a tree or machine file, or -")
        ->required();
    add_options(app, arguments.episode);
    app.add_option("--seed", arguments.episode.seeds,
                   "seed of the random numbers, as Python's random.seed(N); 0 if not given")
        ->type_name("N")
        ->expected(1)
        ->excludes("--draws");
    add_options(app, arguments.load);
    app.add_option("--trace", arguments.traces,
                   "write every tick to FILE.csv, or every event of the behaviour to FILE.jsonl; "
                   "may be given several times")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->check(trace_name);
    app.add_option("--svg", arguments.svg, "draw the robot's way into a file")->type_name("FILE");
    add_coverage_options(app, arguments);
    app.add_flag("--log", arguments.log, "print what <log> says, as \"label: value\"");
    app.add_flag("--stats", arguments.stats,
                 "report every node, state and transition, and which were never reached");
    add_option(app, arguments.world);
    add_format(app, arguments.format);
}

Exit execute(const RunArguments& arguments, Streams& streams) {
    RoombaRegistry registry;
    Exit exit = Exit::yes;
    const std::optional<Behaviour> behaviour =
        load_behaviour(arguments.file, arguments.load, registry, streams, exit);
    if (!behaviour) { return exit; }

    const EpisodeArguments& episode = arguments.episode;
    const std::int64_t seed = episode.seeds.empty() ? 0 : episode.seeds.back();
    std::optional<Random> random = Random(seed);
    std::string words = "seed " + std::to_string(seed);
    if (!episode.draws.empty()) {
        random = load_draws(episode.draws, streams, exit);
        words = "draws " + shown_name(episode.draws);
    }
    if (!random) { return exit; }
    return arguments.world.is_none()
               ? run_without_world(arguments, *behaviour->program, std::move(*random), streams)
               : run_in_world(arguments, *behaviour, std::move(*random), words, streams);
}

}  // namespace trellis
