// The same facts twice: rounded for people, in full for programs.
// SPDX-License-Identifier: MIT
#include "runner/run_report.h"

#include "runner/episode_arguments.h"
#include "runner/json_writer.h"
#include "runner/table.h"

#include <utility>

namespace trellis {

namespace {

std::string_view kind_of(const RunReport& report) {
    return report.episode.program().is_machine() ? "machine" : "tree";
}

/// Of the ticks done, from 0 to 1.
double share(const RunReport& report, std::size_t label) {
    const std::uint64_t ticks = report.episode.state().tick;
    if (ticks == 0) { return 0.0; }
    return static_cast<double>(report.tally.ticks[label]) / static_cast<double>(ticks);
}

double seconds(const RunReport& report, std::size_t label) {
    return static_cast<double>(report.tally.ticks[label]) * report.episode.setup().dt;
}

std::string pose_text(double x, double y, double rotation) {
    return "x " + fixed(x, 3) + " m, y " + fixed(y, 3) + " m, rotation " + fixed(rotation, 3) +
           " rad";
}

std::string counted(std::uint64_t n, std::string_view singular, std::string_view plural) {
    return std::to_string(n) + ' ' + std::string(n == 1 ? singular : plural);
}

/// One line, its first word in a column of its own.
std::string fact(std::string_view word, std::string_view text) {
    std::string line(word);
    line.resize(10, ' ');
    return line + std::string(text) + '\n';
}

void add_pose(JsonWriter& json, std::string_view key, double x, double y, double rotation) {
    json.begin_object(key).number("x", x).number("y", y).number("rotation", rotation).end_object();
}

std::string table(const RunReport& report) {
    std::vector<std::vector<std::string>> rows{
        {report.episode.program().is_machine() ? "state" : "leaf", "entered", "time", "share"}};
    for (std::size_t i = 0; i < report.labels.names().size(); ++i) {
        rows.push_back({report.labels.names()[i], std::to_string(report.tally.entered[i]),
                        fixed(seconds(report, i), 3) + " s",
                        fixed(100.0 * share(report, i), 1) + " %"});
    }
    return aligned(rows);
}

}  // namespace

std::string ending(const Episode& episode) {
    if (episode.state().fault) { return "fault"; }
    if (episode.is_over()) {
        return "final: " + std::string(episode.program().name(episode.state().session.final));
    }
    return "time is up";
}

std::string report_text(const RunReport& report) {
    const Episode& episode = report.episode;
    const Pose start = start_of(episode.setup());
    const Roomba& robot = episode.robot();
    const EpisodeRow row = episode.row();
    std::string out;
    out += fact("file", std::string(report.file) + " (" + std::string(kind_of(report)) + ')');
    out += fact("time", fixed(row.time, 3) + " s, " + counted(row.tick, "tick", "ticks") + " of " +
                            describe_dt(episode.setup().dt));
    out += fact("random", report.random);
    out += fact("start", pose_text(start.x, start.y, start.rotation));
    out += fact("end", pose_text(robot.x, robot.y, robot.rotation));
    out += fact("driven", fixed(report.tally.driven.distance, 3) + " m, " +
                              counted(report.tally.driven.bumps, "bump", "bumps"));
    if (!episode.program().is_machine()) {
        out += fact("root", "succeeded " + counted(report.tally.successes, "time", "times") +
                                ", failed " + counted(report.tally.failures, "time", "times"));
    }
    out += fact("ended", ending(episode));
    if (report.profile != nullptr) {
        out += '\n' + profile_text(*report.profile);
    } else if (!report.labels.names().empty()) {
        out += '\n' + table(report);
    }
    if (report.coverage) { out += '\n' + coverage_text(*report.coverage); }
    return out;
}

std::string report_json(const RunReport& report) {
    const Episode& episode = report.episode;
    const Pose start = start_of(episode.setup());
    const Roomba& robot = episode.robot();
    const EpisodeRow row = episode.row();
    JsonWriter json;
    json.begin_object().text("file", report.file).text("kind", kind_of(report));
    json.count("ticks", row.tick).number("dt", episode.setup().dt).number("time", row.time);
    json.text("random", report.random);
    add_pose(json, "start", start.x, start.y, start.rotation);
    add_pose(json, "end", robot.x, robot.y, robot.rotation);
    json.number("distance", report.tally.driven.distance).count("bumps", report.tally.driven.bumps);
    if (!episode.program().is_machine()) {
        json.count("successes", report.tally.successes).count("failures", report.tally.failures);
    }
    json.text("ended", ending(episode));
    json.begin_array(episode.program().is_machine() ? "states" : "leaves");
    for (std::size_t i = 0; i < report.labels.names().size(); ++i) {
        json.begin_object().text("name", report.labels.names()[i]);
        json.count("entered", report.tally.entered[i]).count("ticks", report.tally.ticks[i]);
        json.number("time", seconds(report, i)).number("share", share(report, i)).end_object();
    }
    json.end_array();
    if (report.profile != nullptr) { add_profile(json, *report.profile); }
    if (report.coverage) { add_coverage(json, *report.coverage); }
    if (!report.log.empty()) {
        json.begin_array("log");
        for (const std::string& line : report.log) {
            json.element(line);
        }
        json.end_array();
    }
    return std::move(json.end_object()).finish();
}

}  // namespace trellis
