// Lines of a journal.
// SPDX-License-Identifier: MIT
#include "runner/sweep/journal.h"

#include <utility>

namespace trellis {

std::string journal_header(const SweepPlan& plan) {
    return "trellis sweep 1, " + std::to_string(plan.run_count()) + " runs of " +
           std::to_string(plan.fingerprint()) + '\n';
}

JournalContent read_journal(std::string_view text, const SweepPlan& plan) {
    JournalContent content;
    const std::string header = journal_header(plan);
    content.is_of_plan = text.starts_with(header);
    if (!content.is_of_plan) return content;
    content.whole = header.size();
    while (content.whole < text.size()) {
        const std::size_t end = text.find('\n', content.whole);
        if (end == std::string_view::npos) break;
        std::optional<NumberedRun> run =
            read_record(text.substr(content.whole, end - content.whole), plan.measuring());
        if (!run || run->first >= plan.run_count()) break;
        content.runs.push_back(std::move(*run));
        content.whole = end + 1;
    }
    return content;
}

std::unique_ptr<Journal> Journal::open(const std::string& path, const SweepPlan& plan, bool resume,
                                       Results& results, Streams& streams, Exit& exit) {
    exit = Exit::file;
    const auto fail = [&](const std::string& why) {
        complain(streams, exit, "cannot write \"" + path + "\": " + why);
        return nullptr;
    };
    std::string why;
    std::unique_ptr<GrowingFile> file = streams.files.grow(path, why);
    if (!file) return fail(why);
    const std::optional<std::string> text = streams.files.read(path, std::string::npos, why);
    if (!text) return fail(why);
    // one that was killed before its first line was whole has nothing to go on from
    const bool begun = text->find('\n') != std::string::npos;
    if (begun && !resume) {
        exit = Exit::usage;
        complain(streams, exit,
                 "\"" + path +
                     "\" has the runs of a sweep that was not finished: go on with "
                     "--resume, or remove it");
        return nullptr;
    }
    JournalContent content = read_journal(*text, plan);
    if (begun && !content.is_of_plan) {
        exit = Exit::no;
        complain(streams, exit,
                 "\"" + path +
                     "\" is of another sweep: its file, a behaviour or a world has "
                     "changed since; remove it to begin anew");
        return nullptr;
    }
    if (!file->cut(content.whole)) return fail(file->why());
    if (!begun && !file->append(journal_header(plan))) return fail(file->why());
    for (auto& [number, run] : content.runs)
        results[number] = std::move(run);
    exit = Exit::yes;
    return std::unique_ptr<Journal>(new Journal(path, std::move(file)));
}

bool Journal::add(std::uint64_t number, const MeasuredRun& run) {
    return file_->append(record_of(number, run));
}

}  // namespace trellis
