// Lines to events.
// SPDX-License-Identifier: MIT
#include "runner/recording.h"

#include "runner/declarations.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace trellis {

namespace {

using Json = nlohmann::json;
using Kind = TraceEvent::Kind;

std::optional<Status> status_named(std::string_view name) {
    for (const Status status :
         {Status::idle, Status::running, Status::success, Status::failure, Status::skipped}) {
        if (name_of(status) == name) { return status; }
    }
    return {};
}

std::optional<Kind> kind_named(std::string_view name) {
    for (std::uint8_t i = 0; i <= static_cast<std::uint8_t>(Kind::error); ++i) {
        if (name_of(static_cast<Kind>(i)) == name) { return static_cast<Kind>(i); }
    }
    return {};
}

/// The lines of one file, one after the other.
class Reader {
public:
    Reader(std::uint32_t file, Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

    std::optional<Recording> read(std::string_view text);

private:
    bool read_line(std::string_view line);
    bool read_run();
    bool read_event(std::string_view event, std::uint64_t tick);
    bool fail(std::string_view message) {
        diagnostics_.error("bad-trace", {file_, line_, 1}, std::string(message));
        return false;
    }

    /// Members of the line being read; none, after an error, if missing or of another type.
    std::optional<std::uint64_t> number(const char* key);
    std::optional<std::string> text(const char* key);
    std::optional<Status> status(const char* key);

    std::uint32_t file_;
    Diagnostics& diagnostics_;
    std::uint32_t line_ = 0;
    Json json_;
    Recording recording_;
};

std::optional<Recording> Reader::read(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        ++line_;
        if (!read_line(text.substr(0, end))) { return {}; }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (line_ == 0) {
        line_ = 1;
        fail("expected a trace of events, as trellis run --trace FILE.jsonl writes it");
        return {};
    }
    return std::move(recording_);
}

bool Reader::read_line(std::string_view line) {
    json_ = Json::parse(line, nullptr, false);
    if (!json_.is_object()) { return fail("expected a JSON object"); }
    const std::optional<std::string> event = text("event");
    if (!event) { return false; }
    if (line_ == 1) {
        return *event == "run" ? read_run()
                               : fail("expected a first line that says which run it was, with "
                                      "\"event\": \"run\"");
    }
    const std::optional<std::uint64_t> tick = number("tick");
    if (!tick) { return false; }
    if (*tick < recording_.ticks) { return fail("ticks must not decrease"); }
    recording_.ticks = *tick;
    return *event == "end" || read_event(*event, *tick);
}

bool Reader::read_run() {
    const auto file = text("file");
    const auto name = text("name");
    const auto rows = number("rows");
    if (!file || !name || !rows) { return false; }
    if (*rows == 0 || *rows > LoadOptions().rows) { return fail("no program has so many rows"); }
    const auto dt = json_.find("dt");
    if (dt == json_.end() || !dt->is_number() || dt->get<double>() <= 0.0) {
        return fail("expected a positive number \"dt\"");
    }
    recording_.file = *file;
    if (json_.contains("tree")) {
        const auto tree = text("tree");
        if (!tree) { return false; }
        recording_.tree = *tree;
    }
    recording_.rows = static_cast<std::uint32_t>(*rows);
    recording_.dt = dt->get<double>();
    recording_.names.resize(recording_.rows);
    recording_.names[0] = *name;
    return true;
}

bool Reader::read_event(std::string_view event, std::uint64_t tick) {
    const std::optional<Kind> kind = kind_named(event);
    if (!kind) { return fail("there is no event \"" + std::string(event) + '"'); }
    const auto row = number("row");
    const auto name = text("name");
    if (!row || !name) { return false; }
    if (*row >= recording_.rows) { return fail("there is no row " + std::to_string(*row)); }
    TraceEvent read{.tick = tick, .kind = *kind, .row = {static_cast<std::uint32_t>(*row)}};
    recording_.names[read.row.index] = *name;
    switch (read.kind) {
    case Kind::status: {
        const auto from = status("from");
        const auto to = status("to");
        if (!from || !to) { return false; }
        read.from = *from;
        read.to = *to;
        break;
    }
    case Kind::tick: {
        const auto to = status("status");
        if (!to) { return false; }
        read.to = *to;
        break;
    }
    case Kind::transition: {
        const auto index = number("index");
        if (!index) { return false; }
        read.transition = {static_cast<std::uint32_t>(*index)};
        break;
    }
    case Kind::enter:
    case Kind::leave: {
        TraceEvent stored = read;
        stored.kind = Kind::status;
        (read.kind == Kind::enter ? stored.to : stored.from) = Status::running;
        recording_.events.push_back(stored);
        break;
    }
    case Kind::log:
    case Kind::error: {
        const auto words = text("text");
        if (!words) { return false; }
        read.text = recording_.texts.emplace_back(*words);
        break;
    }
    case Kind::halt:
    case Kind::skip:
    case Kind::event: break;
    }
    recording_.events.push_back(read);
    return true;
}

std::optional<std::uint64_t> Reader::number(const char* key) {
    const auto at = json_.find(key);
    if (at != json_.end() && at->is_number_unsigned()) { return at->get<std::uint64_t>(); }
    fail("expected a whole number \"" + std::string(key) + '"');
    return {};
}

std::optional<std::string> Reader::text(const char* key) {
    const auto at = json_.find(key);
    if (at != json_.end() && at->is_string()) { return at->get<std::string>(); }
    fail("expected a text \"" + std::string(key) + '"');
    return {};
}

std::optional<Status> Reader::status(const char* key) {
    const auto word = text(key);
    if (!word) { return {}; }
    const auto status = status_named(*word);
    if (!status) { fail("there is no status \"" + *word + '"'); }
    return status;
}

}  // namespace

std::optional<Recording> read_recording(const std::string& name, std::string_view text,
                                        Diagnostics& diagnostics) {
    return Reader(diagnostics.add_file(name, text), diagnostics).read(text);
}

std::string mismatch(const Recording& recording, const Program& program) {
    if (recording.rows != program.rows.size()) {
        return "it has " + std::to_string(recording.rows) + " rows, the behaviour " +
               std::to_string(program.rows.size());
    }
    for (std::uint32_t i = 0; i < recording.rows; ++i) {
        const std::string& name = recording.names[i];
        if (!name.empty() && name != program.names[i]) {
            return "its row " + std::to_string(i) + " is called \"" + name +
                   "\", that of the behaviour \"" + program.names[i] + '"';
        }
    }
    for (const TraceEvent& event : recording.events) {
        if (event.kind == Kind::transition &&
            event.transition.index >= program.transitions.size()) {
            return "it takes transition " + std::to_string(event.transition.index) +
                   ", which the behaviour does not have";
        }
    }
    return {};
}

std::optional<Recording> load_recording(const std::string& file, Streams& streams, Exit& exit) {
    exit = Exit::file;
    const std::optional<std::string> text = read_text(file, streams);
    if (!text) { return {}; }
    Diagnostics diagnostics;
    std::optional<Recording> recording = read_recording(shown_name(file), *text, diagnostics);
    show(diagnostics, streams);
    if (recording) { exit = Exit::yes; }
    return recording;
}

std::optional<Behaviour> load_recorded(const std::string& file, LoadArguments arguments,
                                       const Recording& recording, Registry& registry,
                                       Streams& streams, Exit& exit) {
    if (arguments.main_tree.empty()) { arguments.main_tree = recording.tree; }
    std::optional<Behaviour> behaviour = load_declaring(file, arguments, registry, streams, exit);
    if (!behaviour) { return {}; }
    const std::string why = mismatch(recording, *behaviour->program);
    if (why.empty()) { return behaviour; }
    exit = complain(streams, Exit::no,
                    "the trace was not recorded from " + behaviour->name + ": " + why);
    return {};
}

}  // namespace trellis
