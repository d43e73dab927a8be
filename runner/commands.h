// The commands of the program, each as its arguments, the options that fill them in, and a function
// that runs it with given streams. The table of commands is in command_line.cpp. Each command has
// its own source file and test of the same name.
// SPDX-License-Identifier: MIT
#pragma once

#include "runner/behaviour.h"
#include "runner/episode_arguments.h"
#include "runner/streams.h"
#include "runner/world_argument.h"

#include <cstdint>
#include <optional>
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
    bool stats = false;
    std::optional<double> cell;  ///< m, of the coverage that is reported; none: not reported
    WorldArgument world;         ///< none: no robot; prints "final: ID"
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

/// trellis compare: two behaviours in the same world with the same random numbers.
struct CompareArguments {
    std::string a, b;
    LoadArguments load;
    EpisodeArguments episode;
    std::int64_t seed_count = 0;  ///< --seeds: 0 to N - 1; 0: not given
    Format format = Format::text;
};
void add_options(CLI::App& app, CompareArguments& arguments);
/// Yes if no pair of runs differs.
Exit execute(const CompareArguments& arguments, Streams& streams);

/// trellis convert: between the spellings of a document.
struct ConvertArguments {
    std::string in;
    std::string out;
    std::optional<Document::Spelling> to;  ///< none: by the name of `out`
};
void add_options(CLI::App& app, ConvertArguments& arguments);
/// Yes if `out` was written and says the same as `in`; else it is as it was.
Exit execute(const ConvertArguments& arguments, Streams& streams);

/// trellis show: pictures of a behaviour file.
struct ShowArguments {
    std::string file;
    std::string svg, dot;  ///< files to write; empty: none
    bool text = false;     ///< on standard output, as if neither is given
    bool ascii = false;
    bool sideways = false;
    bool program = false;               ///< the compiled program instead of a picture
    std::string trace;                  ///< a recorded run, whose statuses are shown; empty: none
    std::optional<std::uint64_t> tick;  ///< of the trace; none: its last
    bool coverage = false;              ///< what the run never reached, instead of statuses
    LoadArguments load;
};
void add_options(CLI::App& app, ShowArguments& arguments);
Exit execute(const ShowArguments& arguments, Streams& streams);

/// trellis nodes: what behaviour files can name.
struct NodesArguments {
    enum class Spelling : std::uint8_t { text, json, xml };
    Spelling format = Spelling::text;
};
void add_options(CLI::App& app, NodesArguments& arguments);
Exit execute(const NodesArguments& arguments, Streams& streams);

/// trellis schema: the grammars as schemas.
struct SchemaArguments {
    std::string name;  ///< "tree-xsd", "machine-xsd", "tree-json", "world-json", …
};
void add_options(CLI::App& app, SchemaArguments& arguments);
Exit execute(const SchemaArguments& arguments, Streams& streams);

/// trellis try: a behaviour stepped by commands from standard input.
struct TryArguments {
    std::string file;
    std::vector<std::string> outcomes;  ///< --outcomes NAME=SFRK
    bool no_world = false;              ///< --world none
    std::int64_t seed = 0;
    bool ascii = false;
    LoadArguments load;
};
void add_options(CLI::App& app, TryArguments& arguments);
/// Yes; no if the file is invalid, and, unless someone types, if a command made no sense or a tick
/// failed.
Exit execute(const TryArguments& arguments, Streams& streams);

/// trellis fmt: lays files out evenly.
struct FmtArguments {
    std::vector<std::string> files;
    bool check = false;  ///< writes nothing
};
void add_options(CLI::App& app, FmtArguments& arguments);
/// Yes; with `check` no if a file is not laid out so.
Exit execute(const FmtArguments& arguments, Streams& streams);

/// trellis trace diff: whether two recorded runs are the same.
struct TraceDiffArguments {
    std::string a, b;
    double tolerance = 1e-9;
    Format format = Format::text;
};
void add_options(CLI::App& app, TraceDiffArguments& arguments);
/// Yes if they are the same; file if one cannot be read as a trace.
Exit execute(const TraceDiffArguments& arguments, Streams& streams);

/// trellis trace convert: a recorded run in the formats of other viewers.
struct TraceConvertArguments {
    enum class To : std::uint8_t { chrome, btlog };
    std::string in, out;
    std::optional<To> to;   ///< none: by the name of `out`
    std::string behaviour;  ///< empty: the file that the trace names
    double start = 0.0;     ///< s, since 1970
    LoadArguments load;
};
void add_options(CLI::App& app, TraceConvertArguments& arguments);
/// Yes if `out` was written; file if `in` cannot be read as a trace of events.
Exit execute(const TraceConvertArguments& arguments, Streams& streams);

/// Where the results of a sweep go.
struct SweepOutput {
    std::string out;  ///< rows: FILE.csv, FILE.jsonl, "-" for standard output; empty: none
    Format format = Format::text;  ///< of the summary
    std::string report;            ///< a page with pictures; empty: none
};

/// trellis sweep: every run of a sweep file.
struct SweepArguments {
    std::string file;
    SweepOutput output;
    bool resume = false;
    unsigned jobs = 0;  ///< threads; 0: as many as the machine runs at once
    std::string shard;  ///< "i/n"; empty: what a Slurm job array says, else all
};
void add_options(CLI::App& app, SweepArguments& arguments);
/// Yes; no if a file is invalid or a behaviour failed; file if what is done cannot be written.
Exit execute(const SweepArguments& arguments, Streams& streams);

/// trellis sweep merge: the parts of a sweep put together.
struct SweepMergeArguments {
    std::string file;
    std::vector<std::string> parts;
    SweepOutput output;
};
void add_options(CLI::App& app, SweepMergeArguments& arguments);
/// As of sweep; no also if runs are missing.
Exit execute(const SweepMergeArguments& arguments, Streams& streams);

}  // namespace trellis
