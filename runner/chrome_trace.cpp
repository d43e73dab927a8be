// Intervals on tracks.
// SPDX-License-Identifier: MIT
#include "runner/chrome_trace.h"

#include "runner/json_writer.h"
#include "runner/profile_report.h"
#include "runner/row_statuses.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

namespace {

using Kind = TraceEvent::Kind;
using Track = Id<struct TrackTag>;

class Writer {
public:
    Writer(const Recording& recording, const Program& program, double start)
        : recording_(recording), program_(program), start_(start), track_of_(program.rows.size()) {}

    std::string write();

private:
    void add(const TraceEvent& event);
    void add_status(const TraceEvent& event);
    void add_instant(RowId row, const std::string& name, std::string_view category);
    void begin(RowId row);
    void end(RowId row, std::string_view result);
    void add_one_tick(RowId row, Status result);
    Track track_for(RowId row);
    void open(std::string_view phase, std::string_view name, Track track);
    double now();
    std::string words_of(const TraceEvent& transition) const;

    const Recording& recording_;
    const Program& program_;
    double start_;
    JsonWriter json_;
    std::vector<Track> track_of_;             // by row; none while it does not run
    std::vector<std::vector<RowId>> tracks_;  // what runs on each, innermost last
    RowId told_;                              // row whose result its tick event has told
    std::uint64_t tick_ = 0;
    double in_tick_ = 0.0;  // microseconds used up in this tick
    double step_ = 1.0;     // microseconds between events of this tick
};

// One microsecond apart, or less if the tick has more events than that.
double Writer::now() {
    const double begin = (start_ + static_cast<double>(tick_) * recording_.dt) * 1e6;
    const double time = begin + in_tick_;
    in_tick_ += step_;
    return time;
}

void Writer::open(std::string_view phase, std::string_view name, Track track) {
    json_.begin_object().text("ph", phase).text("name", name).number("ts", now());
    json_.count("pid", 1).count("tid", track.index + 1);
}

// The track of what it runs in, if nothing else runs in that; else the first that is free.
Track Writer::track_for(RowId row) {
    const RowId parent = program_.at(row).parent;
    if (parent && track_of_[parent.index]) {
        const Track track = track_of_[parent.index];
        if (tracks_[track.index].back() == parent) { return track; }
    }
    const auto free = std::find_if(tracks_.begin(), tracks_.end(),
                                   [](const std::vector<RowId>& rows) { return rows.empty(); });
    const Track track{static_cast<std::uint32_t>(free - tracks_.begin())};
    if (free == tracks_.end()) { tracks_.emplace_back(); }
    return track;
}

void Writer::begin(RowId row) {
    if (track_of_[row.index]) { return; }
    const Track track = track_for(row);
    track_of_[row.index] = track;
    tracks_[track.index].push_back(row);
    open("B", program_.name(row), track);
    json_.text("cat", kind_of(program_, row)).end_object();
}

void Writer::end(RowId row, std::string_view result) {
    const Track track = track_of_[row.index];
    if (!track) { return; }
    std::vector<RowId>& running = tracks_[track.index];
    // what still runs inside ends with it
    while (running.back() != row) {
        end(RowId(running.back()), "");
    }
    running.pop_back();
    track_of_[row.index] = {};
    open("E", program_.name(row), track);
    if (!result.empty()) { json_.begin_object("args").text("result", result).end_object(); }
    json_.end_object();
}

void Writer::add_one_tick(RowId row, Status result) {
    begin(row);
    end(row, name_of(result));
}

void Writer::add_instant(RowId row, const std::string& name, std::string_view category) {
    RowId around = row;
    while (around && !track_of_[around.index]) {
        around = program_.at(around).parent;
    }
    open("i", name, around ? track_of_[around.index] : Track{0});
    json_.text("cat", category).text("s", "t").end_object();
}

void Writer::add_status(const TraceEvent& event) {
    if (event.to == Status::running) { return begin(event.row); }
    if (event.from == Status::running) {
        if (is_end(program_, event.row)) { return; }
        return end(event.row, is_done(event.to) ? name_of(event.to) : "HALTED");
    }
    // forced by a pre-condition; what a leaf returned has been told
    if (is_done(event.to) && told_ != event.row) { add_one_tick(event.row, event.to); }
}

std::string Writer::words_of(const TraceEvent& event) const {
    const Transition& transition = program_.transitions[event.transition.index];
    std::string words(program_.name(transition.source));
    for (std::uint32_t i = 0; i < transition.target_count; ++i) {
        words += i == 0 ? " → " : ", ";
        words += program_.name(program_.targets[transition.first_target + i]);
    }
    return words;
}

void Writer::add(const TraceEvent& event) {
    const std::string name(program_.name(event.row));
    switch (event.kind) {
    case Kind::status: add_status(event); break;
    case Kind::tick:
        if (is_done(event.to) && !track_of_[event.row.index]) {
            add_one_tick(event.row, event.to);
            told_ = event.row;
            return;
        }
        break;
    case Kind::skip: add_instant(event.row, name + " skipped", "skip"); break;
    case Kind::transition: add_instant(event.row, words_of(event), "transition"); break;
    case Kind::log:
    case Kind::error: add_instant(event.row, std::string(event.text), name_of(event.kind)); break;
    case Kind::halt:
    case Kind::enter:
    case Kind::leave:
    case Kind::event: break;
    }
    told_ = {};
}

std::string Writer::write() {
    json_.begin_object().text("displayTimeUnit", "ms").begin_array("traceEvents");
    json_.begin_object().text("ph", "M").text("name", "process_name").count("pid", 1);
    json_.begin_object("args").text("name", recording_.file).end_object().end_object();
    const auto& events = recording_.events;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (i == 0 || events[i].tick != tick_) {
            tick_ = events[i].tick;
            in_tick_ = 0.0;
            std::size_t last = i;
            while (last < events.size() && events[last].tick == tick_) {
                ++last;
            }
            // each event writes at most two
            const double most = 2.0 * static_cast<double>(last - i);
            step_ = std::min(1.0, recording_.dt * 1e6 / (most + 1.0));
        }
        add(events[i]);
    }
    // what runs at the end ends one tick later, when its last tick is over
    tick_ = recording_.ticks + 1;
    in_tick_ = 0.0;
    for (std::uint32_t i = static_cast<std::uint32_t>(track_of_.size()); i-- > 0;) {
        end({i}, "");
    }
    return std::move(json_.end_array().end_object()).finish();
}

}  // namespace

std::string chrome_trace(const Recording& recording, const Program& program, double start) {
    return Writer(recording, program, start).write();
}

}  // namespace trellis
