// Rows first: a summary of rows that could not be written would hide that.
// SPDX-License-Identifier: MIT
#include "runner/sweep/results.h"

#include "runner/sweep/report.h"
#include "runner/sweep/rows.h"
#include "runner/sweep/summary_report.h"

#include <CLI/CLI.hpp>

#include <ostream>

namespace trellis {
namespace {

const CLI::Validator rows_name(
    [](const std::string& path) {
        const bool known = path == "-" || path.ends_with(".csv") || path.ends_with(".jsonl");
        return known ? std::string()
                     : "rows are written as FILE.csv or FILE.jsonl, not as \"" + path + "\"";
    },
    "", "rows_name");

bool write_rows(const SweepPlan& plan, const Results& results, const std::string& path,
                Streams& streams) {
    const std::unique_ptr<OutputFile> file = open_output(path, streams);
    if (!file) return false;
    const RowFormat format = path.ends_with(".jsonl") ? RowFormat::json_lines : RowFormat::csv;
    // a write that fails makes the commit fail as well
    file->write(rows_header(plan, format));
    for (std::uint64_t run = 0; run < results.size(); ++run)
        file->write(rows_of(plan, run, *results[run], format));
    return commit(*file, path, streams);
}

/// Says how many runs failed, and how the first one did; whether there are any.
bool show_faults(const SweepPlan& plan, const Results& results, Streams& streams) {
    std::size_t failed = 0;
    std::uint64_t first = 0;
    for (std::uint64_t run = results.size(); run-- > 0;) {
        if (results[run]->stops.back().ending != Ending::fault) continue;
        ++failed;
        first = run;
    }
    if (failed == 0) return false;
    streams.err << results[first]->message << '\n';
    complain(streams, Exit::no,
             std::to_string(failed) + (failed == 1 ? " run" : " runs") + " of " +
                 std::to_string(results.size()) + " failed; the first is that of " +
                 case_words(plan, plan.case_of(first)) + ", seed " +
                 std::to_string(plan.seed_of(first)));
    return true;
}

}  // namespace

void add_options(CLI::App& app, SweepOutput& output) {
    app.add_option("--out", output.out, "write the rows to FILE.csv or FILE.jsonl, or - for CSV")
        ->type_name("FILE")
        ->check(rows_name);
    app.add_option("--report", output.report,
                   "write a page with curves, a heat map and the best and worst runs")
        ->type_name("FILE.html");
    add_format(app, output.format);
}

Exit write_results(const SweepPlan& plan, const Results& results, const SweepOutput& output,
                   Streams& streams) {
    if (!output.out.empty() && !write_rows(plan, results, output.out, streams)) return Exit::file;
    if (!output.report.empty() && !write_text(output.report, sweep_report(plan, results), streams))
        return Exit::file;
    const SweepSummary summary = summarised(plan, results);
    (output.out == "-" ? streams.err : streams.out)
        << (output.format == Format::json ? summary_json(plan, summary)
                                          : summary_text(plan, summary));
    return show_faults(plan, results, streams) ? Exit::no : Exit::yes;
}

}  // namespace trellis
